<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- What all pages share. A page is made from <report lang><results/> (results.json as elements, lists of <item>) <css/>
     <figures/></report>. It imports this and gives the modes "title", "sub" and "body" of /report; the report of
     analyze and compare has a skeleton of its own. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform" xmlns:svg="http://www.w3.org/2000/svg"
                exclude-result-prefixes="svg">
<xsl:import href="words.xsl"/>
<xsl:output method="html" encoding="UTF-8" doctype-system="about:legacy-compat" indent="no"/>
<xsl:variable name="r" select="/report/results"/>

<!-- A heading with its number; sections are numbered as in the calls below. -->
<xsl:template name="heading">
  <xsl:param name="n"/><xsl:param name="id"/>
  <h2 id="s{$n}">
    <span class="n"><xsl:value-of select="$n"/></span>
    <xsl:call-template name="say"><xsl:with-param name="id" select="$id"/></xsl:call-template>
  </h2>
</xsl:template>

<xsl:template name="block-row">
  <xsl:param name="id"/><xsl:param name="text"/>
  <tr>
    <th><xsl:call-template name="say"><xsl:with-param name="id" select="$id"/></xsl:call-template></th>
    <td><xsl:copy-of select="$text"/></td>
  </tr>
</xsl:template>

<!-- the picture as it is, with words for those who cannot see it -->
<xsl:template match="svg:svg" mode="picture">
  <xsl:copy>
    <xsl:copy-of select="@*[name() != 'width' and name() != 'height']"/>
    <xsl:attribute name="role">img</xsl:attribute>
    <xsl:copy-of select="node()"/>
  </xsl:copy>
</xsl:template>

<!-- Words of a head: its lines end at zero-width spaces, and they and a short head do not break further (Chinese breaks after
     any character). -->
<xsl:template name="kept">
  <xsl:param name="text"/><xsl:param name="part" select="$lang = 'zh' and string-length($text) &lt;= 4"/>
  <xsl:choose>
    <xsl:when test="contains($text, '&#x200B;')">
      <span class="k"><xsl:value-of select="substring-before($text, '&#x200B;')"/></span>
      <br/>
      <xsl:call-template name="kept">
        <xsl:with-param name="text" select="substring-after($text, '&#x200B;')"/><xsl:with-param name="part" select="true()"/>
      </xsl:call-template>
    </xsl:when>
    <xsl:when test="$part"><span class="k"><xsl:value-of select="$text"/></span></xsl:when>
    <xsl:otherwise><xsl:value-of select="$text"/></xsl:otherwise>
  </xsl:choose>
</xsl:template>

<xsl:template name="head">
  <xsl:param name="id"/><xsl:param name="unit"/><xsl:param name="class" select="'r'"/>
  <th class="{$class}">
    <xsl:call-template name="kept">
      <xsl:with-param name="text">
        <xsl:call-template name="say"><xsl:with-param name="id" select="$id"/></xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
    <span class="u"><xsl:value-of select="$unit"/>&#160;</span>
  </th>
</xsl:template>

<xsl:template name="table-caption">
  <xsl:param name="n"/><xsl:param name="text"/>
  <caption>
    <b><xsl:call-template name="say"><xsl:with-param name="id">table</xsl:with-param>
      </xsl:call-template>&#160;<xsl:value-of select="$n"/></b>
    <xsl:call-template name="say"><xsl:with-param name="id">stop</xsl:with-param></xsl:call-template>
    <xsl:copy-of select="$text"/>
  </caption>
</xsl:template>

<xsl:template name="cell">
  <xsl:param name="x"/><xsl:param name="pattern" select="'0.0'"/><xsl:param name="bound"/>
  <td class="r">
    <xsl:call-template name="fixed">
      <xsl:with-param name="x" select="$x"/><xsl:with-param name="pattern" select="$pattern"/>
      <xsl:with-param name="bound" select="$bound"/>
    </xsl:call-template>
  </td>
