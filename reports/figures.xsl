<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- From the results to what the figure scripts must know about one run: rows of plots/run.csv, which the program
     checks and writes. A row holds a number, or a text where it says so. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform">
<xsl:import href="words.xsl"/>
<xsl:variable name="units" select="/.."/>
<xsl:output method="xml" encoding="UTF-8"/>

<xsl:template name="number-row">
  <xsl:param name="key"/><xsl:param name="index" select="0"/><xsl:param name="x"/>
  <row key="{$key}" index="{$index}"><xsl:choose>
    <xsl:when test="not($x) or $x = ''">NaN</xsl:when>
    <xsl:otherwise><xsl:value-of select="$x"/></xsl:otherwise>
  </xsl:choose></row>
</xsl:template>
<xsl:template name="text-row">
  <xsl:param name="key"/><xsl:param name="index" select="0"/><xsl:param name="text"/>
  <xsl:param name="kind">yes</xsl:param>
  <row key="{$key}" index="{$index}" text="{$kind}"><xsl:value-of select="normalize-space($text)"/></row>
</xsl:template>

<!-- name, height [m], direction of the wind [rad], segments, wind speed at which the tree is lost [m/s]; which of the wind speeds
     drawn have an answer, by number -->
<xsl:template match="item" mode="tree">
  <xsl:variable name="i" select="position()"/>
  <xsl:call-template name="text-row">
    <xsl:with-param name="key">NAME</xsl:with-param><xsl:with-param name="index" select="$i"/>
    <xsl:with-param name="text"><xsl:call-template name="name"/></xsl:with-param>
  </xsl:call-template>
  <xsl:call-template name="number-row">
    <xsl:with-param name="key">HEIGHT_M</xsl:with-param><xsl:with-param name="index" select="$i"/>
    <xsl:with-param name="x" select="height/value"/>
  </xsl:call-template>
  <xsl:call-template name="number-row">
    <xsl:with-param name="key">AZIMUTH</xsl:with-param><xsl:with-param name="index" select="$i"/>
    <xsl:with-param name="x" select="scenario/azimuth/value"/>
  </xsl:call-template>
  <xsl:call-template name="number-row">
    <xsl:with-param name="key">ROWS</xsl:with-param><xsl:with-param name="index" select="$i"/>
    <xsl:with-param name="x" select="segments"/>
  </xsl:call-template>
  <xsl:variable name="known" select="boolean(verdict/criteria/item[governs = 'true'])"/>
  <xsl:call-template name="number-row">
    <xsl:with-param name="key">CRITICAL</xsl:with-param><xsl:with-param name="index" select="$i"/>
    <xsl:with-param name="x" select="self::*[not($known)]/critical[within_limits = 'true']/speed/value |
      verdict[$known and within_limits = 'true']/critical_speed/value"/>
  </xsl:call-template>
  <!-- the crown as it was measured: an ellipse, where its area is that of one -->
  <xsl:variable name="m" select="model[outline_breadth/value != '']"/>
  <xsl:variable name="share" select="$m/frontal_area/value div ($m/outline_breadth/value * $m/outline_height/value)"/>
  <xsl:if test="$share &gt; 0.78 and $share &lt; 0.79">
    <xsl:for-each select="$m/outline_breadth | $m/outline_centre | $m/outline_height">
      <xsl:call-template name="number-row">
        <xsl:with-param name="key" select="concat('CROWN_', translate(substring-after(name(), '_'), 'abcdefghijklmnopqrstuvwxyz',
            'ABCDEFGHIJKLMNOPQRSTUVWXYZ'))"/>
        <xsl:with-param name="index" select="$i"/>
        <xsl:with-param name="x" select="value"/>
      </xsl:call-template>
    </xsl:for-each>
  </xsl:if>
  <!-- results that do not say which criterion governs have no column of the tree's safety in their tables -->
  <xsl:call-template name="number-row">
    <xsl:with-param name="key">LOSS_KNOWN</xsl:with-param><xsl:with-param name="index" select="$i"/>
    <xsl:with-param name="x" select="number($known)"/>
  </xsl:call-template>
  <xsl:call-template name="text-row">
    <xsl:with-param name="key">SOLVED</xsl:with-param><xsl:with-param name="index" select="$i"/>
    <xsl:with-param name="kind">words</xsl:with-param>
    <xsl:with-param name="text">
      <xsl:for-each select="winds/item[contains($shown, concat(' ', count(preceding-sibling::item) + 1, ' '))]">
        <xsl:if test="status = 'ok'"><xsl:value-of select="concat(position(), ' ')"/></xsl:if>
      </xsl:for-each>
    </xsl:with-param>
  </xsl:call-template>
</xsl:template>

