<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- Words and numbers: sentences come from strings.xml in the language of the report, numbers are put into
     them at {1}, {2} ... Shared by the page and the figures. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform">
<xsl:variable name="lang" select="/report/@lang"/>
<xsl:variable name="strings" select="document('strings.xml')/strings"/>
<xsl:key name="string" match="s|q|w|k" use="@id | @was"/>
<xsl:variable name="gap">
  <xsl:call-template name="say"><xsl:with-param name="id">gap</xsl:with-param></xsl:call-template>
</xsl:variable>
<xsl:variable name="trees" select="/report/results/trees/item"/>
<!-- other units than metric: numbers are marked, for out/page_units.h, which turns them with their units -->
<xsl:variable name="units" select="/report/@units"/>
<xsl:variable name="degrees" select="57.29577951308232"/>

<!-- A sentence with up to eight things put in. -->
<xsl:template name="say">
  <xsl:param name="id"/><xsl:param name="a"/><xsl:param name="b"/><xsl:param name="c"/><xsl:param name="d"/>
  <xsl:param name="e"/><xsl:param name="f"/><xsl:param name="g"/><xsl:param name="h"/>
  <xsl:variable name="text">
    <xsl:for-each select="$strings"><xsl:value-of select="key('string', $id)/*[name() = $lang]"/></xsl:for-each>
  </xsl:variable>
  <xsl:if test="$text = ''">
    <xsl:message terminate="yes">strings.xml: no string '<xsl:value-of select="$id"/>'</xsl:message>
  </xsl:if>
  <xsl:call-template name="put-in">
    <xsl:with-param name="text" select="string($text)"/>
    <xsl:with-param name="a" select="$a"/><xsl:with-param name="b" select="$b"/><xsl:with-param name="c" select="$c"/>
    <xsl:with-param name="d" select="$d"/><xsl:with-param name="e" select="$e"/><xsl:with-param name="f" select="$f"/>
    <xsl:with-param name="g" select="$g"/><xsl:with-param name="h" select="$h"/>
  </xsl:call-template>
</xsl:template>

<xsl:template name="put-in">
  <xsl:param name="text"/><xsl:param name="a"/><xsl:param name="b"/><xsl:param name="c"/><xsl:param name="d"/>
  <xsl:param name="e"/><xsl:param name="f"/><xsl:param name="g"/><xsl:param name="h"/>
  <xsl:choose>
    <xsl:when test="contains($text, '{')">
      <xsl:variable name="n" select="substring-before(substring-after($text, '{'), '}')"/>
      <xsl:value-of select="substring-before($text, '{')"/>
      <xsl:choose>
        <xsl:when test="$n = 1"><xsl:value-of select="$a"/></xsl:when>
        <xsl:when test="$n = 2"><xsl:value-of select="$b"/></xsl:when>
        <xsl:when test="$n = 3"><xsl:value-of select="$c"/></xsl:when>
        <xsl:when test="$n = 4"><xsl:value-of select="$d"/></xsl:when>
        <xsl:when test="$n = 5"><xsl:value-of select="$e"/></xsl:when>
        <xsl:when test="$n = 6"><xsl:value-of select="$f"/></xsl:when>
        <xsl:when test="$n = 7"><xsl:value-of select="$g"/></xsl:when>
        <xsl:otherwise><xsl:value-of select="$h"/></xsl:otherwise>
      </xsl:choose>
      <xsl:call-template name="put-in">
        <xsl:with-param name="text" select="substring-after($text, '}')"/>
        <xsl:with-param name="a" select="$a"/><xsl:with-param name="b" select="$b"/><xsl:with-param name="c" select="$c"/>
        <xsl:with-param name="d" select="$d"/><xsl:with-param name="e" select="$e"/><xsl:with-param name="f" select="$f"/>
        <xsl:with-param name="g" select="$g"/><xsl:with-param name="h" select="$h"/>
      </xsl:call-template>
    </xsl:when>
    <xsl:otherwise><xsl:value-of select="$text"/></xsl:otherwise>
  </xsl:choose>
</xsl:template>

