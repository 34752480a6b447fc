<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- The page of windfirm modes: natural frequencies, with and without leaves, in still air and in wind. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform">
<xsl:import href="page.xsl"/>

<xsl:template match="/report" mode="title">
  <xsl:call-template name="say"><xsl:with-param name="id">md.title</xsl:with-param></xsl:call-template>
</xsl:template>
<xsl:template match="/report" mode="sub"><xsl:call-template name="whose"/></xsl:template>

<xsl:template name="season"><xsl:param name="of" select="season"/>
  <xsl:call-template name="term">
    <xsl:with-param name="id" select="concat('md.', $of)"/><xsl:with-param name="otherwise" select="$of"/>
  </xsl:call-template>
</xsl:template>

<!-- a share as a percentage -->
<xsl:template name="share">
  <xsl:param name="x"/>
  <xsl:call-template name="cell">
    <xsl:with-param name="x" select="100 * $x"/><xsl:with-param name="pattern">0.0</xsl:with-param>
  </xsl:call-template>
</xsl:template>
<xsl:template name="ratio">
  <xsl:param name="x"/>
  <xsl:call-template name="cell">
    <xsl:with-param name="x" select="$x"/><xsl:with-param name="pattern">0.000</xsl:with-param>
  </xsl:call-template>
</xsl:template>

<xsl:template match="blocks/item" mode="table">
  <table class="data">
    <caption>
      <xsl:call-template name="season"/>
      <xsl:call-template name="film"/>
      <xsl:call-template name="say">
        <xsl:with-param name="id">
          <xsl:choose><xsl:when test="speed &gt; 0">md.wind</xsl:when><xsl:otherwise>md.still</xsl:otherwise></xsl:choose>
        </xsl:with-param>
        <xsl:with-param name="a">
          <xsl:call-template name="given"><xsl:with-param name="x" select="speed"/></xsl:call-template>
        </xsl:with-param>
      </xsl:call-template>
    </caption>
    <thead>
      <tr>
        <xsl:call-template name="heads">
          <xsl:with-param name="of">md.c.mode;c.frequency:Hz;md.c.moves;md.c.along:%;md.c.across:%;md.c.up:%;
            md.c.turn.along:%;md.c.turn.across:%;md.c.mass:kg;md.c.wood:;md.c.air:;md.c.total:</xsl:with-param>
        </xsl:call-template>
      </tr>
    </thead>
    <tbody>
      <xsl:for-each select="modes/item">
        <tr>
          <td><xsl:value-of select="number"/></td>
          <xsl:call-template name="n"><xsl:with-param name="x" select="frequency"/></xsl:call-template>
          <td>
            <xsl:call-template name="term">
              <xsl:with-param name="id" select="concat('md.d.', direction)"/><xsl:with-param name="otherwise" select="direction"/>
            </xsl:call-template>
          </td>
          <xsl:call-template name="share"><xsl:with-param name="x" select="mass_along"/></xsl:call-template>
          <xsl:call-template name="share"><xsl:with-param name="x" select="mass_across"/></xsl:call-template>
          <xsl:call-template name="share"><xsl:with-param name="x" select="mass_up"/></xsl:call-template>
          <xsl:call-template name="share"><xsl:with-param name="x" select="turn_along"/></xsl:call-template>
          <xsl:call-template name="share"><xsl:with-param name="x" select="turn_across"/></xsl:call-template>
          <xsl:call-template name="n"><xsl:with-param name="x" select="mass_kg"/></xsl:call-template>
          <xsl:call-template name="ratio"><xsl:with-param name="x" select="structural"/></xsl:call-template>
          <xsl:call-template name="ratio"><xsl:with-param name="x" select="air"/></xsl:call-template>
          <xsl:call-template name="ratio"><xsl:with-param name="x" select="damping"/></xsl:call-template>
        </tr>
      </xsl:for-each>
      <xsl:if test="not(modes/item)">
        <tr><td colspan="12"><xsl:call-template name="say"><xsl:with-param name="id">md.none</xsl:with-param></xsl:call-template></td></tr>
      </xsl:if>
    </tbody>
  </table>
</xsl:template>

<!-- the sway of the whole tree in each state -->
<xsl:template name="sways">
  <table class="data">
    <xsl:call-template name="caption"><xsl:with-param name="id">md.sways</xsl:with-param></xsl:call-template>
    <thead>
      <tr>
        <xsl:call-template name="heads">
          <xsl:with-param name="of">md.c.leaves;md.c.wind:m/s;c.frequency:Hz;md.c.turn:%;
            md.c.mass:kg;md.c.damping.air:;md.c.total:</xsl:with-param>
        </xsl:call-template>
      </tr>
    </thead>
    <tbody>
      <xsl:for-each select="$r/blocks/item">
        <tr>
          <td><xsl:call-template name="season"/><xsl:call-template name="film"/></td>
          <td class="r"><xsl:call-template name="given"><xsl:with-param name="x" select="speed"/></xsl:call-template></td>
          <xsl:call-template name="n"><xsl:with-param name="x" select="tree_frequency"/></xsl:call-template>
          <xsl:call-template name="share"><xsl:with-param name="x" select="tree_share"/></xsl:call-template>
          <xsl:call-template name="n"><xsl:with-param name="x" select="mass_kg"/></xsl:call-template>
          <xsl:call-template name="ratio"><xsl:with-param name="x" select="air"/></xsl:call-template>
          <xsl:call-template name="ratio"><xsl:with-param name="x" select="damping"/></xsl:call-template>
        </tr>
      </xsl:for-each>
    </tbody>
  </table>
