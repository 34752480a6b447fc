<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- From <report lang><results/> (results.json as elements, lists of <item>) <css/> <figures/></report> to one
     page that needs nothing beside it. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform" xmlns:svg="http://www.w3.org/2000/svg"
                exclude-result-prefixes="svg">
<xsl:import href="page.xsl"/>
<xsl:include href="front.xsl"/>
<xsl:include href="verdict.xsl"/>
<xsl:include href="assessment.xsl"/>
<xsl:include href="scenarios.xsl"/>
<xsl:include href="summary.xsl"/>
<xsl:include href="tables.xsl"/>
<xsl:include href="interval.xsl"/>
<xsl:include href="criteria.xsl"/>
<xsl:include href="directions.xsl"/>
<xsl:include href="cavities.xsl"/>
<xsl:include href="unions.xsl"/>
<xsl:include href="inputs.xsl"/>
<xsl:include href="method.xsl"/>

<xsl:variable name="reference">
  <xsl:call-template name="given">
    <xsl:with-param name="x" select="($trees[1]/scenario/wind_height | $trees[1]/scenario[not(wind_height)]/reference_height)/value"/>
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
    <xsl:call-template name="job-head"/>
    <h1><xsl:call-template name="title"/></h1>
    <p class="sub">
      <xsl:for-each select="$trees[not(model/key = preceding-sibling::item/model/key)]">
        <xsl:if test="position() &gt; 1">
          <xsl:call-template name="say"><xsl:with-param name="id">list.more</xsl:with-param></xsl:call-template></xsl:if>
        <xsl:value-of select="model/name"/>
      </xsl:for-each>
      <xsl:if test="count($trees) = 1 and $trees/species/latin != ''"> – <i>
        <xsl:value-of select="$trees/species/latin"/></i></xsl:if>
      <xsl:text> – </xsl:text><xsl:value-of select="substring-before($r/provenance/date, 'T')"/>
      <xsl:text> – </xsl:text>
      <span class="program"><xsl:value-of select="concat($r/provenance/program, ' ', $r/provenance/version)"/></span>
    </p>
    <xsl:call-template name="job-block"/>
    <xsl:call-template name="status"/>
  </header>
</xsl:template>

<!-- What was computed: trees, wind, method, date. -->
<xsl:template name="run-block">
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
        <xsl:for-each select="$trees[1]/scenario"><xsl:call-template name="wind-notes"/></xsl:for-each>
        <xsl:if test="$trees[1]/scenario/gust_over_mean/value">
          <br/>
          <xsl:for-each select="$trees[1]/scenario"><xsl:call-template name="site-line"/></xsl:for-each>
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
        <xsl:value-of select="concat($r/provenance/program, ' ', $r/provenance/version)"/>
      </xsl:with-param>
    </xsl:call-template>
  </table>
</xsl:template>

<xsl:template name="drawn-winds">
  <xsl:call-template name="list">
    <xsl:with-param name="items" select="$trees[1]/winds/item[contains($shown, concat(' ', count(preceding-sibling::item) + 1,
      ' '))]/speed/value"/>
  </xsl:call-template>
</xsl:template>

