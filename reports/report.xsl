<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- From <report lang><results/> (results.json as elements, lists of <item>) <css/> <figures/></report> to one
     page that needs nothing beside it. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform" xmlns:svg="http://www.w3.org/2000/svg"
                exclude-result-prefixes="svg">
<xsl:import href="page.xsl"/>
<xsl:include href="verdict.xsl"/>
<xsl:include href="summary.xsl"/>
<xsl:include href="tables.xsl"/>
<xsl:include href="criteria.xsl"/>
<xsl:include href="directions.xsl"/>
<xsl:include href="inputs.xsl"/>
<xsl:include href="method.xsl"/>

<xsl:variable name="reference">
  <xsl:call-template name="given">
    <xsl:with-param name="x" select="$trees[1]/scenario/reference_height/value"/>
  </xsl:call-template>
</xsl:variable>

<!-- "A, B, C" for the title; with last="list.last" "A, B and C" for a sentence -->
<xsl:template name="names">
  <xsl:param name="of" select="$trees"/><xsl:param name="last">list.more</xsl:param>
  <xsl:for-each select="$of">
    <xsl:if test="position() &gt; 1">
      <xsl:call-template name="say">
        <xsl:with-param name="id">
          <xsl:choose>
            <xsl:when test="position() = last()"><xsl:value-of select="$last"/></xsl:when>
            <xsl:otherwise>list.more</xsl:otherwise>
          </xsl:choose>
        </xsl:with-param>
      </xsl:call-template>
    </xsl:if>
    <xsl:call-template name="name"/>
  </xsl:for-each>
</xsl:template>

<xsl:template name="title">
  <xsl:choose>
    <xsl:when test="$r/title != ''"><xsl:value-of select="$r/title"/></xsl:when>
    <xsl:otherwise>
      <xsl:call-template name="say">
        <xsl:with-param name="id">
          <xsl:choose>
            <xsl:when test="count($trees) = 1">title.one</xsl:when><xsl:otherwise>title.more</xsl:otherwise>
          </xsl:choose>
        </xsl:with-param>
        <xsl:with-param name="a"><xsl:call-template name="names"/></xsl:with-param>
      </xsl:call-template>
    </xsl:otherwise>
  </xsl:choose>
</xsl:template>

<xsl:template name="winds-text">
  <xsl:choose>
    <xsl:when test="$winds &gt; 8">
      <xsl:call-template name="say">
        <xsl:with-param name="id">range</xsl:with-param>
        <xsl:with-param name="a">
          <xsl:call-template name="given">
            <xsl:with-param name="x" select="$trees[1]/winds/item[1]/speed/value"/>
          </xsl:call-template>
        </xsl:with-param>
        <xsl:with-param name="b">
          <xsl:call-template name="given">
            <xsl:with-param name="x" select="$trees[1]/winds/item[last()]/speed/value"/>
          </xsl:call-template>
        </xsl:with-param>
      </xsl:call-template>
    </xsl:when>
    <xsl:otherwise>
      <xsl:call-template name="list">
        <xsl:with-param name="items" select="$trees[1]/winds/item/speed/value"/>
      </xsl:call-template>
    </xsl:otherwise>
  </xsl:choose>
</xsl:template>

