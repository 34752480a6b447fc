<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- Is the safety of a tree enough? The context is a tree with an assessment. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform">

<!-- A row: what | now | sound | required | 5 to 95 %. -->
<xsl:template name="as-row">
  <xsl:param name="id"/><xsl:param name="now"/><xsl:param name="sound"/><xsl:param name="low"/><xsl:param name="high"/>
  <tr>
    <td><xsl:call-template name="say"><xsl:with-param name="id" select="$id"/></xsl:call-template></td>
    <xsl:call-template name="cell">
      <xsl:with-param name="x" select="$now"/>
      <xsl:with-param name="bound" select="assessment/required"/>
      <xsl:with-param name="pattern">0.00</xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="cell">
      <xsl:with-param name="x" select="$sound"/>
      <xsl:with-param name="bound" select="assessment/required"/>
      <xsl:with-param name="pattern">0.00</xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="cell">
      <xsl:with-param name="x" select="assessment/required"/>
      <xsl:with-param name="pattern">0.00####</xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="cell">
      <xsl:with-param name="x" select="$low"/>
      <xsl:with-param name="bound" select="assessment/required"/>
      <xsl:with-param name="pattern">0.00</xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="cell">
      <xsl:with-param name="x" select="$high"/>
      <xsl:with-param name="bound" select="assessment/required"/>
      <xsl:with-param name="pattern">0.00</xsl:with-param>
    </xsl:call-template>
  </tr>
</xsl:template>

<xsl:template name="as-period">
  <xsl:param name="x"/>
  <xsl:variable name="ten" select="1 + 9 * ($x &gt;= 99.5) + 90 * ($x &gt;= 995) + 900 * ($x &gt;= 9950)"/>
  <xsl:choose>
    <xsl:when test="$x &lt; 9.95"><xsl:value-of select="format-number($x, '0.#')"/></xsl:when>
    <xsl:otherwise><xsl:value-of select="format-number($ten * round($x div $ten), '#,##0')"/></xsl:otherwise>
  </xsl:choose>
</xsl:template>

<!-- What the band of the fitted extremes says of the return period, or that there is none. -->
<xsl:template name="as-band">
  <xsl:variable name="a" select="assessment"/>
  <xsl:variable name="low" select="$a/return_period_low_bound"/>
  <xsl:value-of select="$gap"/>
  <xsl:call-template name="say">
    <xsl:with-param name="id">
      <xsl:text>as.band.</xsl:text>
      <xsl:choose>
        <xsl:when test="not($low != '')">none</xsl:when>
        <xsl:when test="$low = $a/return_period_high_bound"><xsl:value-of select="$low"/></xsl:when>
        <xsl:otherwise><xsl:value-of select="concat($low, '.', $a/return_period_high_bound)"/></xsl:otherwise>
      </xsl:choose>
    </xsl:with-param>
    <xsl:with-param name="a">
      <xsl:call-template name="as-period"><xsl:with-param name="x" select="$a/return_period_low"/></xsl:call-template>
    </xsl:with-param>
    <xsl:with-param name="b">
      <xsl:call-template name="as-period"><xsl:with-param name="x" select="$a/return_period_high"/></xsl:call-template>
    </xsl:with-param>
  </xsl:call-template>
</xsl:template>