<!-- Words for a term of the results (an outcome, a quantity, a warning's code): the string if there is one, else
     what the results say themselves. -->
<xsl:template name="term">
  <xsl:param name="id"/><xsl:param name="otherwise"/>
  <xsl:variable name="text">
    <xsl:for-each select="$strings"><xsl:value-of select="key('string', $id)/*[name() = $lang]"/></xsl:for-each>
  </xsl:variable>
  <xsl:choose>
    <xsl:when test="$text != ''"><xsl:value-of select="$text"/></xsl:when>
    <xsl:otherwise><xsl:value-of select="$otherwise"/></xsl:otherwise>
  </xsl:choose>
</xsl:template>

<!-- A pattern by which a safety stands on the side of 1, and of what is required, that it is on: 1.497 and not 1.50. -->
<xsl:template name="safety-pattern">
  <xsl:param name="x"/><xsl:param name="bound"/><xsl:param name="pattern" select="'0.00'"/>
  <xsl:variable name="shown" select="number(format-number($x, $pattern))"/>
  <xsl:variable name="same" select="($x &lt; $bound) = ($shown &lt; $bound) and ($x &gt; 1) = ($shown &gt; 1)"/>
  <xsl:choose>
    <xsl:when test="$same or string-length($pattern) &gt; 9"><xsl:value-of select="$pattern"/></xsl:when>
    <xsl:otherwise>
      <xsl:call-template name="safety-pattern">
        <xsl:with-param name="x" select="$x"/><xsl:with-param name="bound" select="$bound"/>
        <xsl:with-param name="pattern" select="concat($pattern, '0')"/>
      </xsl:call-template>
    </xsl:otherwise>
  </xsl:choose>
</xsl:template>

<!-- A number with a fixed number of decimals, a real minus sign; a dash where there is none. "bound": of a safety, the required one. -->
<xsl:template name="fixed">
  <xsl:param name="x"/><xsl:param name="pattern" select="'0.0'"/><xsl:param name="bound"/>
  <xsl:choose>
    <xsl:when test="string(number($x)) = 'NaN'">–</xsl:when>
    <xsl:otherwise>
      <xsl:variable name="digits">
        <xsl:choose>
          <xsl:when test="$bound != '' and $x &lt; 100">
            <xsl:call-template name="safety-pattern">
              <xsl:with-param name="x" select="$x"/><xsl:with-param name="bound" select="$bound"/>
              <xsl:with-param name="pattern" select="$pattern"/>
            </xsl:call-template>
          </xsl:when>
          <xsl:otherwise><xsl:value-of select="$pattern"/></xsl:otherwise>
        </xsl:choose>
      </xsl:variable>
      <xsl:variable name="text" select="format-number($x, $digits)"/>
      <xsl:if test="$units"><xsl:value-of select="concat('&#xE000;', $x, '&#xE001;')"/></xsl:if>
      <xsl:choose>
        <xsl:when test="starts-with($text, '-') and number(translate($text, ',', '')) = 0">
          <xsl:value-of select="substring($text, 2)"/>
        </xsl:when>
        <xsl:otherwise><xsl:value-of select="translate($text, '-', '−')"/></xsl:otherwise>
      </xsl:choose>
      <xsl:if test="$units">&#xE002;</xsl:if>
    </xsl:otherwise>
  </xsl:choose>
</xsl:template>

<!-- A result with about three significant digits; what four decimals would round to nothing is less than their last. -->
<xsl:template name="number">
  <xsl:param name="x"/><xsl:param name="bound"/>
  <xsl:variable name="size" select="($x &lt; 0) * -$x + ($x &gt;= 0) * $x"/>
  <xsl:variable name="ten" select="1 + 9 * ($size &gt;= 999.5) + 90 * ($size &gt;= 9995) + 900 * ($size &gt;= 99950) +
    9000 * ($size &gt;= 999500)"/>
  <xsl:variable name="tiny" select="$size &gt; 0 and $size &lt; 0.00005"/>
  <xsl:if test="$tiny and $x &gt; 0">&lt; </xsl:if><xsl:if test="$tiny and $x &lt; 0">&gt; </xsl:if>
  <xsl:call-template name="fixed">
    <xsl:with-param name="x">
      <xsl:choose>
        <xsl:when test="$tiny and $x &lt; 0">-0.0001</xsl:when>
        <xsl:when test="$tiny">0.0001</xsl:when>
        <xsl:when test="$ten &gt; 1"><xsl:value-of select="$ten * round($x div $ten)"/></xsl:when>
        <xsl:otherwise><xsl:value-of select="$x"/></xsl:otherwise>
      </xsl:choose>
    </xsl:with-param>
    <xsl:with-param name="bound" select="$bound"/>
    <xsl:with-param name="pattern">
      <xsl:choose>
        <xsl:when test="$size &gt;= 99.95 or $size = 0">#,##0</xsl:when>
        <xsl:when test="$size &gt;= 9.995">0.0</xsl:when>
        <xsl:when test="$size &gt;= 0.9995">0.00</xsl:when>
        <xsl:when test="$size &gt;= 0.09995">0.000</xsl:when>
        <xsl:otherwise>0.0000</xsl:otherwise>
      </xsl:choose>
    </xsl:with-param>
  </xsl:call-template>
</xsl:template>

<!-- A fixed number of decimals as long as that shows the number, else three significant digits. -->
<xsl:template name="steady">
  <xsl:param name="x"/><xsl:param name="pattern" select="'0.0'"/><xsl:param name="least" select="0.1"/>
  <xsl:choose>
    <xsl:when test="$x = 0 or $x &gt;= $least or $x &lt;= -$least">
      <xsl:call-template name="fixed">
        <xsl:with-param name="x" select="$x"/><xsl:with-param name="pattern" select="$pattern"/>
      </xsl:call-template>
    </xsl:when>
    <xsl:otherwise><xsl:call-template name="number"><xsl:with-param name="x" select="$x"/></xsl:call-template></xsl:otherwise>
  </xsl:choose>
</xsl:template>

<!-- A value as somebody gave it: no digits added. One with more than three decimals was converted: three digits. -->
<xsl:template name="given">
  <xsl:param name="x"/>
  <xsl:variable name="rest" select="1000 * $x - round(1000 * $x)"/>
  <xsl:variable name="converted" select="$x &gt;= 1 and $x &lt; 1000 and ($rest &gt; 0.005 or $rest &lt; -0.005)"/>
  <xsl:call-template name="fixed">
    <xsl:with-param name="x" select="$x"/>
    <xsl:with-param name="pattern">
      <xsl:choose>
        <xsl:when test="$converted and $x &gt;= 100">0</xsl:when>
        <xsl:when test="$converted and $x &gt;= 10">0.#</xsl:when>
        <xsl:when test="$converted">0.##</xsl:when>
        <xsl:otherwise>#,##0.#####</xsl:otherwise>
      </xsl:choose>
    </xsl:with-param>
  </xsl:call-template>
</xsl:template>

<!-- Powers and signs of a note or a message as they are set in print. -->
<xsl:template name="fine">
  <xsl:param name="text"/>
  <xsl:param name="pairs"
             select="'kg/m2=kg/m²;/m3=/m³;/ft3=/ft³;x d^2=× d²;d^2=d²;R^3=R³;R^4=R⁴;N^3=N³;D/H2=D/H²;R2 0=R² 0;pi/4=π/4;'"/>
  <xsl:variable name="from" select="substring-before($pairs, '=')"/>
  <xsl:choose>
    <xsl:when test="$pairs = ''"><xsl:value-of select="$text"/></xsl:when>
    <xsl:when test="contains($text, $from)">
      <xsl:call-template name="fine">
        <xsl:with-param name="text" select="concat(substring-before($text, $from), substring-before(substring-after($pairs, '='), ';'),
          substring-after($text, $from))"/>
        <xsl:with-param name="pairs" select="$pairs"/>
      </xsl:call-template>
    </xsl:when>
    <xsl:otherwise>
      <xsl:call-template name="fine">
        <xsl:with-param name="text" select="$text"/><xsl:with-param name="pairs" select="substring-after($pairs, ';')"/>
      </xsl:call-template>
    </xsl:otherwise>
  </xsl:choose>