<xsl:template name="title-block">
  <header>
    <h1><xsl:call-template name="title"/></h1>
    <p class="sub"><xsl:call-template name="say"><xsl:with-param name="id">sub</xsl:with-param></xsl:call-template></p>
    <table class="block">
      <xsl:call-template name="block-row">
        <xsl:with-param name="id">tb.trees</xsl:with-param>
        <xsl:with-param name="text">
          <xsl:for-each select="$trees">
            <xsl:if test="position() &gt; 1"><br/></xsl:if>
            <xsl:call-template name="name"/>
            <xsl:if test="species/latin != ''"> – <i><xsl:value-of select="species/latin"/></i></xsl:if>
          </xsl:for-each>
        </xsl:with-param>
      </xsl:call-template>
      <xsl:call-template name="block-row">
        <xsl:with-param name="id">tb.model</xsl:with-param>
        <xsl:with-param name="text">
          <xsl:for-each select="$trees[not(model/key = preceding-sibling::item/model/key)]">
            <xsl:if test="position() &gt; 1"><br/></xsl:if><xsl:value-of select="model/name"/>
          </xsl:for-each>
        </xsl:with-param>
      </xsl:call-template>
      <xsl:call-template name="block-row">
        <xsl:with-param name="id">tb.wind</xsl:with-param>
        <xsl:with-param name="text">
          <xsl:call-template name="say">
            <xsl:with-param name="id">tb.wind.text</xsl:with-param>
            <xsl:with-param name="a"><xsl:call-template name="winds-text"/></xsl:with-param>
            <xsl:with-param name="b" select="$reference"/>
          </xsl:call-template>
          <xsl:if test="$trees[1]/scenario/winds_said != ''">
            <br/><xsl:value-of select="$trees[1]/scenario/winds_said"/>
          </xsl:if>
          <xsl:if test="$trees[1]/scenario/gust_over_mean/value">
            <br/>
            <xsl:for-each select="$trees[1]/scenario">
              <xsl:call-template name="say">
                <xsl:with-param name="id">tb.site</xsl:with-param>
                <xsl:with-param name="a">
                  <xsl:call-template name="number"><xsl:with-param name="x" select="gust_over_mean/value"/></xsl:call-template>
                </xsl:with-param>
                <xsl:with-param name="b">
                  <xsl:call-template name="given"><xsl:with-param name="x" select="wind_height/value"/></xsl:call-template>
                </xsl:with-param>
                <xsl:with-param name="c" select="wind_terrain"/><xsl:with-param name="d" select="terrain"/>
                <xsl:with-param name="e">
                  <xsl:call-template name="say">
                    <xsl:with-param name="id" select="concat('tb.site.', terrain_from)"/>
                  </xsl:call-template>
                  <xsl:if test="site_kind != ''">, <xsl:value-of select="site_kind"/></xsl:if>
                </xsl:with-param>
                <xsl:with-param name="f">
                  <xsl:call-template name="number">
                    <xsl:with-param name="x" select="carried/value * speed_up/value"/>
                  </xsl:call-template>
                </xsl:with-param>
              </xsl:call-template>
            </xsl:for-each>
          </xsl:if>
          <xsl:if test="$trees[1]/scenario/speed_up/value != 1">
            <br/>
            <xsl:call-template name="say">
              <xsl:with-param name="id">tb.exposure</xsl:with-param>
              <xsl:with-param name="a">
                <xsl:call-template name="number">
                  <xsl:with-param name="x" select="$trees[1]/scenario/speed_up/value"/>
                </xsl:call-template>
              </xsl:with-param>
            </xsl:call-template>
          </xsl:if>
        </xsl:with-param>
      </xsl:call-template>
      <xsl:call-template name="block-row">
        <xsl:with-param name="id">tb.method</xsl:with-param>
        <xsl:with-param name="text">
          <xsl:for-each select="$trees[1]/method/solver"><xsl:call-template name="solver-title"/></xsl:for-each>
        </xsl:with-param>
      </xsl:call-template>
      <xsl:call-template name="block-row">
        <xsl:with-param name="id">tb.date</xsl:with-param>
        <xsl:with-param name="text">
        <xsl:value-of select="translate($r/provenance/date, 'TZ', '  ')"/>UTC</xsl:with-param>
      </xsl:call-template>
      <xsl:call-template name="block-row">
        <xsl:with-param name="id">tb.program</xsl:with-param>
        <xsl:with-param name="text">
          <span class="program"><xsl:value-of select="concat($r/provenance/program, ' ', $r/provenance/version)"/></span>
        </xsl:with-param>
      </xsl:call-template>
    </table>
    <xsl:call-template name="status"/>
  </header>
</xsl:template>

<xsl:template name="drawn-winds">
  <xsl:call-template name="list">
    <xsl:with-param name="items" select="$trees[1]/winds/item[contains($shown, concat(' ', count(preceding-sibling::item) + 1,
      ' '))]/speed/value"/>
  </xsl:call-template>