<xsl:template name="as-years">
  <xsl:variable name="a" select="assessment"/>
  <xsl:choose>
    <xsl:when test="$a/return_period/value != ''">
      <xsl:call-template name="say">
        <xsl:with-param name="id" select="concat('as.years.', $a/return_period_bound)"/>
        <xsl:with-param name="a">
          <!-- two figures: a wind that is known to a tenth -->
          <xsl:call-template name="as-period"><xsl:with-param name="x" select="$a/return_period/value"/></xsl:call-template>
        </xsl:with-param>
        <xsl:with-param name="b">
          <xsl:call-template name="say">
            <xsl:with-param name="id">
              <xsl:choose>
                <xsl:when test="$a/return_period_by != ''">as.years.extremes</xsl:when>
                <xsl:otherwise>as.years.code</xsl:otherwise>
              </xsl:choose>
            </xsl:with-param>
          </xsl:call-template>
        </xsl:with-param>
      </xsl:call-template>
      <xsl:text> </xsl:text>
      <xsl:call-template name="say">
        <xsl:with-param name="id">as.years.chance</xsl:with-param>
        <xsl:with-param name="a" select="$a/exceedance_a_year_text"/>
        <xsl:with-param name="b" select="$a/exceedance_over_life_text"/>
        <xsl:with-param name="c" select="$a/life_years"/>
      </xsl:call-template>
      <xsl:if test="not($a/overturning/safety/value != '')">
        <xsl:text> </xsl:text>
        <xsl:call-template name="say"><xsl:with-param name="id">as.years.stem</xsl:with-param></xsl:call-template>
      </xsl:if>
      <xsl:if test="$a/return_period_by != ''"><xsl:call-template name="as-band"/></xsl:if>
      <xsl:if test="$a/exceedance_at_low_end_text != ''">
        <xsl:value-of select="$gap"/>
        <xsl:call-template name="say">
          <xsl:with-param name="id">as.years.low</xsl:with-param>
          <xsl:with-param name="a" select="$a/exceedance_at_low_end_text"/>
        </xsl:call-template>
      </xsl:if>
    </xsl:when>
    <xsl:otherwise><xsl:call-template name="say">
      <xsl:with-param name="id">as.years.unknown</xsl:with-param>
    </xsl:call-template></xsl:otherwise>
  </xsl:choose>
</xsl:template>

<xsl:template name="as-directions">
  <table class="data">
    <xsl:call-template name="caption">
      <xsl:with-param name="id">as.t.directions<xsl:if test="assessment/from/value != ''">.marked</xsl:if></xsl:with-param>
      <xsl:with-param name="a">
        <xsl:call-template name="compass"><xsl:with-param name="of" select="assessment"/></xsl:call-template></xsl:with-param>
    </xsl:call-template>
    <thead><tr><xsl:call-template name="heads">
      <xsl:with-param name="of" select="'as.c.from:°;as.c.breakage:;as.c.overturning:'"/>
    </xsl:call-template></tr></thead>
    <tbody>
      <xsl:for-each select="assessment/directions/item">
        <xsl:sort select="from/value" data-type="number"/>
        <tr>
          <xsl:if test="concat('', from/value) = concat('', ../../from/value)">
            <xsl:attribute name="class">governs</xsl:attribute>
          </xsl:if>
          <xsl:call-template name="cell">
            <xsl:with-param name="x" select="$degrees * from/value"/>
            <xsl:with-param name="pattern">0.#</xsl:with-param>
          </xsl:call-template>
          <xsl:call-template name="cell">
            <xsl:with-param name="x" select="breakage/value"/>
            <xsl:with-param name="bound" select="../../required"/>
            <xsl:with-param name="pattern">0.00</xsl:with-param>
          </xsl:call-template>
          <xsl:call-template name="cell">
            <xsl:with-param name="x" select="overturning/value"/>
            <xsl:with-param name="bound" select="../../required"/>
            <xsl:with-param name="pattern">0.00</xsl:with-param>
          </xsl:call-template>
        </tr>
      </xsl:for-each>
    </tbody>
  </table>
</xsl:template>

