<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- Methods against beam theory: by level, by branch, the figure. Part of explain.xsl and series.xsl. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform">

<xsl:template name="method-heads">
  <xsl:param name="units">yes</xsl:param>
  <xsl:for-each select="methods/item">
    <th class="r"><xsl:call-template name="key">
      <xsl:with-param name="of">method</xsl:with-param><xsl:with-param name="key" select="name"/></xsl:call-template>
      <xsl:if test="$units = 'yes'"><span class="u">&#160;</span></xsl:if></th>
  </xsl:for-each>
</xsl:template>

<!-- the middle ratio, below it the lowest and the highest -->
<xsl:template match="item" mode="spread">
  <td class="r">
    <xsl:call-template name="number"><xsl:with-param name="x" select="middle"/></xsl:call-template>
    <xsl:if test="answers &gt; 1">
      <span class="why">
        <xsl:call-template name="say">
          <xsl:with-param name="id">range</xsl:with-param>
          <xsl:with-param name="a">
            <xsl:call-template name="number"><xsl:with-param name="x" select="low"/></xsl:call-template>
          </xsl:with-param>
          <xsl:with-param name="b">
            <xsl:call-template name="number"><xsl:with-param name="x" select="high"/></xsl:call-template>
          </xsl:with-param>
        </xsl:call-template>
      </span>
    </xsl:if>
  </td>
</xsl:template>

<xsl:template name="by-level">
  <table class="data">
    <xsl:call-template name="caption"><xsl:with-param name="id">ex.levels</xsl:with-param></xsl:call-template>
    <thead>
      <tr>
        <xsl:call-template name="heads">
          <xsl:with-param name="of">c.level;c.branches:</xsl:with-param><xsl:with-param name="units">no</xsl:with-param>
        </xsl:call-template>
        <xsl:call-template name="method-heads"><xsl:with-param name="units">no</xsl:with-param></xsl:call-template>
      </tr>
    </thead>
    <xsl:for-each select="levels/item">
      <tbody>
        <tr>
          <td><xsl:value-of select="position() - 1"/></td><td class="r"><xsl:value-of select="branches"/></td>
          <xsl:apply-templates select="methods/item" mode="spread"/>
        </tr>
      </tbody>
    </xsl:for-each>
    <tbody>
      <tr>
        <td colspan="2"><xsl:call-template name="say"><xsl:with-param name="id">ex.tip</xsl:with-param></xsl:call-template></td>
        <xsl:for-each select="methods/item">
          <xsl:call-template name="n"><xsl:with-param name="x" select="tip"/></xsl:call-template>
        </xsl:for-each>
      </tr>
    </tbody>
    <tbody>
      <tr>
        <td colspan="2">
          <xsl:call-template name="say"><xsl:with-param name="id">ex.within</xsl:with-param></xsl:call-template>
        </td>
        <xsl:for-each select="methods/item">
          <td class="r"><xsl:value-of select="format-number(100 * within_5_percent, '0')"/>&#160;%</td>
        </xsl:for-each>
      </tr>
    </tbody>
  </table>
</xsl:template>

<xsl:template name="by-branch">
  <table class="data whole">
    <xsl:call-template name="caption">
      <xsl:with-param name="id">
        <xsl:choose>
          <xsl:when test="count(branches/item) &lt; branch_count">ex.first</xsl:when><xsl:otherwise>ex.branches</xsl:otherwise>
        </xsl:choose>
      </xsl:with-param>
      <xsl:with-param name="a" select="count(branches/item)"/><xsl:with-param name="b" select="branch_count"/>
    </xsl:call-template>
    <thead>
      <tr>
        <xsl:call-template name="heads">
          <xsl:with-param name="of">c.branch;c.level;c.foot:m;c.length:m;c.beam:m</xsl:with-param>
        </xsl:call-template>
        <xsl:call-template name="method-heads"/>
      </tr>
    </thead>
    <tbody class="long">
      <xsl:for-each select="branches/item">
        <tr>
          <td><xsl:value-of select="number"/></td><td><xsl:value-of select="level"/></td>
          <xsl:call-template name="cell">
            <xsl:with-param name="x" select="height"/><xsl:with-param name="pattern">0.00</xsl:with-param>
          </xsl:call-template>
          <xsl:call-template name="cell">
            <xsl:with-param name="x" select="length"/><xsl:with-param name="pattern">0.00</xsl:with-param>
          </xsl:call-template>
          <xsl:call-template name="n"><xsl:with-param name="x" select="beam"/></xsl:call-template>
          <xsl:for-each select="ratios/item">
            <xsl:call-template name="n"><xsl:with-param name="x" select="."/></xsl:call-template>
          </xsl:for-each>
        </tr>
      </xsl:for-each>
    </tbody>
  </table>
</xsl:template>

<xsl:template match="explained/item" mode="section">
  <xsl:call-template name="h2">
    <xsl:with-param name="id">ex.heading</xsl:with-param>
    <xsl:with-param name="a"><xsl:call-template name="run-words"/></xsl:with-param>
  </xsl:call-template>
  <p>
    <xsl:call-template name="say">
      <xsl:with-param name="id">ex.text</xsl:with-param>
      <xsl:with-param name="a">
        <xsl:call-template name="number"><xsl:with-param name="x" select="speed"/></xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
  </p>
  <xsl:call-template name="by-level"/>
  <xsl:call-template name="figure">
    <xsl:with-param name="name" select="concat('explain_', run)"/><xsl:with-param name="id">cap.explain</xsl:with-param>
  </xsl:call-template>
  <xsl:if test="branch_count &gt; 1"><xsl:call-template name="by-branch"/></xsl:if>
</xsl:template>
</xsl:stylesheet>