</xsl:template>

<!-- A text that stays as somebody typed it, whatever the units of the page. -->
<xsl:template name="as-typed">
  <xsl:param name="text"/>
  <xsl:if test="$units">&#xE003;</xsl:if><xsl:value-of select="$text"/><xsl:if test="$units">&#xE004;</xsl:if>
</xsl:template>

<!-- The 3-s gust of a named mean wind, where it is measured. -->
<xsl:template name="gust">
  <xsl:param name="x"/>
  <xsl:call-template name="number">
    <xsl:with-param name="x" select="$x * $trees[1]/scenario/gust_over_mean/value"/>
  </xsl:call-template>
</xsl:template>

<!-- The name of a tree's species in the language of the report. -->
<xsl:template name="name">
  <xsl:param name="tree" select="."/>
  <xsl:choose>
    <xsl:when test="$lang = 'zh' and $tree/species/name_zh != ''">
      <xsl:value-of select="normalize-space($tree/species/name_zh)"/>
    </xsl:when>
    <xsl:when test="$tree/species/name != ''"><xsl:value-of select="normalize-space($tree/species/name)"/></xsl:when>
    <xsl:otherwise><xsl:value-of select="$tree/species/key"/></xsl:otherwise>
  </xsl:choose>
  <!-- two species that Chinese calls by one name -->
  <xsl:if test="$lang = 'zh' and $tree/species/name_zh != '' and
                $trees[species/name_zh = $tree/species/name_zh and species/name != $tree/species/name]">
    <xsl:value-of select="concat('（', normalize-space($tree/species/name), '）')"/>
  </xsl:if>
  <!-- two tables of one species (another preset, or the user's own copy) must not look the same -->
  <xsl:if test="count($trees[species/name = $tree/species/name]) &gt; 1">
    <xsl:value-of select="concat(' (', $tree/species/key)"/>
    <xsl:if test="count($trees[species/name = $tree/species/name and species/key = $tree/species/key]) &gt; 1">
      <xsl:value-of select="concat(' ', count($tree/preceding-sibling::item) + 1)"/>
    </xsl:if>
    <xsl:text>)</xsl:text>
  </xsl:if>