</xsl:template>
<xsl:template name="steady-cell">
  <xsl:param name="x"/><xsl:param name="pattern" select="'0.0'"/>
  <td class="r">
    <xsl:call-template name="steady">
      <xsl:with-param name="x" select="$x"/><xsl:with-param name="pattern" select="$pattern"/>
    </xsl:call-template>
  </td>
</xsl:template>

<!-- Heads of a table: "id;id:unit;..." of strings. Those with a colon are columns of numbers. units="yes": a second
     line for the units. -->
<xsl:template name="heads">
  <xsl:param name="of"/><xsl:param name="units">yes</xsl:param>
  <xsl:variable name="one" select="normalize-space(substring-before(concat($of, ';'), ';'))"/>
  <xsl:variable name="id" select="substring-before(concat($one, ':'), ':')"/>
  <th>
    <xsl:if test="contains($one, ':')"><xsl:attribute name="class">r</xsl:attribute></xsl:if>
    <xsl:call-template name="kept">
      <xsl:with-param name="text">
        <xsl:call-template name="say"><xsl:with-param name="id" select="$id"/></xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
    <xsl:if test="$units = 'yes'"><span class="u"><xsl:value-of select="substring-after($one, ':')"/>&#160;</span></xsl:if>
  </th>
  <xsl:if test="contains($of, ';')">
    <xsl:call-template name="heads">
      <xsl:with-param name="of" select="substring-after($of, ';')"/><xsl:with-param name="units" select="$units"/>
    </xsl:call-template>
  </xsl:if>
</xsl:template>

<!-- A cell with about three significant digits, or as an integer. -->
<xsl:template name="n">
  <xsl:param name="x"/>
  <td class="r"><xsl:call-template name="number"><xsl:with-param name="x" select="$x"/></xsl:call-template></td>
</xsl:template>
<xsl:template name="count">
  <xsl:param name="x"/>
  <td class="r"><xsl:value-of select="$x"/></td>
</xsl:template>

<!-- A row "what | number unit" of a block. -->
<xsl:template name="fact">
  <xsl:param name="id"/><xsl:param name="x"/><xsl:param name="unit"/><xsl:param name="pattern"/>
  <xsl:call-template name="block-row">
    <xsl:with-param name="id" select="$id"/>
    <xsl:with-param name="text">
      <xsl:choose>
        <xsl:when test="$pattern != ''">
          <xsl:call-template name="fixed">
            <xsl:with-param name="x" select="$x"/><xsl:with-param name="pattern" select="$pattern"/>
          </xsl:call-template>
        </xsl:when>
        <xsl:otherwise>
          <xsl:call-template name="number"><xsl:with-param name="x" select="$x"/></xsl:call-template>
        </xsl:otherwise>
      </xsl:choose>
      <xsl:if test="$unit != ''"><xsl:value-of select="concat('&#160;', $unit)"/></xsl:if>
    </xsl:with-param>
  </xsl:call-template>
</xsl:template>

<xsl:template name="h2">
  <xsl:param name="id"/><xsl:param name="a"/>
  <h2>
    <xsl:call-template name="say">
      <xsl:with-param name="id" select="$id"/><xsl:with-param name="a" select="$a"/>
    </xsl:call-template>
  </h2>
</xsl:template>
<xsl:template name="caption">
  <xsl:param name="id"/><xsl:param name="a"/><xsl:param name="b"/><xsl:param name="c"/><xsl:param name="d"/>
  <caption><xsl:call-template name="say">
    <xsl:with-param name="id" select="$id"/><xsl:with-param name="a" select="$a"/><xsl:with-param name="b" select="$b"/>
      <xsl:with-param name="c" select="$c"/><xsl:with-param name="d" select="$d"/>
  </xsl:call-template></caption>
</xsl:template>