</xsl:template>

<xsl:template match="measured">
  <xsl:call-template name="h2"><xsl:with-param name="id">md.h.measured</xsl:with-param></xsl:call-template>
  <p>
    <xsl:call-template name="say">
      <xsl:with-param name="id">
        <xsl:choose><xsl:when test="conifer = 'true'">md.line</xsl:when><xsl:otherwise>md.other</xsl:otherwise></xsl:choose>
      </xsl:with-param>
      <xsl:with-param name="a" select="format-number(line_first_Hz, '0.0000')"/>
      <xsl:with-param name="b" select="format-number(line_slope_Hz_m, '0.0')"/>
    </xsl:call-template>
  </p>
  <table class="block">
    <xsl:call-template name="block-row"><xsl:with-param name="id">md.trees</xsl:with-param>
      <xsl:with-param name="text"><xsl:call-template name="term">
        <xsl:with-param name="id" select="concat('md.t.', translate(of, ' ', '_'))"/><xsl:with-param name="otherwise" select="of"/>
      </xsl:call-template></xsl:with-param></xsl:call-template>
    <xsl:call-template name="fact"><xsl:with-param name="id">md.diameter</xsl:with-param>
      <xsl:with-param name="x" select="diameter_m"/><xsl:with-param name="unit">m</xsl:with-param></xsl:call-template>
    <xsl:call-template name="fact"><xsl:with-param name="id">md.height</xsl:with-param>
      <xsl:with-param name="x" select="height"/><xsl:with-param name="unit">m</xsl:with-param></xsl:call-template>
    <xsl:call-template name="fact"><xsl:with-param name="id">md.measured</xsl:with-param>
      <xsl:with-param name="x" select="frequency"/><xsl:with-param name="unit">Hz</xsl:with-param></xsl:call-template>
    <xsl:for-each select="$r/blocks/item[ratio_to_measured]">
      <tr>
        <th><xsl:call-template name="season"/></th>
        <td>
          <xsl:call-template name="say">
            <xsl:with-param name="id">md.ratio</xsl:with-param>
            <xsl:with-param name="a">
              <xsl:call-template name="number"><xsl:with-param name="x" select="tree_frequency"/></xsl:call-template>
            </xsl:with-param>
            <xsl:with-param name="b">
              <xsl:call-template name="number"><xsl:with-param name="x" select="ratio_to_measured"/></xsl:call-template>
            </xsl:with-param>
          </xsl:call-template>
        </td>
      </tr>
    </xsl:for-each>
    <xsl:call-template name="block-row"><xsl:with-param name="id">md.source</xsl:with-param>
      <xsl:with-param name="text"><xsl:call-template name="fine"><xsl:with-param name="text" select="source"/></xsl:call-template>
      </xsl:with-param></xsl:call-template>
  </table>
</xsl:template>

<xsl:template match="/report" mode="body">
  <div class="summary">
    <p><xsl:call-template name="say"><xsl:with-param name="id">md.note</xsl:with-param></xsl:call-template></p>
    <p><xsl:for-each select="$r/scenario[gust_over_mean/value]"><xsl:call-template name="site-line"/></xsl:for-each></p>
  </div>
  <xsl:call-template name="not-looked"><xsl:with-param name="id">nl.modes</xsl:with-param></xsl:call-template>
  <xsl:call-template name="h2"><xsl:with-param name="id">md.h.sways</xsl:with-param></xsl:call-template>
  <xsl:call-template name="sways"/>
  <xsl:call-template name="h2"><xsl:with-param name="id">md.h.modes</xsl:with-param></xsl:call-template>
  <xsl:apply-templates select="$r/blocks/item" mode="table"/>
  <p><xsl:call-template name="say"><xsl:with-param name="id">md.columns</xsl:with-param></xsl:call-template></p>
  <xsl:if test="$r/blocks/item[damping_known = 'false']">
    <p><xsl:call-template name="say"><xsl:with-param name="id">md.assumed</xsl:with-param></xsl:call-template></p>
  </xsl:if>
  <xsl:apply-templates select="$r/measured"/>
  <xsl:call-template name="h2"><xsl:with-param name="id">md.h.shapes</xsl:with-param></xsl:call-template>
  <xsl:for-each select="$r/blocks/item">
    <xsl:call-template name="figure">
      <xsl:with-param name="name" select="concat('modes_', run)"/><xsl:with-param name="id">cap.modes</xsl:with-param>
      <xsl:with-param name="a"><xsl:call-template name="season"/></xsl:with-param>
    </xsl:call-template>
  </xsl:for-each>
  <xsl:call-template name="findings"/>
</xsl:template>

<!-- Depth of the rain on the leaves, where there is some. -->
<xsl:template name="film">
  <xsl:if test="film_mm">
    <xsl:text> (</xsl:text>
    <xsl:call-template name="given"><xsl:with-param name="x" select="film_mm"/></xsl:call-template>
    <xsl:text>&#160;mm)</xsl:text>
  </xsl:if>
</xsl:template>
</xsl:stylesheet>