<!-- Of the safety figure: where trees are lost, within the figure and beyond its curves. -->
<xsl:template name="safety-circles">
  <xsl:variable name="end"><xsl:call-template name="speed-end"/></xsl:variable>
  <xsl:variable name="lost" select="$trees/verdict[within_limits = 'true' and outcome = 'found' and
    criteria/item[governs = 'true']]"/>
  <xsl:if test="$lost/critical_speed/value &lt;= $end">
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say"><xsl:with-param name="id">f.safety.circles</xsl:with-param></xsl:call-template>
  </xsl:if>
  <xsl:for-each select="$lost[critical_speed/value &gt; $end]">
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
      <xsl:with-param name="id">
        <xsl:text>f.safety.beyond</xsl:text><xsl:if test="count($trees) &gt; 1">.of</xsl:if>
      </xsl:with-param>
      <xsl:with-param name="a" select="format-number(critical_speed/value, '0.0')"/>
      <xsl:with-param name="b"><xsl:for-each select=".."><xsl:call-template name="name"/></xsl:for-each></xsl:with-param>
    </xsl:call-template>
  </xsl:for-each>
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
          <xsl:if test="@name = 'stem' and count($trees) = 1">.one</xsl:if>
          <xsl:if test="@name = 'safety'">
            <xsl:choose>
              <xsl:when test="not($trees/winds/item/*[self::least_safety or self::loss_safety]/value != '')">.none</xsl:when>
              <xsl:when test="not($trees/verdict/criteria/item[governs = 'true'])">.old</xsl:when>
            </xsl:choose>
          </xsl:if>
        </xsl:with-param>
        <xsl:with-param name="a">
          <xsl:choose>
            <xsl:when test="@name = 'front'">
              <xsl:call-template name="given"><xsl:with-param name="x" select="$trees[1]/winds/item[status = 'ok' and
                contains($shown, concat(' ', count(preceding-sibling::item) + 1, ' '))][last()]/speed/value"/></xsl:call-template>
            </xsl:when>
            <xsl:otherwise><xsl:call-template name="drawn-winds"/></xsl:otherwise>
          </xsl:choose>
        </xsl:with-param>
      </xsl:call-template>
      <xsl:if test="$trees[1]/assessment/from/value != '' and contains(' front shapes stem tip safety ', concat(' ', @name, ' '))">
        <xsl:value-of select="$gap"/>
        <xsl:call-template name="say">
          <xsl:with-param name="id">f.from</xsl:with-param>
          <xsl:with-param name="a"><xsl:call-template name="compass">
            <xsl:with-param name="of" select="$trees[1]/assessment"/></xsl:call-template></xsl:with-param>
        </xsl:call-template>
      </xsl:if>
      <xsl:if test="@name = 'tip' and $trees/species/streamlining/reference_speed/value &gt; 0">
        <xsl:value-of select="$gap"/>
        <xsl:call-template name="say"><xsl:with-param name="id">f.tip.kink</xsl:with-param></xsl:call-template>
      </xsl:if>
      <xsl:if test="@name = 'front' and $trees[1]/winds/item[status = 'ok'][last()]/beyond_loss = 'true'">
        <xsl:value-of select="$gap"/>
        <xsl:call-template name="say"><xsl:with-param name="id">lv.beyond</xsl:with-param></xsl:call-template>
      </xsl:if>
      <xsl:if test="@name = 'safety'"><xsl:call-template name="safety-circles"/></xsl:if>
      <xsl:if test="@name = 'scenarios' and $trees/scenarios/item/word and $trees[1]/assessment/required != ''">
        <xsl:value-of select="$gap"/>
        <xsl:call-template name="say"><xsl:with-param name="id">f.scenarios.required</xsl:with-param></xsl:call-template>
      </xsl:if>
      <xsl:if test="@name = 'stem' and $trees/model/key = 'card'">
        <xsl:value-of select="$gap"/>
        <xsl:call-template name="say"><xsl:with-param name="id">t.crown.stem</xsl:with-param></xsl:call-template>
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

<!-- How sure the critical wind of each tree is. -->
<xsl:template name="intervals">
  <h3><xsl:call-template name="say"><xsl:with-param name="id">h.interval</xsl:with-param></xsl:call-template></h3>
  <xsl:for-each select="$trees/interval">
    <xsl:variable name="whose">
      <xsl:call-template name="name"><xsl:with-param name="tree" select=".."/></xsl:call-template></xsl:variable>
    <p><xsl:call-template name="iv-words"><xsl:with-param name="name" select="$whose"/></xsl:call-template></p>
    <xsl:call-template name="iv-safety"><xsl:with-param name="name" select="$whose"/></xsl:call-template>
    <xsl:call-template name="iv-tornado"><xsl:with-param name="name" select="$whose"/></xsl:call-template>
  </xsl:for-each>
  <p><xsl:call-template name="say"><xsl:with-param name="id">iv.note</xsl:with-param></xsl:call-template></p>
</xsl:template>

