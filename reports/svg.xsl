<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- From gnuplot's SVG to a plain one that can stand inside a page: references to point symbols are replaced
     by the symbols, currentColor by the colour meant, identifiers are dropped (several figures share a page),
     fonts are those of the page. WeasyPrint 57 cannot draw currentColor in a referenced symbol. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform" xmlns="http://www.w3.org/2000/svg"
                xmlns:svg="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"
                exclude-result-prefixes="svg xlink">
<xsl:output method="xml" encoding="UTF-8"/>
<xsl:key name="symbol" match="*[@id]" use="concat('#', @id)"/>

<xsl:template match="svg:*">
  <xsl:element name="{local-name()}"><xsl:apply-templates select="@*|node()"/></xsl:element>
</xsl:template>
<xsl:template match="@*"><xsl:copy/></xsl:template>
<xsl:template match="@id|@color|@class|comment()|svg:title|svg:desc|svg:defs|svg:script|@*[starts-with(name(), 'on')]"/>
<xsl:template match="@font-family">
  <xsl:attribute name="font-family">Liberation Sans, DejaVu Sans, WenQuanYi Micro Hei, sans-serif</xsl:attribute>
</xsl:template>
<xsl:template match="@*[. = 'currentColor']">
  <xsl:attribute name="{name()}"><xsl:value-of select="ancestor::*[@color][1]/@color"/></xsl:attribute>
</xsl:template>
<!-- empty groups are most of gnuplot's file -->
<xsl:template match="svg:g[not(.//svg:path|.//svg:text|.//svg:use|.//svg:polygon|.//svg:rect|.//svg:circle|.//svg:image)]"/>
<!-- a group of one line or text is that alone: WeasyPrint needs as long for a group as for what is in it -->
<xsl:template match="svg:g[count(*) = 1 and (svg:path or svg:text) and not(*/@transform)]">
  <xsl:for-each select="*">
    <xsl:element name="{local-name()}">
      <xsl:apply-templates select="../@*"/>
      <xsl:apply-templates select="@*|node()"/>
    </xsl:element>
  </xsl:for-each>
</xsl:template>
<!-- a map of points stands in the file itself -->
<xsl:template match="svg:image">
  <image><xsl:copy-of select="@x|@y|@width|@height|@preserveAspectRatio"/>
    <xsl:if test="starts-with(@xlink:href, 'data:image/png;base64,')"><xsl:attribute name="href"><xsl:value-of
      select="@xlink:href"/></xsl:attribute></xsl:if></image>
</xsl:template>

<xsl:template match="svg:use">
  <xsl:variable name="colour">
    <xsl:choose>
      <xsl:when test="ancestor-or-self::*[@color]"><xsl:value-of select="ancestor-or-self::*[@color][1]/@color"/></xsl:when>
      <xsl:otherwise>black</xsl:otherwise>
    </xsl:choose>
  </xsl:variable>
  <g>
    <xsl:copy-of select="@transform|@stroke-width"/>
    <xsl:if test="@x or @y">
      <xsl:attribute name="transform">translate(<xsl:value-of select="concat(@x, ',', @y)"/>)</xsl:attribute>
    </xsl:if>
    <xsl:apply-templates select="key('symbol', @xlink:href)" mode="symbol">
      <xsl:with-param name="colour" select="$colour"/>
      <xsl:with-param name="filled" select="@fill = 'currentColor'"/>
    </xsl:apply-templates>
  </g>
</xsl:template>

<!-- a symbol may itself be made of another one, turned or filled -->
<xsl:template match="svg:use" mode="symbol">
  <xsl:param name="colour"/><xsl:param name="filled"/>
  <g>
    <xsl:copy-of select="@transform"/>
    <xsl:apply-templates select="key('symbol', @xlink:href)" mode="symbol">
      <xsl:with-param name="colour" select="$colour"/>
      <xsl:with-param name="filled" select="$filled or @fill = 'currentColor'"/>
    </xsl:apply-templates>
  </g>
</xsl:template>
<xsl:template match="*" mode="symbol">
  <xsl:param name="colour"/><xsl:param name="filled"/>
  <xsl:element name="{local-name()}">
    <xsl:copy-of select="@*[name() != 'id' and . != 'currentColor']"/>
    <xsl:attribute name="stroke"><xsl:value-of select="$colour"/></xsl:attribute>
    <xsl:attribute name="fill">
      <xsl:choose>
        <xsl:when test="$filled or @fill = 'currentColor'"><xsl:value-of select="$colour"/></xsl:when>
        <xsl:otherwise>none</xsl:otherwise>
      </xsl:choose>
    </xsl:attribute>
  </xsl:element>
</xsl:template>
</xsl:stylesheet>
