<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- The page of windfirm explain: every method against beam theory on one tree. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform">
<xsl:import href="page.xsl"/>
<xsl:include href="explained.xsl"/>

<xsl:template match="/report" mode="title">
  <xsl:call-template name="say"><xsl:with-param name="id">ex.title</xsl:with-param></xsl:call-template>
</xsl:template>
<xsl:template match="/report" mode="sub">
  <xsl:for-each select="$r/explained/item"><xsl:call-template name="run-words"/></xsl:for-each>
</xsl:template>
<xsl:template match="/report" mode="body">
  <div class="summary">
    <p><xsl:call-template name="say"><xsl:with-param name="id">ex.note</xsl:with-param></xsl:call-template></p>
    <p><xsl:for-each select="$r/scenario[gust_over_mean/value]"><xsl:call-template name="site-line"/></xsl:for-each></p>
  </div>
  <xsl:call-template name="not-looked"><xsl:with-param name="id">nl.explain</xsl:with-param></xsl:call-template>
  <xsl:apply-templates select="$r/explained/item" mode="section"/>
  <xsl:call-template name="findings"><xsl:with-param name="id">h.departures</xsl:with-param></xsl:call-template>
</xsl:template>
</xsl:stylesheet>
