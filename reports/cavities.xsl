<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- Cavities of stems: sections, what they take, the least wall by wind. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform">

<!-- The sound wood as lines of an SVG, x to the right and y up, the numbers of two lists; null ends a line. -->
<xsl:template name="section-picture">
  <xsl:variable name="y" select="outline_y_mm/item"/>
  <xsl:variable name="size" select="2.4 * wood_radius_mm"/>
  <svg xmlns="http://www.w3.org/2000/svg" width="72" height="72" viewBox="{-0.5 * $size} {-0.5 * $size} {$size} {$size}">
    <path fill="none" stroke="#333333" stroke-width="{0.02 * $size}">
      <xsl:attribute name="d">
        <xsl:for-each select="outline_x_mm/item">
          <xsl:variable name="k" select="position()"/>
          <xsl:if test=". != ''">
            <xsl:choose>
              <xsl:when test="$k = 1 or preceding-sibling::item[1] = ''">M</xsl:when>
              <xsl:otherwise>L</xsl:otherwise>
            </xsl:choose>
            <xsl:value-of select="concat(format-number(., '0.##'), ' ', format-number(-$y[$k], '0.##'), ' ')"/>
          </xsl:if>
        </xsl:for-each>
      </xsl:attribute>
    </path>
  </svg>
</xsl:template>

<xsl:template name="cavity-row">
  <xsl:param name="name"/>
  <tr>
    <td><xsl:value-of select="$name"/></td>
    <td><xsl:if test="outline_x_mm/item"><xsl:call-template name="section-picture"/></xsl:if></td>
    <xsl:call-template name="n"><xsl:with-param name="x" select="at_m"/></xsl:call-template>
    <xsl:call-template name="cell">
      <xsl:with-param name="x" select="thinnest_wall_mm"/><xsl:with-param name="pattern">0</xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="cell">
      <xsl:with-param name="x" select="thinnest_wall_mm div wood_radius_mm"/><xsl:with-param name="pattern">0.00</xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="cell">
      <xsl:with-param name="x" select="100 * strength_loss_with_wind"/><xsl:with-param name="pattern">0</xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="cell">
      <xsl:with-param name="x" select="100 * strength_loss"/><xsl:with-param name="pattern">0</xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="cell">
      <xsl:with-param name="x" select="100 * stiffness_loss"/><xsl:with-param name="pattern">0</xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="cell">
      <xsl:with-param name="x" select="safety_basic"/><xsl:with-param name="pattern">0.00</xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="cell">
      <xsl:with-param name="x" select="safety_present"/><xsl:with-param name="pattern">0.00</xsl:with-param>
    </xsl:call-template>
  </tr>
</xsl:template>

<xsl:template name="cavity-tables">
  <table class="data">
    <xsl:call-template name="caption">
      <xsl:with-param name="id">cv.caption</xsl:with-param>
      <xsl:with-param name="a">
        <xsl:call-template name="given"><xsl:with-param name="x" select="$trees/cavities/item[1]/speed_m_s"/></xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
    <thead><tr><xsl:call-template name="heads">
      <xsl:with-param name="of">c.wt.tree;c.cv.section;c.cv.at:m;c.cv.wall:mm;c.cv.share:;c.cv.wind:%;c.cv.most:%;
        c.cv.stiffness:%;c.cv.basic:;c.cv.present:</xsl:with-param>
    </xsl:call-template></tr></thead>
    <tbody>
      <xsl:for-each select="$trees[cavities/item]">
        <xsl:variable name="name"><xsl:call-template name="name"/></xsl:variable>
        <xsl:for-each select="cavities/item">
          <xsl:call-template name="cavity-row"><xsl:with-param name="name" select="$name"/></xsl:call-template>
        </xsl:for-each>
      </xsl:for-each>
    </tbody>
  </table>
  <p>
    <xsl:for-each select="$trees/cavities/item[to_m != '']">
      <xsl:if test="position() &gt; 1"><xsl:value-of select="$gap"/></xsl:if>
      <xsl:call-template name="say">
        <xsl:with-param name="id">cv.extent</xsl:with-param>
        <xsl:with-param name="a">
          <xsl:call-template name="given"><xsl:with-param name="x" select="at_m"/></xsl:call-template></xsl:with-param>
        <xsl:with-param name="b">
          <xsl:call-template name="given"><xsl:with-param name="x" select="from_m"/></xsl:call-template></xsl:with-param>
        <xsl:with-param name="c">
          <xsl:call-template name="given"><xsl:with-param name="x" select="to_m"/></xsl:call-template></xsl:with-param>
      </xsl:call-template>
    </xsl:for-each>
  </p>
  <xsl:if test="$trees/cavities/item[open = 'true']">
    <p><xsl:call-template name="say"><xsl:with-param name="id">cv.open</xsl:with-param></xsl:call-template></p>
  </xsl:if>
  <xsl:for-each select="$trees/cavities/item"><xsl:call-template name="wall-table"/></xsl:for-each>
</xsl:template>

<!-- Least walls of one cavity. -->
<xsl:template name="wall-table">
  <xsl:variable name="c" select="."/>
  <table class="data">
    <xsl:call-template name="caption">
      <xsl:with-param name="id">cv.walls</xsl:with-param>
      <xsl:with-param name="a">
        <xsl:for-each select="../.."><xsl:call-template name="name"/></xsl:for-each>
      </xsl:with-param>
      <xsl:with-param name="b"><xsl:call-template name="given"><xsl:with-param name="x" select="at_m"/></xsl:call-template></xsl:with-param>
    </xsl:call-template>
    <thead><tr><xsl:call-template name="heads">
      <xsl:with-param name="of">c.wind:m/s;c.cv.limit.1:mm;c.cv.limit.2:mm;c.cv.limit.3:mm</xsl:with-param>
    </xsl:call-template></tr></thead>
    <tbody>
      <xsl:for-each select="../../winds/item">
        <xsl:variable name="k" select="position()"/>
        <tr>
          <xsl:call-template name="n"><xsl:with-param name="x" select="speed/value"/></xsl:call-template>
          <xsl:for-each select="$c/wall_limits/item">
            <xsl:call-template name="cell">
              <xsl:with-param name="x" select="least_walls_mm/item[$k]"/><xsl:with-param name="pattern">0</xsl:with-param>
            </xsl:call-template>
          </xsl:for-each>
        </tr>
      </xsl:for-each>
    </tbody>
  </table>
</xsl:template>
</xsl:stylesheet>