</xsl:template>

<xsl:template match="figure">
  <figure id="{@name}">
    <xsl:choose>
      <xsl:when test="svg:svg">
        <xsl:apply-templates select="svg:svg" mode="picture"/>
      </xsl:when>
      <xsl:otherwise>
        <div class="missing">
          <xsl:call-template name="say">
            <xsl:with-param name="id">f.missing</xsl:with-param><xsl:with-param name="a" select="@missing"/>
          </xsl:call-template>
        </div>
      </xsl:otherwise>
    </xsl:choose>
    <figcaption>
      <b><xsl:call-template name="say"><xsl:with-param name="id">figure</xsl:with-param></xsl:call-template>&#160;<xsl:number/>
        </b>
      <xsl:call-template name="say"><xsl:with-param name="id">stop</xsl:with-param></xsl:call-template>
      <xsl:call-template name="say">
        <xsl:with-param name="id">
          <xsl:text>f.</xsl:text><xsl:value-of select="@name"/>
          <xsl:if test="@name = 'safety' and not($trees/winds/item/least_safety/value != '')">.none</xsl:if>
        </xsl:with-param>
        <xsl:with-param name="a"><xsl:call-template name="drawn-winds"/></xsl:with-param>
      </xsl:call-template>
      <xsl:if test="@name = 'safety' and $trees/critical[within_limits = 'true']/outcome = 'found'">
        <xsl:value-of select="$gap"/>
        <xsl:call-template name="say"><xsl:with-param name="id">f.safety.circles</xsl:with-param></xsl:call-template>
      </xsl:if>
      <xsl:if test="$gusts and contains(' shapes tip stem safety directions ', concat(' ', @name, ' '))">
        <xsl:value-of select="$gap"/>
        <xsl:call-template name="say"><xsl:with-param name="id">f.gusts</xsl:with-param></xsl:call-template>
      </xsl:if>
      <xsl:variable name="drawn" select="string-length(normalize-space($shown)) -
        string-length(translate(normalize-space($shown), ' ', '')) + 1"/>
      <xsl:if test="$drawn &lt; $winds and (@name = 'shapes' or @name = 'stem')">
        <xsl:value-of select="$gap"/>
        <xsl:call-template name="say">
          <xsl:with-param name="id">f.some</xsl:with-param><xsl:with-param name="a" select="$drawn"/>
          <xsl:with-param name="b" select="$winds"/>
        </xsl:call-template>
      </xsl:if>
    </figcaption>
  </figure>
</xsl:template>

<!-- Trees with rain on their leaves beside the same trees dry. -->
<xsl:template name="wetted-table">
  <table class="data">
    <xsl:call-template name="caption">
      <xsl:with-param name="id">wt.caption</xsl:with-param>
      <xsl:with-param name="a">
        <xsl:call-template name="given"><xsl:with-param name="x" select="$trees[wetted][1]/wetted/film_mm"/></xsl:call-template>
      </xsl:with-param>
      <xsl:with-param name="b">
        <xsl:call-template name="given"><xsl:with-param name="x" select="$trees[wetted][1]/wetted/speed_m_s"/></xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
    <thead><tr><xsl:call-template name="heads">
      <xsl:with-param name="of">c.wt.tree;c.wt.state;c.wt.water:kg;c.wt.sway:Hz;
        c.wt.moment:kN m;c.wt.tip:m;c.wt.critical:m/s</xsl:with-param>
    </xsl:call-template></tr></thead>
    <tbody>
      <xsl:for-each select="$trees[wetted]">
        <xsl:variable name="w" select="wetted"/>
        <xsl:variable name="name"><xsl:call-template name="name"/></xsl:variable>
        <xsl:for-each select="$w/frequencies_Hz/item">
          <xsl:variable name="k" select="position()"/>
          <tr>
            <td><xsl:if test="$k = 1"><xsl:value-of select="$name"/></xsl:if></td>
            <td><xsl:call-template name="say"><xsl:with-param name="id" select="concat('wt.state.', $k)"/></xsl:call-template></td>
            <xsl:call-template name="n"><xsl:with-param name="x" select="($k = 2) * $w/mass_kg"/></xsl:call-template>
            <xsl:call-template name="cell">
              <xsl:with-param name="x" select="."/><xsl:with-param name="pattern">0.0000</xsl:with-param>
            </xsl:call-template>
            <xsl:call-template name="cell">
              <xsl:with-param name="x" select="$w/moments_N_m/item[$k] div 1000"/><xsl:with-param name="pattern">0.000</xsl:with-param>
            </xsl:call-template>
            <xsl:call-template name="cell">
              <xsl:with-param name="x" select="$w/deflections_m/item[$k]"/><xsl:with-param name="pattern">0.000</xsl:with-param>
            </xsl:call-template>
            <xsl:call-template name="cell">
              <xsl:with-param name="x" select="$w/criticals_m_s/item[$k]"/><xsl:with-param name="pattern">0.00</xsl:with-param>
            </xsl:call-template>
          </tr>
        </xsl:for-each>
      </xsl:for-each>
    </tbody>
  </table>
