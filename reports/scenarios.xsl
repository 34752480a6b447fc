<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- What is done to a tree, or happens to it: the tree beside itself, and cables, rods and guys. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform">

<xsl:template name="scenario-tree">
  <td><xsl:if test="position() = 1"><xsl:for-each select="../.."><xsl:call-template name="name"/></xsl:for-each></xsl:if></td>
</xsl:template>

<xsl:template name="scenario-name">
  <td>
    <xsl:value-of select="name"/>
    <xsl:if test="name = ''"><xsl:call-template name="say"><xsl:with-param name="id">sc.stands</xsl:with-param></xsl:call-template></xsl:if>
  </td>
  <td class="r">
    <xsl:value-of select="format-number(100 * cut, '0')"/><xsl:if test="flagged = 'true'">&#160;!</xsl:if>
  </td>
</xsl:template>

<xsl:template name="scenario-critical">
  <xsl:choose>
    <xsl:when test="searched_to/value != ''"><td class="r">&gt;&#160;<xsl:value-of select="searched_to/value"/></td></xsl:when>
    <xsl:otherwise>
      <xsl:call-template name="cell">
        <xsl:with-param name="x" select="critical_speed/value"/><xsl:with-param name="pattern">0.0</xsl:with-param>
      </xsl:call-template>
    </xsl:otherwise>
  </xsl:choose>
</xsl:template>

<!-- Of an analysis: loads and safeties. Results of earlier versions have branches taken off alone, and no safety of branches. -->
<xsl:template name="scenarios-computed">
  <xsl:param name="items"/>
  <xsl:variable name="listed" select="$items/branch_safety/value != ''"/>
  <table class="data">
    <xsl:call-template name="caption">
      <xsl:with-param name="id">sc.caption</xsl:with-param>
      <xsl:with-param name="a">
        <xsl:call-template name="given"><xsl:with-param name="x" select="$trees[1]/winds/item[last()]/speed/value"/></xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
    <thead><tr><xsl:call-template name="heads">
      <xsl:with-param name="of">
        <xsl:text>c.br.tree;as.c.done;as.c.cut:%;c.wt.drag:kN;c.rm.weight:kN;c.wt.moment:kN m;c.rm.safety:;</xsl:text>
        <xsl:if test="$listed">c.sc.branches:;</xsl:if>
        <xsl:text>c.wt.critical:m/s</xsl:text>
      </xsl:with-param>
    </xsl:call-template></tr></thead>
    <tbody>
      <xsl:for-each select="$items/..">
        <xsl:for-each select="item">
        <tr>
          <xsl:call-template name="scenario-tree"/>
          <xsl:call-template name="scenario-name"/>
          <xsl:call-template name="cell">
            <xsl:with-param name="x" select="drag/value div 1000"/><xsl:with-param name="pattern">0.000</xsl:with-param>
          </xsl:call-template>
          <xsl:call-template name="cell">
            <xsl:with-param name="x" select="weight/value div 1000"/><xsl:with-param name="pattern">0.000</xsl:with-param>
          </xsl:call-template>
          <xsl:call-template name="cell">
            <xsl:with-param name="x" select="base_moment/value div 1000"/><xsl:with-param name="pattern">0.000</xsl:with-param>
          </xsl:call-template>
          <xsl:call-template name="cell">
            <xsl:with-param name="x" select="safety/value"/><xsl:with-param name="pattern">0.00</xsl:with-param>
          </xsl:call-template>
          <xsl:if test="$listed">
            <xsl:call-template name="cell">
              <xsl:with-param name="x" select="branch_safety/value"/><xsl:with-param name="pattern">0.00</xsl:with-param>
            </xsl:call-template>
          </xsl:if>
          <xsl:call-template name="scenario-critical"/>
        </tr>
        </xsl:for-each>
      </xsl:for-each>
    </tbody>
  </table>
</xsl:template>

