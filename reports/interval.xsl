<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- How sure a critical wind is: the object `interval` of results in words and tables. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform">

<!-- A wind with the digits that the interval deserves; "above 60" where the search ended. -->
<xsl:template name="iv-wind">
  <xsl:param name="x"/><xsl:param name="end" select="searched_to_m_s"/>
  <xsl:variable name="pattern" select="concat('0', substring('.00', 1, (decimals &gt; 0) * (1 + decimals)))"/>
  <xsl:choose>
    <xsl:when test="string($x) = ''">
      <xsl:call-template name="say">
        <xsl:with-param name="id">iv.above</xsl:with-param>
        <xsl:with-param name="a" select="format-number($end, '0')"/>
      </xsl:call-template>
    </xsl:when>
    <xsl:otherwise><xsl:value-of select="format-number($x, $pattern)"/></xsl:otherwise>
  </xsl:choose>
</xsl:template>

<!-- From one wind to another by the string `id`; once where the search ended below both. Context: an interval. -->
<xsl:template name="iv-range">
  <xsl:param name="low"/><xsl:param name="high"/><xsl:param name="end" select="searched_to_m_s"/><xsl:param name="id">range</xsl:param>
  <xsl:choose>
    <xsl:when test="string($low) = ''">
      <xsl:call-template name="iv-wind"><xsl:with-param name="end" select="$end"/></xsl:call-template>
    </xsl:when>
    <xsl:otherwise>
      <xsl:call-template name="say">
        <xsl:with-param name="id" select="$id"/>
        <xsl:with-param name="a">
          <xsl:call-template name="iv-wind"><xsl:with-param name="x" select="$low"/></xsl:call-template></xsl:with-param>
        <xsl:with-param name="b">
          <xsl:call-template name="iv-wind">
            <xsl:with-param name="x" select="$high"/><xsl:with-param name="end" select="$end"/></xsl:call-template>
        </xsl:with-param>
      </xsl:call-template>
    </xsl:otherwise>
  </xsl:choose>
</xsl:template>

<!-- The gust at the end of the search, which results of version 0.6 do not have. Context: an interval. -->
<xsl:template name="iv-gust-end">
  <xsl:choose>
    <xsl:when test="searched_to_gust_m_s != ''"><xsl:value-of select="searched_to_gust_m_s"/></xsl:when>
    <xsl:when test="low_m_s &gt; 0"><xsl:value-of select="searched_to_m_s * low_gust_m_s div low_m_s"/></xsl:when>
    <xsl:otherwise><xsl:value-of select="searched_to_m_s"/></xsl:otherwise>
  </xsl:choose>
</xsl:template>