<!-- A figure by name with its caption, the string cap.NAME unless another is named. -->
<xsl:template name="figure">
  <xsl:param name="name"/><xsl:param name="id" select="concat('cap.', $name)"/>
  <xsl:param name="a"/><xsl:param name="b"/><xsl:param name="width">100%</xsl:param>
  <xsl:variable name="g" select="/report/figures/figure[@name = $name]"/>
  <xsl:if test="$g">
    <figure id="{$name}">
      <xsl:if test="$width != '100%'">
        <xsl:attribute name="style">
          <xsl:value-of
        select="concat('margin-left: auto; margin-right: auto; width: ', $width)"/>
        </xsl:attribute>
      </xsl:if>
      <xsl:choose>
        <xsl:when test="$g/svg:svg"><xsl:apply-templates select="$g/svg:svg" mode="picture"/></xsl:when>
        <xsl:otherwise>
          <div class="missing">
            <xsl:call-template name="say">
              <xsl:with-param name="id">f.missing</xsl:with-param><xsl:with-param name="a" select="$g/@missing"/>
            </xsl:call-template>
          </div>
        </xsl:otherwise>
      </xsl:choose>
      <figcaption>
        <b><xsl:call-template name="say"><xsl:with-param name="id">figure</xsl:with-param>
          </xsl:call-template>&#160;<xsl:value-of
          select="count($g/preceding-sibling::figure) + 1"/></b>
        <xsl:call-template name="say"><xsl:with-param name="id">stop</xsl:with-param></xsl:call-template>
        <xsl:call-template name="say">
          <xsl:with-param name="id" select="$id"/><xsl:with-param name="a" select="$a"/><xsl:with-param name="b" select="$b"/>
        </xsl:call-template>
      </figcaption>
    </figure>
  </xsl:if>
</xsl:template>

<!-- On the first page: what was not looked at, the string `id`, and how many warnings there are. -->
<xsl:template name="not-looked">
  <xsl:param name="id"/>
  <p class="care">
    <xsl:call-template name="say"><xsl:with-param name="id">nl</xsl:with-param></xsl:call-template>
    <xsl:call-template name="say"><xsl:with-param name="id">colon</xsl:with-param></xsl:call-template>
    <xsl:call-template name="say"><xsl:with-param name="id" select="$id"/></xsl:call-template>
    <xsl:if test="$r/warnings/item">
      <xsl:value-of select="$gap"/>
      <xsl:call-template name="say">
        <xsl:with-param name="id">nl.warnings<xsl:if test="count($r/warnings/item) = 1">.one</xsl:if></xsl:with-param>
        <xsl:with-param name="a" select="count($r/warnings/item)"/>
      </xsl:call-template>
    </xsl:if>
  </p>
</xsl:template>

<!-- Results that are not all that was ordered, or that nobody can check: said on top of the page. -->
<xsl:template name="status">
  <xsl:if test="$r/status = 'interrupted' or $r/status = 'unverified'">
    <p class="status">
      <xsl:call-template name="say"><xsl:with-param name="id" select="concat('status.', $r/status)"/></xsl:call-template>
    </p>
  </xsl:if>
</xsl:template>

<!-- Species and model of a page about one tree, in the language of the page. -->
<xsl:template name="whose">
  <xsl:value-of select="$r/name"/>
</xsl:template>

<!-- What a warning, which is the node, says. In results of earlier versions it has no parts, and no translation: in other languages
     than the program's first what its kind means. -->
<xsl:template name="warning">
  <xsl:variable name="means">
    <xsl:if test="not(message)">
      <xsl:call-template name="term"><xsl:with-param name="id" select="concat('means.', code)"/></xsl:call-template>
    </xsl:if>
  </xsl:variable>
  <xsl:choose>
    <xsl:when test="$means != ''">
      <xsl:value-of select="$means"/><span class="why"><xsl:value-of select="text"/></span>
    </xsl:when>
    <xsl:otherwise>
      <xsl:call-template name="fine">
        <xsl:with-param name="text">
          <xsl:call-template name="without-folders"><xsl:with-param name="text" select="text"/></xsl:call-template>
        </xsl:with-param>
      </xsl:call-template>
    </xsl:otherwise>
  </xsl:choose>