</xsl:template>

<!-- Where the axis of wind speeds ends, of the curves of all trees [m/s]: a round speed above those given, of the first breakage
     and of the loss, or the last that was computed. -->
<xsl:template name="speed-end">
  <xsl:variable name="far">
    <xsl:for-each select="($trees/winds/item/speed | $trees/critical/speed | $trees/verdict/critical_speed)/value[. != '']">
      <xsl:sort data-type="number" order="descending"/>
      <xsl:if test="position() = 1"><xsl:value-of select="."/></xsl:if>
    </xsl:for-each>
  </xsl:variable>
  <xsl:variable name="end">
    <xsl:for-each select="$trees/sweep_speed_high/value[. != '']">
      <xsl:sort data-type="number" order="descending"/>
      <xsl:if test="position() = 1"><xsl:value-of select="."/></xsl:if>
    </xsl:for-each>
  </xsl:variable>
  <xsl:variable name="wide" select="5 * ceiling(1.08 * $far div 5)"/>
  <xsl:choose>
    <xsl:when test="$end != '' and $end &lt; $wide"><xsl:value-of select="$end"/></xsl:when>
    <xsl:otherwise><xsl:value-of select="$wide"/></xsl:otherwise>
  </xsl:choose>
</xsl:template>

<!-- "10, 15 and 25" -->
<xsl:template name="list">
  <xsl:param name="items"/>
  <xsl:for-each select="$items">
    <xsl:choose>
      <xsl:when test="position() = 1"/>
      <xsl:when test="$units and position() = last()">
        <xsl:text>&#xE005;</xsl:text>
        <xsl:call-template name="say"><xsl:with-param name="id">list.last</xsl:with-param></xsl:call-template>
      </xsl:when>
      <xsl:when test="$units">
        <xsl:text>&#xE005;</xsl:text>
        <xsl:call-template name="say"><xsl:with-param name="id">list.more</xsl:with-param></xsl:call-template>
      </xsl:when>
      <xsl:when test="position() = last()">
        <xsl:call-template name="say"><xsl:with-param name="id">list.last</xsl:with-param></xsl:call-template>
      </xsl:when>
      <xsl:otherwise>
        <xsl:call-template name="say"><xsl:with-param name="id">list.more</xsl:with-param></xsl:call-template>
      </xsl:otherwise>
    </xsl:choose>
    <xsl:call-template name="given"><xsl:with-param name="x" select="."/></xsl:call-template>
  </xsl:for-each>
</xsl:template>

<!-- Which of the wind speeds the figures show: all up to five, else five spread evenly. " 1 3 5 " -->
<xsl:variable name="winds" select="count($trees[1]/winds/item)"/>
<xsl:variable name="shown">
  <xsl:text> </xsl:text>
  <xsl:for-each select="$trees[1]/winds/item">
    <xsl:variable name="p" select="position()"/>
    <xsl:if test="$winds &lt;= 5 or $p = 1 or $p = 1 + round(($winds - 1) div 4) or $p = 1 + round(($winds - 1) div 2)
                  or $p = 1 + round(3 * ($winds - 1) div 4) or $p = $winds"><xsl:value-of select="concat($p, ' ')"/></xsl:if>
  </xsl:for-each>
</xsl:variable>
</xsl:stylesheet>