</xsl:template>

<xsl:template match="/report">
  <html lang="{$lang}">
    <head>
      <meta charset="UTF-8"/><meta name="generator" content="{$r/provenance/program} {$r/provenance/version}"/>
      <title><xsl:call-template name="title"/></title><style><xsl:value-of select="css" disable-output-escaping="yes"/></style>
    </head>
    <body lang="{$lang}">
      <xsl:call-template name="title-block"/>
      <section>
        <xsl:call-template name="heading">
          <xsl:with-param name="n" select="1"/><xsl:with-param name="id">h.summary</xsl:with-param>
        </xsl:call-template>
        <xsl:call-template name="summary"/>
      </section>
      <section>
        <xsl:call-template name="heading">
          <xsl:with-param name="n" select="2"/><xsl:with-param name="id">h.table</xsl:with-param>
        </xsl:call-template>
        <xsl:call-template name="result-tables"/>
        <xsl:call-template name="criteria-table"/>
        <xsl:for-each select="$trees"><xsl:call-template name="anchorage-note"/></xsl:for-each>
        <xsl:if test="$trees/verdict/thicknesses/item"><xsl:call-template name="branch-table"/></xsl:if>
        <xsl:if test="$trees/wetted"><xsl:call-template name="wetted-table"/></xsl:if>
        <xsl:if test="$trees[1]/directions/number">
          <xsl:call-template name="direction-table"><xsl:with-param name="n" select="3"/></xsl:call-template>
        </xsl:if>
      </section>
      <section>
        <xsl:call-template name="heading">
          <xsl:with-param name="n" select="3"/><xsl:with-param name="id">h.figures</xsl:with-param>
        </xsl:call-template>
        <xsl:apply-templates select="figures/figure"/>
      </section>
      <section>
        <xsl:call-template name="heading">
          <xsl:with-param name="n" select="4"/><xsl:with-param name="id">h.inputs</xsl:with-param>
        </xsl:call-template>
        <xsl:call-template name="inputs"/>
      </section>
      <section>
        <xsl:call-template name="heading">
          <xsl:with-param name="n" select="5"/><xsl:with-param name="id">h.method</xsl:with-param>
        </xsl:call-template>
        <xsl:call-template name="method"/>
      </section>
      <section>
        <xsl:call-template name="heading">
          <xsl:with-param name="n" select="6"/><xsl:with-param name="id">h.warnings</xsl:with-param>
        </xsl:call-template>
        <xsl:call-template name="warnings"/>
      </section>
      <section>
        <xsl:call-template name="heading">
          <xsl:with-param name="n" select="7"/><xsl:with-param name="id">h.sources</xsl:with-param>
        </xsl:call-template>
        <xsl:call-template name="sources"/>
      </section>
      <section>
        <xsl:call-template name="heading">
          <xsl:with-param name="n" select="8"/><xsl:with-param name="id">h.provenance</xsl:with-param>
        </xsl:call-template>
        <xsl:call-template name="provenance"/>
      </section>
    </body>
  </html>
</xsl:template>
</xsl:stylesheet>