</xsl:template>

<!-- A message about a file, "FOLDERS/FILE: ...", names the file alone: a page is handed on. -->
<xsl:template name="without-folders">
  <xsl:param name="text"/>
  <xsl:variable name="colon">
    <xsl:call-template name="say"><xsl:with-param name="id">colon</xsl:with-param></xsl:call-template>
  </xsl:variable>
  <xsl:variable name="first" select="substring-before($text, $colon)"/>
  <xsl:choose>
    <xsl:when test="contains($first, '/') and not(contains($first, ' '))">
      <xsl:call-template name="base-name"><xsl:with-param name="path" select="$first"/></xsl:call-template>
      <xsl:value-of select="concat($colon, substring-after($text, $colon))"/>
    </xsl:when>
    <xsl:otherwise><xsl:value-of select="$text"/></xsl:otherwise>
  </xsl:choose>
</xsl:template>

<!-- Warnings of the run, each with its kind. -->
<xsl:template name="findings">
  <xsl:param name="id">h.warnings</xsl:param>
  <xsl:if test="$r/warnings/item">
    <xsl:call-template name="h2"><xsl:with-param name="id" select="$id"/></xsl:call-template>
    <ul class="findings">
      <xsl:for-each select="$r/warnings/item">
        <li>
          <b>
            <xsl:call-template name="term">
              <xsl:with-param name="id" select="concat('warn.', code)"/><xsl:with-param name="otherwise" select="code"/>
            </xsl:call-template>
          </b>
          <xsl:call-template name="say"><xsl:with-param name="id">colon</xsl:with-param></xsl:call-template>
          <xsl:call-template name="warning"/>
        </li>
      </xsl:for-each>
    </ul>
  </xsl:if>
</xsl:template>

<!-- How the winds of a scenario, which is the node, were named: a line each. Results of earlier versions have the words
     alone. -->