<!-- The sentences. Context: an interval. -->
<xsl:template name="iv-words">
  <xsl:param name="name"/>
  <xsl:variable name="end"><xsl:call-template name="iv-gust-end"/></xsl:variable>
  <xsl:call-template name="say">
    <xsl:with-param name="id">iv.<xsl:choose>
      <xsl:when test="low_m_s = ''">none</xsl:when><xsl:when test="middle_m_s = ''">half</xsl:when><xsl:otherwise>line</xsl:otherwise>
    </xsl:choose>.<xsl:value-of select="scope"/></xsl:with-param>
    <xsl:with-param name="a" select="$name"/>
    <xsl:with-param name="b">
      <xsl:call-template name="iv-wind"><xsl:with-param name="x" select="middle_m_s"/></xsl:call-template>
    </xsl:with-param>
    <xsl:with-param name="c">
      <xsl:call-template name="iv-wind"><xsl:with-param name="x" select="low_m_s"/></xsl:call-template>
    </xsl:with-param>
    <xsl:with-param name="d">
      <xsl:call-template name="iv-wind"><xsl:with-param name="x" select="high_m_s"/></xsl:call-template>
    </xsl:with-param>
    <xsl:with-param name="e" select="samples - left_out"/>
    <xsl:with-param name="f" select="format-number($end, '0')"/>
  </xsl:call-template>
  <xsl:if test="low_m_s != ''">
    <xsl:value-of select="$gap"/>
  <xsl:call-template name="say">
    <xsl:with-param name="id">iv.gust</xsl:with-param>
    <xsl:with-param name="a">
      <xsl:call-template name="iv-wind">
        <xsl:with-param name="x" select="middle_gust_m_s"/><xsl:with-param name="end" select="$end"/></xsl:call-template>
    </xsl:with-param>
    <xsl:with-param name="b">
      <xsl:call-template name="iv-wind">
        <xsl:with-param name="x" select="low_gust_m_s"/><xsl:with-param name="end" select="$end"/></xsl:call-template>
    </xsl:with-param>
    <xsl:with-param name="c">
      <xsl:call-template name="iv-wind">
        <xsl:with-param name="x" select="high_gust_m_s"/><xsl:with-param name="end" select="$end"/></xsl:call-template>
    </xsl:with-param>
  </xsl:call-template>
  </xsl:if>
  <xsl:if test="lost_in_still_air &gt; 0">
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
        <xsl:with-param name="id">iv.still</xsl:with-param><xsl:with-param name="a" select="lost_in_still_air"/></xsl:call-template>
  </xsl:if>
  <xsl:if test="left_out &gt; 0">
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
        <xsl:with-param name="id">iv.left_out</xsl:with-param><xsl:with-param name="a" select="left_out"/></xsl:call-template>
  </xsl:if>
</xsl:template>

<!-- For the summary. Context: a tree. -->
<xsl:template name="iv-brief">
  <xsl:for-each select="interval">
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
      <xsl:with-param name="id">iv.brief<xsl:if test="low_m_s = ''">.none</xsl:if>.<xsl:value-of select="scope"/></xsl:with-param>
      <xsl:with-param name="a">
        <xsl:call-template name="iv-wind"><xsl:with-param name="x" select="low_m_s"/></xsl:call-template>
      </xsl:with-param>
      <xsl:with-param name="b">
        <xsl:call-template name="iv-wind"><xsl:with-param name="x" select="high_m_s"/></xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
  </xsl:for-each>
</xsl:template>

<xsl:template name="iv-safety">
  <xsl:param name="name"/>
  <table class="data narrow">
    <xsl:call-template name="caption">
        <xsl:with-param name="id">iv.safety</xsl:with-param><xsl:with-param name="a" select="$name"/></xsl:call-template>
    <thead><tr>
      <xsl:call-template name="heads"><xsl:with-param name="of">c.wind:m/s;iv.c.low:;iv.c.high:</xsl:with-param></xsl:call-template>
    </tr></thead>
    <tbody>
      <xsl:for-each select="safeties/item">
        <tr>
          <td class="r"><xsl:call-template name="given"><xsl:with-param name="x" select="speed"/></xsl:call-template></td>
          <xsl:call-template name="cell">
            <xsl:with-param name="x" select="low"/><xsl:with-param name="pattern">0.00</xsl:with-param>
          </xsl:call-template>
          <xsl:call-template name="cell">
            <xsl:with-param name="x" select="high"/><xsl:with-param name="pattern">0.00</xsl:with-param>
          </xsl:call-template>
        </tr>
      </xsl:for-each>
    </tbody>
  </table>
</xsl:template>

<!-- A value in the unit in which species are shown; a factor with its sign. -->
<xsl:template name="iv-value">
  <xsl:param name="x"/>
  <xsl:variable name="quantity" select="quantity"/>
  <xsl:variable name="times">
    <xsl:for-each select="$strings"><xsl:value-of select="key('string', $quantity)/@factor"/></xsl:for-each></xsl:variable>
  <td class="r">
    <xsl:choose>
      <xsl:when test="kind = 'factor'">× <xsl:value-of select="format-number($x, '0.00')"/></xsl:when>
      <xsl:otherwise>
        <xsl:call-template name="number"><xsl:with-param name="x" select="$x * $times"/></xsl:call-template>
      </xsl:otherwise>
    </xsl:choose>
  </td>
