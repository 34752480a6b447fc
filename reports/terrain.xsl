<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- The page of a map: heights, what shelters each place and what speeds the wind up there. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform">
<xsl:import href="page.xsl"/>

<xsl:template match="/report" mode="title">
  <xsl:call-template name="say"><xsl:with-param name="id">tr.title</xsl:with-param></xsl:call-template>
</xsl:template>
<xsl:template match="/report" mode="sub">
  <xsl:call-template name="say">
    <xsl:with-param name="id">tr.sub</xsl:with-param>
    <xsl:with-param name="a" select="concat($r/columns, ' × ', $r/rows)"/>
    <xsl:with-param name="b">
      <xsl:call-template name="given"><xsl:with-param name="x" select="$r/cell_m"/></xsl:call-template>
    </xsl:with-param>
    <xsl:with-param name="c">
      <xsl:call-template name="given"><xsl:with-param name="x" select="$r/from_deg"/></xsl:call-template>
    </xsl:with-param>
  </xsl:call-template>
</xsl:template>

<xsl:template name="range-row">
  <xsl:param name="id"/><xsl:param name="of"/><xsl:param name="unit"/>
  <tr>
    <td><xsl:call-template name="say"><xsl:with-param name="id" select="$id"/></xsl:call-template>
      <xsl:if test="$unit != ''"><xsl:value-of select="concat(', ', $unit)"/></xsl:if></td>
    <xsl:for-each select="$of/low | $of/mean | $of/high">
      <xsl:call-template name="n"><xsl:with-param name="x" select="."/></xsl:call-template>
    </xsl:for-each>
  </tr>
</xsl:template>

<xsl:template match="/report" mode="body">
  <div class="summary">
    <p>
      <xsl:call-template name="say">
        <xsl:with-param name="id">tr.summary</xsl:with-param>
        <xsl:with-param name="a" select="format-number($r/wind_factor/low, '0.00')"/>
        <xsl:with-param name="b" select="format-number($r/wind_factor/high, '0.00')"/>
        <xsl:with-param name="c">
          <xsl:call-template name="given"><xsl:with-param name="x" select="$r/height_above_ground_m"/></xsl:call-template>
        </xsl:with-param>
      </xsl:call-template>
    </p>
  </div>
  <xsl:call-template name="not-looked"><xsl:with-param name="id">nl.terrain</xsl:with-param></xsl:call-template>
  <xsl:call-template name="figure"><xsl:with-param name="name">terrain</xsl:with-param></xsl:call-template>
  <table class="data">
    <xsl:call-template name="caption"><xsl:with-param name="id">tr.ranges</xsl:with-param></xsl:call-template>
    <thead>
      <tr>
        <xsl:call-template name="heads">
          <xsl:with-param name="of">in.quantity;c.lowest:;c.mean:;c.highest:</xsl:with-param>
          <xsl:with-param name="units">no</xsl:with-param>
        </xsl:call-template>
      </tr>
    </thead>
    <tbody>
      <xsl:call-template name="range-row">
        <xsl:with-param name="id">tr.height</xsl:with-param><xsl:with-param name="of" select="$r/height_m"/>
        <xsl:with-param name="unit">m</xsl:with-param>
      </xsl:call-template>
      <xsl:call-template name="range-row">
        <xsl:with-param name="id">tr.topex</xsl:with-param><xsl:with-param name="of" select="$r/topex_deg"/>
        <xsl:with-param name="unit">°</xsl:with-param>
      </xsl:call-template>
      <xsl:call-template name="range-row">
        <xsl:with-param name="id">tr.factor</xsl:with-param><xsl:with-param name="of" select="$r/wind_factor"/>
      </xsl:call-template>
    </tbody>
  </table>
  <xsl:call-template name="findings"/>
  <xsl:call-template name="h2"><xsl:with-param name="id">h.method</xsl:with-param></xsl:call-template>
  <p><xsl:call-template name="say"><xsl:with-param name="id">tr.method</xsl:with-param></xsl:call-template></p>
  <table class="block">
    <xsl:call-template name="block-row">
      <xsl:with-param name="id">tr.file</xsl:with-param>
      <xsl:with-param name="text">
        <xsl:choose>
          <xsl:when test="$r/file != ''"><code>
            <xsl:call-template name="base-name"><xsl:with-param name="path" select="$r/file"/></xsl:call-template></code></xsl:when>
          <xsl:otherwise>
            <xsl:call-template name="say"><xsl:with-param name="id">tr.made</xsl:with-param></xsl:call-template>
          </xsl:otherwise>
        </xsl:choose>
      </xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="fact">
      <xsl:with-param name="id">tr.above</xsl:with-param><xsl:with-param name="x" select="$r/height_above_ground_m"/>
      <xsl:with-param name="unit">m</xsl:with-param>
      <xsl:with-param name="pattern">#,##0.#####</xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="fact">
      <xsl:with-param name="id">tr.roughness</xsl:with-param><xsl:with-param name="x" select="$r/roughness_m"/>
      <xsl:with-param name="unit">m</xsl:with-param>
      <xsl:with-param name="pattern">#,##0.#####</xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="fact">
      <xsl:with-param name="id">tr.distance</xsl:with-param><xsl:with-param name="x" select="$r/topex_distance_m"/>
      <xsl:with-param name="unit">m</xsl:with-param>
      <xsl:with-param name="pattern">#,##0.#####</xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="fact">
      <xsl:with-param name="id">tr.length</xsl:with-param><xsl:with-param name="x" select="$r/hill_half_width_m"/>
      <xsl:with-param name="unit">m</xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="fact">
      <xsl:with-param name="id">tr.inner</xsl:with-param><xsl:with-param name="x" select="$r/inner_layer_m"/>
      <xsl:with-param name="unit">m</xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="fact">
      <xsl:with-param name="id">tr.gain</xsl:with-param><xsl:with-param name="x" select="$r/gain"/>
    </xsl:call-template>
    <xsl:call-template name="fact">
      <xsl:with-param name="id">tr.steepest</xsl:with-param><xsl:with-param name="x" select="$r/steepest_slope"/>
    </xsl:call-template>
  </table>
</xsl:template>
</xsl:stylesheet>