<xsl:template name="wind-notes">
  <xsl:if test="not(wind_notes/item) and winds_said != ''"><br/><xsl:value-of select="winds_said"/></xsl:if>
  <xsl:for-each select="wind_notes/item">
    <xsl:variable name="p" select="parts/item"/>
    <br/>
    <xsl:choose>
      <xsl:when test="kind = 'grade'">
        <xsl:call-template name="say">
          <xsl:with-param name="id">ws.grade</xsl:with-param>
          <xsl:with-param name="a">
            <xsl:call-template name="as-typed"><xsl:with-param name="text" select="$p[1]/text"/></xsl:call-template>
          </xsl:with-param>
          <xsl:with-param name="b">
            <xsl:call-template name="term">
              <xsl:with-param name="id" select="concat('grade.', $p[2]/text)"/><xsl:with-param name="otherwise" select="$p[2]/text"/>
            </xsl:call-template>
          </xsl:with-param>
          <xsl:with-param name="c">
            <xsl:call-template name="say">
              <xsl:with-param name="id">ws.<xsl:choose>
                <xsl:when test="$p[4]/text = ''">from</xsl:when><xsl:otherwise>between</xsl:otherwise>
              </xsl:choose></xsl:with-param>
              <xsl:with-param name="a" select="$p[3]/text"/><xsl:with-param name="b" select="$p[4]/text"/>
            </xsl:call-template>
          </xsl:with-param>
          <xsl:with-param name="d" select="$p[5]/text"/><xsl:with-param name="e" select="$p[6]/text"/>
        </xsl:call-template>
      </xsl:when>
      <xsl:when test="kind = 'typed'">
        <xsl:call-template name="say">
          <xsl:with-param name="id">ws.typed</xsl:with-param>
          <xsl:with-param name="a">
            <xsl:call-template name="say">
              <xsl:with-param name="id">ws.<xsl:choose>
                <xsl:when test="$p[1]/text = 3">gusts</xsl:when><xsl:when test="$p[1]/text = 3600">hourly</xsl:when>
                <xsl:otherwise>means</xsl:otherwise>
              </xsl:choose></xsl:with-param>
              <xsl:with-param name="a" select="$p[1]/text"/>
            </xsl:call-template>
          </xsl:with-param>
          <xsl:with-param name="b">
            <xsl:call-template name="as-typed"><xsl:with-param name="text" select="$p[2]/text"/></xsl:call-template>
          </xsl:with-param>
          <xsl:with-param name="c" select="$p[3]/text"/>
          <xsl:with-param name="d" select="$p[4]/text"/><xsl:with-param name="e" select="$p[5]/text"/>
          <xsl:with-param name="f" select="$p[6]/text"/>
          <xsl:with-param name="g">
            <xsl:call-template name="term">
              <xsl:with-param name="id" select="concat('ws.law.', $p[7]/text)"/><xsl:with-param name="otherwise" select="$p[7]/text"/>
            </xsl:call-template>
          </xsl:with-param>
        </xsl:call-template>
      </xsl:when>
      <xsl:when test="kind = 'design'">
        <xsl:call-template name="say">
          <xsl:with-param name="id">ws.design</xsl:with-param>
          <xsl:with-param name="a">
            <xsl:call-template name="term">
              <xsl:with-param name="id" select="concat('design.', $p[1]/text)"/><xsl:with-param name="otherwise" select="$p[1]/text"/>
            </xsl:call-template>
          </xsl:with-param>
          <xsl:with-param name="b" select="$p[2]/text"/>
          <xsl:with-param name="c">
            <xsl:call-template name="term">
              <xsl:with-param name="id" select="concat('design.basic.', $p[1]/text)"/>
            </xsl:call-template>
            <xsl:if test="$p[7]/text">
              <xsl:call-template name="say">
                <xsl:with-param name="id">ws.years</xsl:with-param><xsl:with-param name="a" select="$p[7]/text"/>
              </xsl:call-template>
            </xsl:if>
          </xsl:with-param>
          <xsl:with-param name="d">
            <xsl:call-template name="term">
              <xsl:with-param name="id" select="concat('design.terrain.', $p[3]/text)"/>
              <xsl:with-param name="otherwise" select="$p[3]/text"/>
            </xsl:call-template>
          </xsl:with-param>
          <xsl:with-param name="e" select="$p[4]/text"/><xsl:with-param name="f" select="$p[5]/text"/>
          <xsl:with-param name="g" select="$p[6]/text"/>
        </xsl:call-template>
      </xsl:when>
      <xsl:otherwise><xsl:value-of select="../../winds_said"/></xsl:otherwise>
    </xsl:choose>
  </xsl:for-each>
</xsl:template>

<!-- Gusts, ground and site of a scenario, which is the node. -->
<xsl:template name="site-line">
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
      <xsl:if test="site_kind != ''">, <xsl:call-template name="term">
        <xsl:with-param name="id" select="concat('site.', site_kind)"/><xsl:with-param name="otherwise" select="site_kind"/>
      </xsl:call-template></xsl:if>
    </xsl:with-param>
    <xsl:with-param name="f">
      <xsl:call-template name="number">
        <xsl:with-param name="x" select="carried/value * speed_up/value"/>
      </xsl:call-template>
    </xsl:with-param>
  </xsl:call-template>
</xsl:template>

<!-- The name of a file without the folders it is in: a page is handed on, and they are nobody's business. -->
<xsl:template name="base-name">
  <xsl:param name="path"/>
  <xsl:choose>
    <xsl:when test="contains($path, '/')">
      <xsl:call-template name="base-name"><xsl:with-param name="path" select="substring-after($path, '/')"/></xsl:call-template>
    </xsl:when>
    <xsl:otherwise><xsl:value-of select="$path"/></xsl:otherwise>
  </xsl:choose>