<!-- Of an assessment: safeties and the word. -->
<xsl:template name="scenarios-assessed">
  <xsl:param name="items"/>
  <xsl:variable name="listed" select="$items/branch_safety/value != ''"/>
  <table class="data">
    <xsl:call-template name="caption"><xsl:with-param name="id">as.t.scenarios</xsl:with-param></xsl:call-template>
    <thead><tr><xsl:call-template name="heads">
      <xsl:with-param name="of">
        <xsl:text>as.c.done;as.c.cut:%;as.c.breakage:;as.c.overturning:;</xsl:text>
        <xsl:if test="$listed">c.sc.branches:;</xsl:if>
        <xsl:text>c.wt.critical:m/s;as.c.word</xsl:text>
      </xsl:with-param>
    </xsl:call-template></tr></thead>
    <tbody>
      <xsl:for-each select="$items">
        <tr>
          <xsl:call-template name="scenario-name"/>
          <xsl:call-template name="cell">
            <xsl:with-param name="x" select="breakage/value"/><xsl:with-param name="pattern">0.00</xsl:with-param>
            <xsl:with-param name="bound" select="ancestor::*[assessment][1]/assessment/required"/>
          </xsl:call-template>
          <xsl:call-template name="cell">
            <xsl:with-param name="x" select="overturning/value"/><xsl:with-param name="pattern">0.00</xsl:with-param>
            <xsl:with-param name="bound" select="ancestor::*[assessment][1]/assessment/required"/>
          </xsl:call-template>
          <xsl:if test="$listed">
            <xsl:call-template name="cell">
              <xsl:with-param name="x" select="branch_safety/value"/><xsl:with-param name="pattern">0.00</xsl:with-param>
            </xsl:call-template>
          </xsl:if>
          <xsl:call-template name="scenario-critical"/>
          <td><xsl:call-template name="say"><xsl:with-param name="id" select="concat('as.short.', word)"/></xsl:call-template></td>
        </tr>
      </xsl:for-each>
    </tbody>
  </table>
</xsl:template>

<!-- What holds the tree in each. -->
<xsl:template name="scenario-forces">
  <xsl:param name="items"/>
  <xsl:variable name="several" select="count($trees) &gt; 1"/>
  <xsl:variable name="around" select="$items/holds/item/from"/>
  <table class="data">
    <xsl:call-template name="caption"><xsl:with-param name="id">sc.forces</xsl:with-param></xsl:call-template>
    <thead><tr><xsl:call-template name="heads">
      <xsl:with-param name="of">
        <xsl:if test="$several">c.br.tree;</xsl:if>
        <xsl:text>as.c.done;c.bz.kind;c.bz.from;c.bz.to;c.bz.pull:kN;c.bz.speed:m/s;</xsl:text>
        <xsl:if test="$around">as.c.from:°;</xsl:if>
        <xsl:text>c.bz.lost:kN;c.bz.breaking:kN;c.bz.safety</xsl:text>
      </xsl:with-param>
    </xsl:call-template></tr></thead>
    <tbody>
      <xsl:for-each select="$items/holds/item">
        <tr>
          <xsl:if test="$several"><td><xsl:for-each select="../../../.."><xsl:call-template name="name"/></xsl:for-each></td></xsl:if>
          <td>
            <xsl:if test="not(preceding-sibling::item)">
              <xsl:value-of select="../../name"/>
              <xsl:if test="../../name = ''">
                <xsl:call-template name="say"><xsl:with-param name="id">sc.stands</xsl:with-param></xsl:call-template>
              </xsl:if>
            </xsl:if>
          </td>
          <td><xsl:call-template name="say"><xsl:with-param name="id" select="concat('bz.', name)"/></xsl:call-template></td>
          <td><xsl:value-of select="from_point"/></td>
          <td><xsl:value-of select="to_point"/></td>
          <xsl:call-template name="cell">
            <xsl:with-param name="x" select="pull/value div 1000"/><xsl:with-param name="pattern">0.00</xsl:with-param>
          </xsl:call-template>
          <xsl:call-template name="cell"><xsl:with-param name="x" select="speed/value"/></xsl:call-template>
          <xsl:if test="$around">
            <xsl:call-template name="cell">
              <xsl:with-param name="x" select="$degrees * from/value"/><xsl:with-param name="pattern">0</xsl:with-param>
            </xsl:call-template>
          </xsl:if>
          <xsl:call-template name="cell">
            <xsl:with-param name="x" select="pull_critical/value div 1000"/><xsl:with-param name="pattern">0.00</xsl:with-param>
          </xsl:call-template>
          <xsl:call-template name="cell"><xsl:with-param name="x" select="breaking/value div 1000"/></xsl:call-template>
          <xsl:call-template name="cell"><xsl:with-param name="x" select="safety/value"/></xsl:call-template>
        </tr>
      </xsl:for-each>
    </tbody>
  </table>