<xsl:template name="assessment">
  <xsl:variable name="a" select="assessment"/>
  <table class="data">
    <xsl:call-template name="caption">
      <xsl:with-param name="id">
        <xsl:text>as.t.safety</xsl:text>
        <xsl:if test="$a/from/value != '' and $a/from_specified = 'false'">.around</xsl:if>
      </xsl:with-param>
      
        <xsl:with-param name="a"><xsl:call-template name="number"><xsl:with-param name="x" select="$a/speed/value"/>
      </xsl:call-template></xsl:with-param>
    </xsl:call-template>
    <thead><tr><xsl:call-template name="heads">
      <xsl:with-param name="of" select="'as.c.against;as.c.now:;as.c.sound:;as.c.required:;as.c.low:;as.c.high:'"/>
      <xsl:with-param name="units">no</xsl:with-param>
    </xsl:call-template></tr></thead>
    <tbody>
      <xsl:call-template name="as-row">
        <xsl:with-param name="id">as.breakage</xsl:with-param><xsl:with-param name="now" select="$a/breakage/safety/value"/>
        <xsl:with-param name="sound" select="$a/sound/value"/>
      </xsl:call-template>
      <xsl:call-template name="as-row">
        
          <xsl:with-param name="id">as.overturning</xsl:with-param>
          <xsl:with-param name="now" select="$a/overturning/safety/value"/>
      </xsl:call-template>
      <xsl:call-template name="as-row">
        <xsl:with-param name="id">as.saturated</xsl:with-param><xsl:with-param name="now" select="$a/saturated_low"/>
      </xsl:call-template>
      <xsl:call-template name="as-row">
        <xsl:with-param name="id">as.least</xsl:with-param>
        <xsl:with-param name="now" select="($a/breakage/safety/value[not(. &gt; $a/overturning/safety/value)] |
          $a/overturning/safety/value[. &lt; $a/breakage/safety/value])[1]"/>
        <xsl:with-param name="low" select="$a/low"/><xsl:with-param name="high" select="$a/high"/>
      </xsl:call-template>
    </tbody>
  </table>
  <xsl:if test="$a/least_reduction &gt; 0">
    <p><xsl:call-template name="say">
      <xsl:with-param name="id">as.reduction</xsl:with-param>
      <xsl:with-param name="a" select="format-number(100 * $a/least_reduction, '0')"/>
      <xsl:with-param name="b" select="format-number(100 * $a/least_reduction_cut, '0')"/>
    </xsl:call-template>
    <xsl:if test="$a/least_reduction_cut &gt; 0.3">
      <xsl:value-of select="$gap"/>
      <xsl:call-template name="say"><xsl:with-param name="id">as.reduction.harm</xsl:with-param></xsl:call-template>
    </xsl:if>
    <xsl:if test="$a/saturated_low != '' and $a/overturning/safety/value &gt; 0">
      <xsl:value-of select="$gap"/>
      <xsl:call-template name="say">
        <xsl:with-param name="id">as.reduction.wet</xsl:with-param>
        <xsl:with-param name="a" select="format-number($a/saturated_low div $a/overturning/safety/value, '0.00')"/>
        <xsl:with-param name="b" select="format-number($a/saturated_high div $a/overturning/safety/value, '0.00')"/>
      </xsl:call-template>
    </xsl:if></p>
  </xsl:if>
  <xsl:if test="not($a/least_reduction &gt; 0) and ($a/least_reduction_tried &gt; 0 or $a/least_reduction_unknown != '')">
    <p><xsl:call-template name="say">
      <xsl:with-param name="id">
        <xsl:text>as.reduction.</xsl:text>
        <xsl:choose><xsl:when test="$a/least_reduction_unknown != ''">unknown</xsl:when><xsl:otherwise>none</xsl:otherwise></xsl:choose>
      </xsl:with-param>
      <xsl:with-param name="a" select="format-number(100 * $a/least_reduction_tried, '0')"/>
    </xsl:call-template></p>
  </xsl:if>
  <xsl:if test="$a/record/item">
    <p><xsl:call-template name="say"><xsl:with-param name="id">as.record</xsl:with-param></xsl:call-template></p>
    <ul>
      <xsl:for-each select="$a/record/item"><li><xsl:value-of select="text"/></li></xsl:for-each>
    </ul>
  </xsl:if>
  <xsl:call-template name="scenarios-tables"><xsl:with-param name="of" select="."/></xsl:call-template>
  <xsl:if test="$a/directions/item"><xsl:call-template name="as-directions"/></xsl:if>
</xsl:template>
</xsl:stylesheet>