</xsl:template>

<xsl:template name="iv-critical">
  <xsl:param name="x"/><xsl:param name="stands"/>
  <td class="r">
    <xsl:choose>
      <xsl:when test="$stands = 'false'">
        <xsl:call-template name="say"><xsl:with-param name="id">iv.falls</xsl:with-param></xsl:call-template>
      </xsl:when>
      <xsl:when test="string($x) = ''">&gt; <xsl:value-of select="format-number(../../searched_to_m_s, '0')"/></xsl:when>
      <xsl:otherwise><xsl:value-of select="format-number($x, '0.0')"/></xsl:otherwise>
    </xsl:choose>
  </td>
</xsl:template>

<xsl:template name="iv-tornado">
  <xsl:param name="name"/>
  <table class="data">
    <xsl:call-template name="caption">
        <xsl:with-param name="id">iv.tornado</xsl:with-param><xsl:with-param name="a" select="$name"/></xsl:call-template>
    <thead><tr>
      <xsl:call-template name="heads">
        <xsl:with-param name="of">iv.c.value;iv.c.standing;iv.c.median:;iv.c.low:;iv.c.high:;
          iv.c.at_low:m/s;iv.c.at_high:m/s</xsl:with-param>
      </xsl:call-template>
    </tr></thead>
    <!-- the last two rows together, so that none stands alone on a page -->
    <tbody class="long">
      <xsl:for-each select="varied/item[position() &lt;= last() - 2]"><xsl:call-template name="iv-tornado-row"/></xsl:for-each>
    </tbody>
    <tbody class="tail">
      <xsl:for-each select="varied/item[position() &gt; last() - 2]"><xsl:call-template name="iv-tornado-row"/></xsl:for-each>
    </tbody>
  </table>
</xsl:template>

<xsl:template name="iv-tornado-row">
  <xsl:variable name="quantity" select="quantity"/>
  <xsl:variable name="unit">
    <xsl:for-each select="$strings"><xsl:value-of select="key('string', $quantity)/@unit"/></xsl:for-each></xsl:variable>
  <tr>
    <td>
      <xsl:choose>
        <xsl:when test="kind = 'factor'">
          <xsl:call-template name="term">
              <xsl:with-param name="id" select="concat('iv.', quantity)"/>
              <xsl:with-param name="otherwise" select="quantity"/></xsl:call-template>
        </xsl:when>
        <xsl:otherwise>
          <xsl:call-template name="term">
              <xsl:with-param name="id" select="quantity"/><xsl:with-param name="otherwise" select="quantity"/></xsl:call-template>
          <xsl:if test="$unit != '' and $unit != '–'">, <xsl:value-of select="$unit"/></xsl:if>
        </xsl:otherwise>
      </xsl:choose>
    </td>
    <td>
      <xsl:call-template name="term">
        <xsl:with-param name="id">
          <xsl:choose><xsl:when test="status = 'rule'">iv.rule</xsl:when>
            <xsl:otherwise><xsl:value-of select="concat('status.', status)"/></xsl:otherwise></xsl:choose>
        </xsl:with-param>
        <xsl:with-param name="otherwise" select="status"/>
      </xsl:call-template>
    </td>
    <xsl:call-template name="iv-value"><xsl:with-param name="x" select="value"/></xsl:call-template>
    <xsl:call-template name="iv-value"><xsl:with-param name="x" select="low"/></xsl:call-template>
    <xsl:call-template name="iv-value"><xsl:with-param name="x" select="high"/></xsl:call-template>
    <xsl:call-template name="iv-critical">
      <xsl:with-param name="x" select="critical_at_low_m_s"/><xsl:with-param name="stands" select="stands_at_low"/>
    </xsl:call-template>
    <xsl:call-template name="iv-critical">
      <xsl:with-param name="x" select="critical_at_high_m_s"/><xsl:with-param name="stands" select="stands_at_high"/>
    </xsl:call-template>
  </tr>
</xsl:template>
</xsl:stylesheet>