</xsl:template>

<!-- "of": trees, of which results of earlier versions have their scenarios elsewhere. -->
<xsl:template name="scenarios-tables">
  <xsl:param name="of"/>
  <xsl:variable name="items" select="$of/scenarios/item | $of[not(scenarios)]/removals/item |
    $of[not(scenarios)]/assessment/scenarios/item"/>
  <xsl:choose>
    <xsl:when test="$items/word">
      <xsl:call-template name="scenarios-assessed"><xsl:with-param name="items" select="$items"/></xsl:call-template>
    </xsl:when>
    <xsl:when test="$items">
      <xsl:call-template name="scenarios-computed"><xsl:with-param name="items" select="$items"/></xsl:call-template>
    </xsl:when>
  </xsl:choose>
  <xsl:if test="$items[gustier = 'true']"><p class="note">
    <xsl:for-each select="$items[gustier = 'true']">
      <xsl:if test="position() &gt; 1"><xsl:value-of select="$gap"/></xsl:if>
      <xsl:call-template name="say">
        <xsl:with-param name="id">sc.gustier</xsl:with-param>
        <xsl:with-param name="a" select="name"/>
        <xsl:with-param name="b" select="format-number(branch_gusts, '0.00')"/>
        <xsl:with-param name="c" select="format-number(../item[1]/branch_gusts, '0.00')"/>
        <xsl:with-param name="d" select="format-number(branch_damping, '0.000')"/>
        <xsl:with-param name="e" select="format-number(../item[1]/branch_damping, '0.000')"/>
      </xsl:call-template>
    </xsl:for-each>
  </p></xsl:if>
  <xsl:if test="$items/holds/item">
    <xsl:call-template name="scenario-forces"><xsl:with-param name="items" select="$items"/></xsl:call-template>
  </xsl:if>
</xsl:template>

<!-- Cables that hold a tree. -->
<xsl:template name="guys-table">
  <xsl:variable name="around" select="$trees/guys/item/from"/>
  <table class="data">
    <xsl:call-template name="caption"><xsl:with-param name="id">gy.caption</xsl:with-param></xsl:call-template>
    <thead><tr><xsl:call-template name="heads">
      <xsl:with-param name="of">
        <xsl:text>c.br.tree;c.gy.height:m;c.gy.distance:m;c.gy.towards:°;c.gy.stiffness:kN/m;c.gy.pretension:kN;c.gy.pull:kN;</xsl:text>
        <xsl:if test="$around">as.c.from:°;</xsl:if>
        <xsl:text>c.bz.lost:kN</xsl:text>
      </xsl:with-param>
    </xsl:call-template></tr></thead>
    <tbody>
      <xsl:for-each select="$trees/guys/item">
        <tr>
          <td>
            <xsl:if test="not(preceding-sibling::item)">
              <xsl:for-each select="../.."><xsl:call-template name="name"/></xsl:for-each>
            </xsl:if>
          </td>
          <xsl:call-template name="cell"><xsl:with-param name="x" select="height/value"/></xsl:call-template>
          <xsl:call-template name="cell"><xsl:with-param name="x" select="distance/value"/></xsl:call-template>
          <xsl:call-template name="cell">
            <xsl:with-param name="x" select="towards/value * 57.29577951308232"/><xsl:with-param name="pattern">0</xsl:with-param>
          </xsl:call-template>
          <xsl:call-template name="cell"><xsl:with-param name="x" select="stiffness/value div 1000"/></xsl:call-template>
          <xsl:call-template name="cell"><xsl:with-param name="x" select="pretension/value div 1000"/></xsl:call-template>
          <xsl:call-template name="cell"><xsl:with-param name="x" select="pull/value div 1000"/></xsl:call-template>
          <xsl:if test="$around">
            <xsl:call-template name="cell">
              <xsl:with-param name="x" select="$degrees * from/value"/><xsl:with-param name="pattern">0</xsl:with-param>
            </xsl:call-template>
          </xsl:if>
          <xsl:call-template name="cell"><xsl:with-param name="x" select="pull_critical/value div 1000"/></xsl:call-template>
        </tr>
      </xsl:for-each>
    </tbody>
  </table>
