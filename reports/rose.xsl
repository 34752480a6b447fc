<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- The page of a wind climate: the rose, and hours a year by direction and strength. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform">
<xsl:import href="page.xsl"/>

<xsl:template match="/report" mode="title">
  <xsl:call-template name="say"><xsl:with-param name="id">rs.title</xsl:with-param></xsl:call-template>
</xsl:template>
<xsl:template match="/report" mode="sub">
  <xsl:call-template name="base-name"><xsl:with-param name="path" select="$r/file"/></xsl:call-template>
</xsl:template>

<xsl:template name="hours-row">
  <xsl:call-template name="n"><xsl:with-param name="x" select="frequency"/></xsl:call-template>
  <xsl:call-template name="n"><xsl:with-param name="x" select="mean_m_s"/></xsl:call-template>
  <xsl:call-template name="n"><xsl:with-param name="x" select="shape"/></xsl:call-template>
  <xsl:for-each select="hours_a_year_above/item">
    <xsl:call-template name="n"><xsl:with-param name="x" select="."/></xsl:call-template>
  </xsl:for-each>
</xsl:template>

<xsl:template match="/report" mode="body">
  <div class="summary">
    <p>
      <xsl:call-template name="say">
        <xsl:with-param name="id">rs.summary</xsl:with-param>
        <xsl:with-param name="a">
          <xsl:call-template name="number"><xsl:with-param name="x" select="$r/all/mean_m_s"/></xsl:call-template>
        </xsl:with-param>
        <xsl:with-param name="b">
          <xsl:call-template name="number">
            <xsl:with-param name="x" select="$r/speed_exceeded_1_percent_m_s"/>
          </xsl:call-template>
        </xsl:with-param>
        <xsl:with-param name="c">
          <xsl:call-template name="number">
            <xsl:with-param name="x" select="$r/speed_exceeded_0_1_percent_m_s"/>
          </xsl:call-template>
        </xsl:with-param>
      </xsl:call-template>
    </p>
  </div>
  <xsl:call-template name="not-looked"><xsl:with-param name="id">nl.rose</xsl:with-param></xsl:call-template>
  <xsl:call-template name="figure">
    <xsl:with-param name="name">wind_rose</xsl:with-param>
    <xsl:with-param name="width">70%</xsl:with-param>
  </xsl:call-template>
  <table class="data">
    <xsl:call-template name="caption">
      <xsl:with-param name="id">rs.table<xsl:if test="$r/record">.record</xsl:if></xsl:with-param>
      <xsl:with-param name="a">
        <xsl:call-template name="given"><xsl:with-param name="x" select="$r/typed_sum"/></xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
    <thead>
      <tr>
        <xsl:call-template name="heads">
          <xsl:with-param name="of">c.from:°;c.frequency:–;c.mean:m/s;c.shape:–</xsl:with-param>
        </xsl:call-template>
        <xsl:for-each select="$r/classes_m_s/item">
          <th class="r">
            <xsl:call-template name="say">
              <xsl:with-param name="id">rs.above</xsl:with-param>
              <xsl:with-param name="a" select="."/>
            </xsl:call-template>
            <span class="u">h/a</span>
          </th>
        </xsl:for-each>
      </tr>
    </thead>
    <tbody class="long">
      <xsl:for-each select="$r/sectors/item">
        <tr>
          <xsl:call-template name="cell">
            <xsl:with-param name="x" select="from_deg"/><xsl:with-param name="pattern">0.#</xsl:with-param>
          </xsl:call-template>
          <xsl:call-template name="hours-row"/>
        </tr>
      </xsl:for-each>
    </tbody>
    <tbody>
      <tr>
        <td class="r">
          <b><xsl:call-template name="say"><xsl:with-param name="id">rs.all</xsl:with-param></xsl:call-template></b>
        </td>
        <xsl:for-each select="$r/all"><xsl:call-template name="hours-row"/></xsl:for-each>
      </tr>
    </tbody>
  </table>
  <xsl:if test="$r/record"><xsl:call-template name="record"/></xsl:if>
  <xsl:call-template name="findings"/>
</xsl:template>

<!-- A rose from a record: what the record has, what was fitted. -->
<xsl:template name="record">
  <xsl:variable name="of" select="$r/record"/>
  <xsl:call-template name="h2"><xsl:with-param name="id">rs.h.record</xsl:with-param></xsl:call-template>
  <p>
    <xsl:call-template name="say">
      <xsl:with-param name="id">rs.record</xsl:with-param>
      <xsl:with-param name="a" select="$of/rows"/>
      <xsl:with-param name="b" select="$of/directed"/>
      <xsl:with-param name="c" select="concat($of/calm, ' (', format-number(100 * $of/calm_share, '0.0'), ' %)')"/>
      <xsl:with-param name="d"
        select="concat($of/undirected, ' (', format-number(100 * $of/undirected_share, '0.0'), ' %)')"/>
    </xsl:call-template>
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
      <xsl:with-param name="id">rs.record.lost</xsl:with-param>
      <xsl:with-param name="a" select="$of/without_speed"/>
    </xsl:call-template>
  </p>
  <xsl:call-template name="figure">
    <xsl:with-param name="name">rose_record</xsl:with-param>
    <xsl:with-param name="width">70%</xsl:with-param>
  </xsl:call-template>
  <table class="data">
    <xsl:call-template name="caption"><xsl:with-param name="id">rs.fits</xsl:with-param></xsl:call-template>
    <thead>
      <tr>
        <xsl:call-template name="heads">
          <xsl:with-param name="of">c.from:°;c.record.hours:;c.weibull.a:m/s;c.error:m/s;c.shape:–;c.error:–</xsl:with-param>
        </xsl:call-template>
      </tr>
    </thead>
    <tbody class="long">
      <xsl:for-each select="$of/fits/item">
        <tr>
          <xsl:choose>
            <xsl:when test="position() = last()">
              <td class="r">
                <b><xsl:call-template name="say"><xsl:with-param name="id">rs.all</xsl:with-param></xsl:call-template></b>
              </td>
            </xsl:when>
            <xsl:otherwise>
              <xsl:call-template name="cell">
                <xsl:with-param name="x" select="from_deg"/><xsl:with-param name="pattern">0.#</xsl:with-param>
              </xsl:call-template>
            </xsl:otherwise>
          </xsl:choose>
          <td class="r"><xsl:value-of select="hours"/></td>
          <xsl:call-template name="cell">
            <xsl:with-param name="x" select="scale_m_s"/><xsl:with-param name="pattern">0.00</xsl:with-param>
          </xsl:call-template>
          <xsl:call-template name="cell">
            <xsl:with-param name="x" select="scale_error_m_s"/><xsl:with-param name="pattern">0.00</xsl:with-param>
          </xsl:call-template>
          <xsl:call-template name="n"><xsl:with-param name="x" select="shape"/></xsl:call-template>
          <xsl:call-template name="cell">
            <xsl:with-param name="x" select="shape_error"/><xsl:with-param name="pattern">0.00</xsl:with-param>
          </xsl:call-template>
        </tr>
      </xsl:for-each>
    </tbody>
  </table>
</xsl:template>
</xsl:stylesheet>
