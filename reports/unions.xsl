<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- Unions of branches and forks: how many of each class, the largest aspect ratios. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform">

<xsl:template name="union-row">
  <tr>
    <td><xsl:if test="position() = 1">
      <xsl:for-each select="../../.."><xsl:call-template name="name"/></xsl:for-each>
    </xsl:if></td>
    <xsl:call-template name="cell"><xsl:with-param name="x" select="height/value"/></xsl:call-template>
    <xsl:call-template name="cell"><xsl:with-param name="x" select="100 * branch_diameter/value"/></xsl:call-template>
    <xsl:call-template name="cell"><xsl:with-param name="x" select="100 * above_diameter/value"/></xsl:call-template>
    <xsl:call-template name="cell"><xsl:with-param name="x" select="100 * below_diameter/value"/></xsl:call-template>
    <xsl:call-template name="cell">
      <xsl:with-param name="x" select="aspect_ratio"/><xsl:with-param name="pattern">0.00</xsl:with-param>
    </xsl:call-template>
    <td>
      <xsl:call-template name="say"><xsl:with-param name="id" select="concat('un.', kind)"/></xsl:call-template>
    </td>
  </tr>
</xsl:template>

<!-- Of one tree: how many of each class. -->
<xsl:template name="union-classes">
  <xsl:variable name="name"><xsl:call-template name="name"/></xsl:variable>
  <p>
    <xsl:call-template name="say">
      <xsl:with-param name="id">un.number</xsl:with-param>
      <xsl:with-param name="a" select="$name"/><xsl:with-param name="b" select="unions/number"/>
    </xsl:call-template>
    <xsl:for-each select="unions/union_classes/item[number &gt; 0]">
      <xsl:text> </xsl:text>
      <xsl:call-template name="say">
        <xsl:with-param name="id">un.class</xsl:with-param>
        <xsl:with-param name="a" select="number"/>
        <xsl:with-param name="b">
          <xsl:call-template name="say"><xsl:with-param name="id" select="concat('un.', kind)"/></xsl:call-template>
        </xsl:with-param>
      </xsl:call-template>
    </xsl:for-each>
  </p>
</xsl:template>

<xsl:template name="union-tables">
  <xsl:if test="$trees/unions/largest_unions/item">
    <table class="data">
      <xsl:call-template name="caption">
        <xsl:with-param name="id">un.caption</xsl:with-param>
        <xsl:with-param name="a">
          <xsl:call-template name="given">
            <xsl:with-param name="x" select="100 * $trees[1]/verdict/branches_from/value"/>
          </xsl:call-template>
        </xsl:with-param>
        <xsl:with-param name="b" select="$trees[1]/unions/source"/>
      </xsl:call-template>
      <thead><tr><xsl:call-template name="heads">
        <xsl:with-param name="of">c.br.tree;c.un.height:m;c.un.branch:cm;c.un.above:cm;c.un.below:cm;c.un.ratio:;c.un.class</xsl:with-param>
      </xsl:call-template></tr></thead>
      <tbody>
        <xsl:for-each select="$trees">
          <xsl:for-each select="unions/largest_unions/item"><xsl:call-template name="union-row"/></xsl:for-each>
        </xsl:for-each>
      </tbody>
    </table>
  </xsl:if>
  <xsl:for-each select="$trees[unions]"><xsl:call-template name="union-classes"/></xsl:for-each>
  <p><xsl:call-template name="say"><xsl:with-param name="id">un.strength</xsl:with-param></xsl:call-template></p>
</xsl:template>
</xsl:stylesheet>