</xsl:template>

<!-- Cables and rods between two points of a tree. -->
<xsl:template name="braces-table">
  <xsl:variable name="around" select="$trees/braces/item/from"/>
  <table class="data">
    <xsl:call-template name="caption"><xsl:with-param name="id">bz.caption</xsl:with-param></xsl:call-template>
    <thead><tr><xsl:call-template name="heads">
      <xsl:with-param name="of">
        <xsl:text>c.br.tree;c.bz.kind;c.bz.from;c.bz.to;c.gy.stiffness:kN/m;c.gy.pretension:kN;c.bz.slack:m;c.bz.pull:kN;</xsl:text>
        <xsl:text>c.bz.speed:m/s;</xsl:text>
        <xsl:if test="$around">as.c.from:°;</xsl:if>
        <xsl:text>c.bz.lost:kN;c.bz.breaking:kN;c.bz.safety</xsl:text>
      </xsl:with-param>
    </xsl:call-template></tr></thead>
    <tbody>
      <xsl:for-each select="$trees/braces/item">
        <tr>
          <td>
            <xsl:if test="not(preceding-sibling::item)">
              <xsl:for-each select="../.."><xsl:call-template name="name"/></xsl:for-each>
            </xsl:if>
          </td>
          <td><xsl:call-template name="say"><xsl:with-param name="id" select="concat('bz.', name)"/></xsl:call-template></td>
          <td><xsl:value-of select="from_point"/></td>
          <td><xsl:value-of select="to_point"/></td>
          <xsl:call-template name="cell"><xsl:with-param name="x" select="stiffness/value div 1000"/></xsl:call-template>
          <xsl:call-template name="cell"><xsl:with-param name="x" select="pretension/value div 1000"/></xsl:call-template>
          <xsl:call-template name="cell">
            <xsl:with-param name="x" select="slack/value"/><xsl:with-param name="pattern">0.00</xsl:with-param>
          </xsl:call-template>
          <xsl:call-template name="cell">
            <xsl:with-param name="x" select="pull/value div 1000"/><xsl:with-param name="pattern">0.00</xsl:with-param>
          </xsl:call-template>
          <xsl:call-template name="cell"><xsl:with-param name="x" select="speed/value"/></xsl:call-template>
          <xsl:if test="$around">
            <xsl:call-template name="cell">
              <xsl:with-param name="x" select="$degrees * from/value"/><xsl:with-param name="pattern">0</xsl:with-param>
            </xsl:call-template>
          </xsl:if>
          <xsl:call-template name="cell">
            <xsl:with-param name="x" select="pull_critical/value div 1000"/><xsl:with-param name="pattern">0.00</xsl:with-param>
          </xsl:call-template>
          <xsl:call-template name="cell"><xsl:with-param name="x" select="breaking/value div 1000"/></xsl:call-template>
          <xsl:call-template name="cell"><xsl:with-param name="x" select="safety/value"/></xsl:call-template>
        </tr>
      </xsl:for-each>
    </tbody>
  </table>
</xsl:template>
</xsl:stylesheet>
