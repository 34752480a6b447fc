<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- The page of windfirm wind extremes: how often a wind is exceeded. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform">
<xsl:import href="page.xsl"/>

<xsl:template match="/report" mode="title">
  <xsl:call-template name="say"><xsl:with-param name="id">xt.title</xsl:with-param></xsl:call-template>
</xsl:template>
<xsl:template match="/report" mode="sub">
  <xsl:call-template name="base-name"><xsl:with-param name="path" select="$r/source"/></xsl:call-template>
</xsl:template>

<xsl:variable name="years">
  <xsl:call-template name="say"><xsl:with-param name="id">unit.years</xsl:with-param></xsl:call-template>
</xsl:variable>

<xsl:template name="ex-levels">
  <table class="data">
    <xsl:call-template name="caption">
      <xsl:with-param name="id">xt.levels<xsl:if test="$r/years = 0">.none</xsl:if></xsl:with-param>
      <xsl:with-param name="a" select="$r/years"/>
    </xsl:call-template>
    <thead>
      <tr>
        <xsl:call-template name="heads">
          <xsl:with-param name="of" select="concat('c.years:', $years, ';c.mean10:m/s;c.gust3:m/s')"/>
        </xsl:call-template>
        <xsl:if test="$r/years &gt; 0">
          <xsl:call-template name="heads"><xsl:with-param name="of">c.low5:m/s;c.high95:m/s</xsl:with-param></xsl:call-template>
        </xsl:if>
        <xsl:for-each select="$r/methods/item">
          <xsl:call-template name="heads">
            <xsl:with-param name="of" select="concat('xt.', fitted_by, ':m/s')"/>
          </xsl:call-template>
        </xsl:for-each>
      </tr>
    </thead>
    <tbody>
      <xsl:for-each select="$r/fit/levels/item">
        <xsl:variable name="i" select="position()"/>
        <tr>
          <td class="r"><xsl:call-template name="given"><xsl:with-param name="x" select="years"/></xsl:call-template></td>
          <xsl:call-template name="cell"><xsl:with-param name="x" select="speed_m_s"/></xsl:call-template>
          <xsl:call-template name="cell"><xsl:with-param name="x" select="gust_m_s"/></xsl:call-template>
          <xsl:if test="$r/years &gt; 0">
            <xsl:call-template name="cell"><xsl:with-param name="x" select="low_m_s"/></xsl:call-template>
            <xsl:call-template name="cell"><xsl:with-param name="x" select="high_m_s"/></xsl:call-template>
          </xsl:if>
          <xsl:for-each select="$r/methods/item">
            <xsl:call-template name="cell"><xsl:with-param name="x" select="levels/item[$i]/speed_m_s"/></xsl:call-template>
          </xsl:for-each>
        </tr>
      </xsl:for-each>
    </tbody>
  </table>
</xsl:template>

<xsl:template name="ex-winds">
  <table class="data">
    <xsl:call-template name="caption">
      <xsl:with-param name="id">xt.winds</xsl:with-param>
      <xsl:with-param name="a"><xsl:call-template name="given"><xsl:with-param name="x" select="$r/life_years"/></xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
    <thead>
      <tr>
        <xsl:call-template name="heads">
          <xsl:with-param name="of" select="concat('c.mean10:m/s;c.gust3:m/s;c.chance:–;c.years:', $years)"/>
        </xsl:call-template>
        <th class="r">
          <xsl:call-template name="say">
            <xsl:with-param name="id">c.chance.life</xsl:with-param>
            <xsl:with-param name="a"><xsl:call-template name="given"><xsl:with-param name="x" select="$r/life_years"/></xsl:call-template>
            </xsl:with-param>
          </xsl:call-template>
          <span class="u">–&#160;</span>
        </th>
      </tr>
    </thead>
    <tbody>
      <xsl:for-each select="$r/winds/item">
        <tr>
          <td class="r"><xsl:call-template name="given"><xsl:with-param name="x" select="speed_m_s"/></xsl:call-template></td>
          <xsl:call-template name="cell"><xsl:with-param name="x" select="gust_m_s"/></xsl:call-template>
          <td class="r"><xsl:value-of select="exceedance_a_year_text"/></td>
          <td class="r">
            <xsl:choose>
              <xsl:when test="return_period_years = ''">&gt; 1 000 000</xsl:when>
              <xsl:otherwise>
                <xsl:call-template name="number"><xsl:with-param name="x" select="return_period_years"/></xsl:call-template>
              </xsl:otherwise>
            </xsl:choose>
          </td>
          <td class="r"><xsl:value-of select="exceedance_over_life_text"/></td>
        </tr>
      </xsl:for-each>
    </tbody>
  </table>
</xsl:template>

<xsl:template match="/report" mode="body">
  <xsl:variable name="fifty" select="$r/fit/levels/item[years = 50]"/>
  <div class="summary">
    <p>
      <xsl:if test="$fifty">
        <xsl:call-template name="say">
          <xsl:with-param name="id">xt.fifty</xsl:with-param>
          <xsl:with-param name="a" select="format-number($fifty/speed_m_s, '0.0')"/>
          <xsl:with-param name="b" select="format-number($fifty/gust_m_s, '0.0')"/>
        </xsl:call-template>
        <xsl:value-of select="$gap"/>
        <xsl:if test="$r/years &gt; 0">
          <xsl:call-template name="say">
            <xsl:with-param name="id">xt.band</xsl:with-param>
            <xsl:with-param name="a" select="format-number($fifty/low_m_s, '0')"/>
            <xsl:with-param name="b" select="format-number($fifty/high_m_s, '0')"/>
            <xsl:with-param name="c" select="$r/years"/>
          </xsl:call-template>
          <xsl:value-of select="$gap"/>
        </xsl:if>
      </xsl:if>
      <xsl:call-template name="say"><xsl:with-param name="id">xt.place</xsl:with-param></xsl:call-template>
      <xsl:if test="$r/averaging_factor != 1">
        <xsl:value-of select="$gap"/>
        <xsl:call-template name="say">
          <xsl:with-param name="id">xt.factor</xsl:with-param>
          <xsl:with-param name="a" select="format-number($r/averaging_factor, '0.000')"/>
        </xsl:call-template>
      </xsl:if>
    </p>
    <p><xsl:call-template name="say"><xsl:with-param name="id">xt.not</xsl:with-param></xsl:call-template></p>
  </div>
  <xsl:call-template name="figure"><xsl:with-param name="name">extremes</xsl:with-param></xsl:call-template>
  <xsl:call-template name="ex-levels"/>
  <xsl:if test="$r/winds/item"><xsl:call-template name="ex-winds"/></xsl:if>
  <xsl:call-template name="findings"/>
</xsl:template>
</xsl:stylesheet>