<!-- The lowest modes of each tree in still air. -->
<xsl:template name="modes-table">
  <table class="data">
    <xsl:call-template name="caption"><xsl:with-param name="id">t.modes</xsl:with-param></xsl:call-template>
    <thead><tr><xsl:call-template name="heads">
      <xsl:with-param name="of"
                      select="'c.wt.tree;md.c.mode;c.frequency:Hz;md.c.moves;md.c.turn.along:%;md.c.turn.across:%;c.damping:'"/>
    </xsl:call-template></tr></thead>
    <tbody>
      <xsl:for-each select="$trees[modes]">
        <xsl:variable name="name"><xsl:call-template name="name"/></xsl:variable>
        <xsl:for-each select="modes/item">
          <tr>
            <td><xsl:if test="position() = 1"><xsl:value-of select="$name"/></xsl:if></td>
            <td><xsl:value-of select="number"/></td>
            <xsl:call-template name="n"><xsl:with-param name="x" select="frequency"/></xsl:call-template>
            <td>
              <xsl:call-template name="term">
                <xsl:with-param name="id" select="concat('md.d.', direction)"/>
                  <xsl:with-param name="otherwise" select="direction"/>
              </xsl:call-template>
            </td>
            <xsl:call-template name="cell">
              <xsl:with-param name="x" select="100 * turn_along"/><xsl:with-param name="pattern">0.0</xsl:with-param>
            </xsl:call-template>
            <xsl:call-template name="cell">
              <xsl:with-param name="x" select="100 * turn_across"/><xsl:with-param name="pattern">0.0</xsl:with-param>
            </xsl:call-template>
            <xsl:call-template name="cell">
              <xsl:with-param name="x" select="damping"/><xsl:with-param name="pattern">0.000</xsl:with-param>
            </xsl:call-template>
          </tr>
        </xsl:for-each>
      </xsl:for-each>
    </tbody>
  </table>
</xsl:template>

<!-- Trees with rain on their leaves, or with snow and ice, beside the same trees without: "of" is "wetted" or "winter". -->
<xsl:template name="wetted-table">
  <xsl:param name="of"/>
  <xsl:variable name="all" select="$trees/*[name() = $of]"/>
  <table class="data">
    <xsl:call-template name="caption">
      <xsl:with-param name="id" select="concat('wt.caption.', $of)"/>
      <xsl:with-param name="a">
        <xsl:call-template name="given"><xsl:with-param name="x" select="$all[1]/speed_m_s"/></xsl:call-template>
      </xsl:with-param>
      <xsl:with-param name="b">
        <xsl:call-template name="given"><xsl:with-param name="x" select="$all[1]/film_mm"/></xsl:call-template>
      </xsl:with-param>
      <xsl:with-param name="c">
        <xsl:call-template name="given"><xsl:with-param name="x" select="$trees[1]/scenario/snow/value"/></xsl:call-template>
      </xsl:with-param>
      <xsl:with-param name="d">
        <xsl:call-template name="given">
          <xsl:with-param name="x" select="1000 * $trees[1]/scenario/ice/value"/></xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
    <thead><tr><xsl:call-template name="heads">
      <xsl:with-param name="of">c.wt.tree;c.wt.state;c.wt.mass:kg;c.wt.sway:Hz;c.wt.drag:kN;
        c.wt.moment:kN m;c.wt.tip:m;c.wt.critical:m/s;c.gust:m/s</xsl:with-param>
    </xsl:call-template></tr></thead>
    <tbody>
      <xsl:for-each select="$all">
        <xsl:variable name="w" select="."/>
        <xsl:variable name="name"><xsl:for-each select=".."><xsl:call-template name="name"/></xsl:for-each></xsl:variable>
        <xsl:for-each select="$w/frequencies_Hz/item">
          <xsl:variable name="k" select="position()"/>
          <tr>
            <td><xsl:if test="$k = 1"><xsl:value-of select="$name"/></xsl:if></td>
            <td>
                <xsl:call-template name="say">
                  <xsl:with-param name="id" select="concat('wt.state.', $of, '.', $k)"/></xsl:call-template>
              </td>
            <xsl:call-template name="n"><xsl:with-param name="x" select="($k = 2) * $w/mass_kg"/></xsl:call-template>
            <xsl:call-template name="cell">
              <xsl:with-param name="x" select="."/><xsl:with-param name="pattern">0.0000</xsl:with-param>
            </xsl:call-template>
            <xsl:call-template name="cell">
              <xsl:with-param name="x" select="$w/drags_N/item[$k] div 1000"/>
                <xsl:with-param name="pattern">0.000</xsl:with-param>
            </xsl:call-template>
            <xsl:call-template name="cell">
              <xsl:with-param name="x" select="$w/moments_N_m/item[$k] div 1000"/>
                <xsl:with-param name="pattern">0.000</xsl:with-param>
            </xsl:call-template>
            <xsl:call-template name="cell">
              <xsl:with-param name="x" select="$w/deflections_m/item[$k]"/><xsl:with-param name="pattern">0.000</xsl:with-param>
            </xsl:call-template>
            <xsl:call-template name="cell">
              <xsl:with-param name="x" select="$w/criticals_m_s/item[$k]"/><xsl:with-param name="pattern">0.00</xsl:with-param>
            </xsl:call-template>
            <td class="r">
                <xsl:call-template name="gust"><xsl:with-param name="x" select="$w/criticals_m_s/item[$k]"/></xsl:call-template>
              </td>
          </tr>
        </xsl:for-each>
      </xsl:for-each>
    </tbody>
  </table>