<xsl:template name="beside-rows">
  <xsl:variable name="i" select="position()"/>
  <xsl:call-template name="text-row">
    <xsl:with-param name="key">BESIDE_NAME</xsl:with-param><xsl:with-param name="index" select="$i"/>
    <xsl:with-param name="text">
      <xsl:if test="count($trees) &gt; 1"><xsl:for-each select="../.."><xsl:call-template name="name"/>: </xsl:for-each></xsl:if>
      <xsl:value-of select="name"/>
      <xsl:if test="name = ''">
        <xsl:call-template name="say"><xsl:with-param name="id">sc.stands</xsl:with-param></xsl:call-template></xsl:if>
    </xsl:with-param>
  </xsl:call-template>
  <xsl:call-template name="number-row">
    <xsl:with-param name="key">BESIDE_STEM</xsl:with-param><xsl:with-param name="index" select="$i"/>
    <xsl:with-param name="x" select="breakage/value | self::*[not(word)]/safety/value"/>
  </xsl:call-template>
  <xsl:call-template name="number-row">
    <xsl:with-param name="key">BESIDE_ROOT</xsl:with-param><xsl:with-param name="index" select="$i"/>
    <xsl:with-param name="x" select="overturning/value"/>
  </xsl:call-template>
  <xsl:call-template name="number-row">
    <xsl:with-param name="key">BESIDE_BRANCHES</xsl:with-param><xsl:with-param name="index" select="$i"/>
    <xsl:with-param name="x" select="branch_safety/value"/>
  </xsl:call-template>
</xsl:template>

<xsl:template match="/report">
  <xsl:variable name="drawn"
                select="$trees[1]/winds/item[contains($shown, concat(' ', count(preceding-sibling::item) + 1, ' '))]"/>
  <rows>
    <xsl:call-template name="number-row">
      <xsl:with-param name="key">trees</xsl:with-param><xsl:with-param name="x" select="count($trees)"/>
    </xsl:call-template>
    <xsl:apply-templates select="$trees" mode="tree"/>
    <!-- wind speeds drawn [m/s]; trees with a known strength, by number -->
    <xsl:call-template name="number-row">
      <xsl:with-param name="key">winds</xsl:with-param><xsl:with-param name="x" select="count($drawn)"/>
    </xsl:call-template>
    <xsl:for-each select="$drawn">
      <xsl:call-template name="number-row">
        <xsl:with-param name="key">WIND</xsl:with-param><xsl:with-param name="index" select="position()"/>
        <xsl:with-param name="x" select="speed/value"/>
      </xsl:call-template>
    </xsl:for-each>
    <xsl:call-template name="number-row">
      <xsl:with-param name="key">WIND_LAST</xsl:with-param>
      <xsl:with-param name="x" select="$trees[1]/winds/item[last()]/speed/value"/>
    </xsl:call-template>
    <xsl:call-template name="number-row">
      <xsl:with-param name="key">REFERENCE</xsl:with-param>
      <xsl:with-param name="x" select="($trees[1]/scenario/wind_height | $trees[1]/scenario[not(wind_height)]/reference_height)/value"/>
    </xsl:call-template>
    <xsl:call-template name="text-row">
      <xsl:with-param name="key">STRONG</xsl:with-param>
      <xsl:with-param name="kind">words</xsl:with-param>
      <xsl:with-param name="text">
        <xsl:for-each select="$trees">
          <xsl:if test="winds/item/*[self::least_safety or self::loss_safety]/value != ''">
            <xsl:value-of select="concat(position(), ' ')"/>
          </xsl:if>
        </xsl:for-each>
      </xsl:with-param>
    </xsl:call-template>
    <!-- the trees beside themselves: names, and safeties of stem (of an analysis against loss of any kind), root, branches -->
    <xsl:variable name="beside" select="$trees/scenarios/item"/>
    <xsl:call-template name="number-row">
      <xsl:with-param name="key">BESIDE</xsl:with-param><xsl:with-param name="x" select="count($beside)"/>
    </xsl:call-template>
    <xsl:if test="$beside/word">
      <xsl:call-template name="number-row">
        <xsl:with-param name="key">REQUIRED</xsl:with-param><xsl:with-param name="x" select="$trees[1]/assessment/required"/>
      </xsl:call-template>
    </xsl:if>
    <xsl:for-each select="$beside"><xsl:call-template name="beside-rows"/></xsl:for-each>
    <xsl:call-template name="number-row">
      <xsl:with-param name="key">SPEED_MAX</xsl:with-param>
      <xsl:with-param name="x"><xsl:call-template name="speed-end"/></xsl:with-param>
    </xsl:call-template>
  </rows>
</xsl:template>
</xsl:stylesheet>