</xsl:template>

<!-- How the page was made. Files: of calibrations. -->
<xsl:template name="made">
  <xsl:variable name="p" select="$r[not(provenance)] | $r/provenance"/>
  <xsl:call-template name="h2"><xsl:with-param name="id">h.provenance</xsl:with-param></xsl:call-template>
  <table class="block">
    <xsl:call-template name="block-row"><xsl:with-param name="id">tb.program</xsl:with-param>
      <xsl:with-param name="text" select="concat('windfirm ', $p/version)"/></xsl:call-template>
    <xsl:call-template name="block-row"><xsl:with-param name="id">tb.date</xsl:with-param>
      <xsl:with-param name="text" select="string($p/date)"/></xsl:call-template>
    <xsl:variable name="seeds" select="$r/runs/item/seed[not(. = ../preceding-sibling::item/seed)]"/>
    <xsl:if test="$seeds">
      <xsl:call-template name="block-row"><xsl:with-param name="id">p.seed</xsl:with-param>
        <xsl:with-param name="text">
          <xsl:for-each select="$seeds">
            <xsl:if test="position() &gt; 1">, </xsl:if><xsl:value-of select="."/>
          </xsl:for-each>
        </xsl:with-param></xsl:call-template>
    </xsl:if>
    <xsl:for-each select="$r/files/item | $r/provenance/files/item">
      <tr>
        <th><xsl:call-template name="term">
          <xsl:with-param name="id" select="concat('role.', role)"/><xsl:with-param name="otherwise" select="role"/>
        </xsl:call-template></th>
        <td><code>
          <xsl:call-template name="base-name"><xsl:with-param name="path" select="path"/></xsl:call-template></code><xsl:text>  </xsl:text>
          <span class="hash">sha256 <xsl:value-of select="sha256"/></span></td>
      </tr>
    </xsl:for-each>
  </table>
</xsl:template>

<xsl:template match="/report">
  <xsl:variable name="title"><xsl:apply-templates select="." mode="title"/></xsl:variable>
  <xsl:variable name="p" select="$r[not(provenance)] | $r/provenance"/>
  <html lang="{$lang}">
    <head>
      <meta charset="UTF-8"/>
      <xsl:call-template name="policy"/>
      <meta name="viewport" content="width=device-width, initial-scale=1"/>
      <meta name="generator" content="windfirm {$p/version}"/>
      <title><xsl:value-of select="$title"/></title>
      <style><xsl:value-of select="css" disable-output-escaping="yes"/></style>
    </head>
    <body lang="{$lang}">
      <header>
        <h1><xsl:value-of select="$title"/></h1>
        <p class="sub"><xsl:apply-templates select="." mode="sub"/></p>
        <p class="note"><span class="program"><xsl:value-of select="concat('windfirm ', $p/version)"/></span>,
          <xsl:value-of select="translate($p/date, 'TZ', '  ')"/>UTC</p>
        <xsl:call-template name="status"/>
      </header>
      <xsl:apply-templates select="." mode="body"/>
      <xsl:call-template name="made"/>
      <xsl:call-template name="live-script"/>
    </body>
  </html>
</xsl:template>

<!-- What a page may fetch: nothing; what it may run: its own script, where it has one. -->
<xsl:template name="policy">
  <meta http-equiv="Content-Security-Policy">
    <xsl:attribute name="content">
      <xsl:text>default-src 'none'; style-src 'unsafe-inline'; img-src data:</xsl:text>
      <xsl:if test="script">; script-src '<xsl:value-of select="script/@name"/>'</xsl:if>
    </xsl:attribute>
  </meta>
</xsl:template>
<xsl:template name="live-script">
  <xsl:if test="script">
    <script type="application/json" id="live-data"><xsl:value-of select="live"/></script>
    <script><xsl:value-of select="script"/></script>
  </xsl:if>
