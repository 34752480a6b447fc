<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- The page of windfirm fragility: how likely a tree is lost in which wind. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform">
<xsl:import href="page.xsl"/>
<xsl:include href="interval.xsl"/>

<xsl:template match="/report" mode="title">
  <xsl:call-template name="say"><xsl:with-param name="id">fr.title</xsl:with-param></xsl:call-template>
</xsl:template>
<xsl:template match="/report" mode="sub"><xsl:call-template name="whose"/></xsl:template>

<xsl:template match="/report" mode="body">
  <div class="summary">
    <p>
      <xsl:for-each select="$r/interval">
        <xsl:call-template name="iv-words">
          <xsl:with-param name="name"><xsl:call-template name="whose"/></xsl:with-param>
        </xsl:call-template>
        <xsl:value-of select="$gap"/>
        <xsl:if test="lognormal/median_m_s != ''">
          <xsl:call-template name="say">
            <xsl:with-param name="id">fr.law</xsl:with-param>
            <xsl:with-param name="a" select="format-number(lognormal/median_m_s, '0.0')"/>
            <xsl:with-param name="b" select="format-number(lognormal/beta, '0.00')"/>
            <xsl:with-param name="c" select="lognormal/censored"/>
            <xsl:with-param name="d">
              <xsl:call-template name="given"><xsl:with-param name="x" select="searched_to_m_s"/></xsl:call-template>
            </xsl:with-param>
          </xsl:call-template>
          <xsl:value-of select="$gap"/>
        </xsl:if>
      </xsl:for-each>
      <xsl:call-template name="say">
        <xsl:with-param name="id">fr.place</xsl:with-param>
        <xsl:with-param name="a">
          <xsl:call-template name="given"><xsl:with-param name="x" select="$r/reference_height_m"/></xsl:call-template>
        </xsl:with-param>
        <xsl:with-param name="b" select="$r/wind_terrain"/>
      </xsl:call-template>
    </p>
    <p><xsl:call-template name="say"><xsl:with-param name="id">iv.note</xsl:with-param></xsl:call-template></p>
  </div>
  <xsl:call-template name="not-looked"><xsl:with-param name="id">nl.fragility</xsl:with-param></xsl:call-template>
  <xsl:call-template name="h2"><xsl:with-param name="id">fr.h.curve</xsl:with-param></xsl:call-template>
  <xsl:call-template name="figure"><xsl:with-param name="name">fragility</xsl:with-param></xsl:call-template>
  <xsl:call-template name="h2"><xsl:with-param name="id">h.interval</xsl:with-param></xsl:call-template>
  <xsl:for-each select="$r/interval">
    <xsl:call-template name="iv-safety"><xsl:with-param name="name"><xsl:call-template name="whose"/></xsl:with-param></xsl:call-template>
    <xsl:call-template name="iv-tornado"><xsl:with-param name="name"><xsl:call-template name="whose"/></xsl:with-param></xsl:call-template>
  </xsl:for-each>
  <xsl:call-template name="findings"/>
</xsl:template>
</xsl:stylesheet>