</xsl:template>

<xsl:template match="/report">
  <html lang="{$lang}">
    <head>
      <meta charset="UTF-8"/>
      <xsl:call-template name="policy"/>
      <meta name="viewport" content="width=device-width, initial-scale=1"/>
      <meta name="generator" content="{$r/provenance/program} {$r/provenance/version}"/>
      <title><xsl:call-template name="title"/></title><style><xsl:value-of select="css" disable-output-escaping="yes"/></style>
    </head>
    <body lang="{$lang}">
      <xsl:call-template name="title-block"/>
      <xsl:call-template name="front"/>
      <xsl:if test="script"><xsl:call-template name="live"/></xsl:if>
      <section class="annex">
        <xsl:call-template name="heading">
          <xsl:with-param name="n" select="1"/><xsl:with-param name="id">h.summary</xsl:with-param>
        </xsl:call-template>
        <xsl:call-template name="run-block"/>
        <xsl:call-template name="summary"/>
        <xsl:for-each select="$trees[assessment]"><xsl:call-template name="assessment"/></xsl:for-each>
      </section>
      <section>
        <xsl:call-template name="heading">
          <xsl:with-param name="n" select="2"/><xsl:with-param name="id">h.table</xsl:with-param>
        </xsl:call-template>
        <xsl:call-template name="result-tables"/>
        <xsl:call-template name="criteria-table"/>
        <xsl:for-each select="$trees"><xsl:call-template name="anchorage-note"/></xsl:for-each>
        <xsl:if test="$trees/interval"><xsl:call-template name="intervals"/></xsl:if>
        <xsl:if test="$trees/verdict/thicknesses/item"><xsl:call-template name="branch-table"/></xsl:if>
        <xsl:if test="$trees/unions"><xsl:call-template name="union-tables"/></xsl:if>
        <xsl:if test="$trees/cavities/item"><xsl:call-template name="cavity-tables"/></xsl:if>
        <xsl:if test="$trees/modes"><xsl:call-template name="modes-table"/></xsl:if>
        <xsl:call-template name="scenarios-tables"><xsl:with-param name="of" select="$trees[not(assessment)]"/></xsl:call-template>
        <xsl:if test="$trees/guys/item"><xsl:call-template name="guys-table"/></xsl:if>
        <xsl:if test="$trees/braces/item"><xsl:call-template name="braces-table"/></xsl:if>
        <xsl:if test="$trees/winter">
          <xsl:call-template name="wetted-table"><xsl:with-param name="of">winter</xsl:with-param></xsl:call-template>
        </xsl:if>
        <xsl:if test="$trees/wetted">
          <xsl:call-template name="wetted-table"><xsl:with-param name="of">wetted</xsl:with-param></xsl:call-template>
        </xsl:if>
        <xsl:if test="$trees[1]/directions/number">
          <xsl:call-template name="direction-table"><xsl:with-param name="n" select="3"/></xsl:call-template>
        </xsl:if>
      </section>
      <section>
        <xsl:call-template name="heading">
          <xsl:with-param name="n" select="3"/><xsl:with-param name="id">h.figures</xsl:with-param>
        </xsl:call-template>
        <xsl:apply-templates select="figures/figure[@name != $in-front]"/>
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
      <xsl:call-template name="live-script"/>
    </body>
  </html>
</xsl:template>
</xsl:stylesheet>