</xsl:template>

<!-- The button of a picture that plays, and a row of its numbers. -->
<xsl:template name="live-play">
  <button type="button" class="play" aria-pressed="false">
    <xsl:attribute name="data-pause">
      <xsl:call-template name="say"><xsl:with-param name="id">lv.pause</xsl:with-param></xsl:call-template>
    </xsl:attribute>
    <xsl:call-template name="say"><xsl:with-param name="id">lv.play</xsl:with-param></xsl:call-template></button>
</xsl:template>
<!-- Head, choice of a run, slider and button of key frames. The name of a run is the mode "run" of it. -->
<xsl:template name="live-frames">
  <xsl:param name="switch"/>
  <h3><xsl:call-template name="say"><xsl:with-param name="id">lv.frames</xsl:with-param></xsl:call-template></h3>
  <p class="controls">
    <label><xsl:call-template name="say"><xsl:with-param name="id">c.run</xsl:with-param></xsl:call-template>
      <xsl:text> </xsl:text><select>
      <xsl:for-each select="$r/runs/item[keys &gt; 1]">
        <option value="{count(preceding-sibling::item)}"><xsl:apply-templates select="." mode="run"/></option>
      </xsl:for-each>
    </select></label>
    <label><xsl:call-template name="say"><xsl:with-param name="id">lv.frame</xsl:with-param></xsl:call-template>
      <xsl:text> </xsl:text><input type="range" min="0" step="1" value="0"/></label>
    <xsl:if test="$switch">
      <button type="button" class="switch">
        <xsl:call-template name="say"><xsl:with-param name="id">lv.before</xsl:with-param></xsl:call-template></button>
      <xsl:text> </xsl:text>
    </xsl:if>
    <xsl:call-template name="live-play"/>
  </p>
</xsl:template>
<xsl:template name="live-row">
  <xsl:param name="key"/><xsl:param name="unit"/><xsl:param name="id" select="concat('lv.', $key)"/>
  <tr>
    <th><xsl:call-template name="say"><xsl:with-param name="id" select="$id"/></xsl:call-template></th>
    <td><b data-key="{$key}">–</b><xsl:text> </xsl:text><xsl:value-of select="$unit"/></td>
  </tr>
</xsl:template>

<!-- A key of the results (a method, a wind model, a preset) in words; one without words stands for itself. -->
<xsl:template name="key">
  <xsl:param name="of"/><xsl:param name="key"/>
  <xsl:call-template name="term">
    <xsl:with-param name="id" select="concat($of, '.', $key)"/><xsl:with-param name="otherwise" select="$key"/>
  </xsl:call-template>
</xsl:template>

<!-- The species of a run; a run's name, where it begins with the species' key that instead. -->
<xsl:template name="run-tree">
  <xsl:choose>
    <xsl:when test="$lang = 'zh' and species_zh != ''"><xsl:value-of select="species_zh"/></xsl:when>
    <xsl:when test="species_name != ''"><xsl:value-of select="species_name"/></xsl:when>
    <xsl:otherwise><xsl:value-of select="species"/></xsl:otherwise>
  </xsl:choose>
</xsl:template>
<xsl:template name="run-words">
  <xsl:choose>
    <xsl:when test="model_name != '' and not(model)">
      <xsl:call-template name="run-tree"/>
      <xsl:call-template name="say"><xsl:with-param name="id">list.more</xsl:with-param></xsl:call-template>
      <xsl:value-of select="model_name"/>
    </xsl:when>
    <xsl:when test="species != '' and (name = species or starts-with(name, concat(species, ',')))">
      <xsl:call-template name="run-tree"/><xsl:value-of select="substring-after(name, species)"/>
    </xsl:when>
    <xsl:otherwise><xsl:value-of select="name"/></xsl:otherwise>
  </xsl:choose>
</xsl:template>
</xsl:stylesheet>
