<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- The stem by criteria: at the strongest wind that has an answer, and the wind at which each is reached. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform">

<!-- At which wind the stem is lost by a criterion of its sections other than breakage. The context is a tree. -->
<xsl:template name="section-first">
  <xsl:variable name="of" select="verdict/criterion"/>
  <xsl:variable name="section" select="criteria/item[criterion = $of and scope = 'stem']/governing_section"/>
  <xsl:call-template name="say">
    <xsl:with-param name="id">
      <xsl:text>sum.</xsl:text>
      <xsl:if test="verdict/outcome = 'found'"><xsl:value-of select="concat($of, '.')"/></xsl:if>
      <xsl:value-of select="verdict/outcome"/>
    </xsl:with-param>
    <xsl:with-param name="a">
      <xsl:call-template name="wind-of"><xsl:with-param name="of" select="verdict"/></xsl:call-template>
    </xsl:with-param>
    <xsl:with-param name="b"><xsl:call-template name="place">
      <xsl:with-param name="height" select="$section/height/value"/><xsl:with-param name="section" select="$section"/>
    </xsl:call-template></xsl:with-param>
    <xsl:with-param name="c"><xsl:call-template name="wind-of">
      <xsl:with-param name="of" select="verdict"/><xsl:with-param name="gust" select="1"/>
    </xsl:call-template></xsl:with-param>
    <xsl:with-param name="d">
      <xsl:call-template name="given"><xsl:with-param name="x" select="$trees[1]/scenario/wind_height/value"/></xsl:call-template>
    </xsl:with-param>
    <xsl:with-param name="e" select="$trees[1]/scenario/wind_terrain"/>
  </xsl:call-template>
</xsl:template>

<xsl:template name="criterion-name">
  <xsl:choose>
    <xsl:when test="criterion = 'corridor' or criterion = 'tip-angle'">
      <xsl:call-template name="say">
        <xsl:with-param name="id" select="concat('criterion.', criterion)"/>
        <xsl:with-param name="a"><xsl:call-template name="room-limit"/></xsl:with-param>
      </xsl:call-template>
    </xsl:when>
    <xsl:otherwise>
      <xsl:call-template name="term">
        <xsl:with-param name="id" select="concat('criterion.', criterion)"/><xsl:with-param name="otherwise" select="criterion"/>
      </xsl:call-template>
    </xsl:otherwise>
  </xsl:choose>
</xsl:template>

<!-- Distance of the corridor [m], or the limit of the tip's turn in degrees. The context is an entry of criteria. -->
<xsl:template name="room-limit">
  <xsl:variable name="scenario" select="ancestor::item/scenario"/>
  <xsl:choose>
    <xsl:when test="criterion = 'corridor'">
      <xsl:call-template name="given"><xsl:with-param name="x" select="$scenario/corridor/value"/></xsl:call-template>
    </xsl:when>
    <xsl:otherwise>
      <xsl:call-template name="fixed">
        <xsl:with-param name="x" select="$degrees * $scenario/tip_angle_limit/value"/><xsl:with-param name="pattern">0.##</xsl:with-param>
      </xsl:call-template>
    </xsl:otherwise>
  </xsl:choose>
</xsl:template>

<!-- A row; `k`: which of the winds; `first`: is it the first of its tree. The context is an entry of criteria. -->
<xsl:template name="criterion-row">
  <xsl:param name="k"/><xsl:param name="first"/>
  <xsl:variable name="at" select="winds/item[$k]"/>
  <tr>
    <xsl:if test="count($trees) &gt; 1">
      <td>
        <xsl:if test="$first">
          <xsl:call-template name="name"><xsl:with-param name="tree" select="../.."/></xsl:call-template>
        </xsl:if>
      </td>
    </xsl:if>
    <td><xsl:call-template name="criterion-name"/></td>
    <xsl:variable name="own" select="../../assessment/required[current()/loses_tree = 'true' or
      current()/criterion = 'elastic-limit']"/>
    <xsl:variable name="required" select="$own | required_safety/value[not($own)]"/>
    <xsl:call-template name="cell">
      <xsl:with-param name="x" select="$at/safety/value"/><xsl:with-param name="pattern">0.00</xsl:with-param>
      <xsl:with-param name="bound" select="$required"/>
    </xsl:call-template>
    <xsl:call-template name="cell"><xsl:with-param name="x" select="$required"/></xsl:call-template>
    <xsl:choose>
      <xsl:when test="outcome = 'above'">
        <td class="r">
          <xsl:text>&gt;&#160;</xsl:text>
          <xsl:call-template name="given"><xsl:with-param name="x"
            select="(../../critical_stem | ../../self::*[not(critical_stem)]/critical)/speed_high/value"/></xsl:call-template>
        </td>
        <td class="r">–</td>
      </xsl:when>
      <xsl:otherwise>
        <xsl:call-template name="cell"><xsl:with-param name="x" select="critical_speed/value"/></xsl:call-template>
        <td class="r"><xsl:call-template name="gust"><xsl:with-param name="x" select="critical_speed/value"/></xsl:call-template></td>
      </xsl:otherwise>
    </xsl:choose>
    <xsl:call-template name="cell"><xsl:with-param name="x" select="$at/governing_section/height/value"/></xsl:call-template>
    <xsl:call-template name="cell"><xsl:with-param name="x" select="$at/stress/value div 1e6"/></xsl:call-template>
    <xsl:call-template name="cell"><xsl:with-param name="x" select="$at/resistance/value div 1e6"/></xsl:call-template>
  </tr>
</xsl:template>

<!-- What was not assessed, which limit of a thin wall is the least, what branches bear. The context is a tree. -->
<xsl:template name="criteria-notes">
  <xsl:param name="k"/>
  <xsl:variable name="stem" select="criteria/item[scope = 'stem']"/>
  <xsl:variable name="tree" select="."/>
  <xsl:for-each select="$stem[outcome = 'no-strength' and applies = 'true' and wants != '']">
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
      <xsl:with-param name="id">t.criteria.none</xsl:with-param>
      <xsl:with-param name="a"><xsl:call-template name="criterion-name"/></xsl:with-param>
      <xsl:with-param name="b"><xsl:call-template name="term">
        <xsl:with-param name="id" select="wants"/><xsl:with-param name="otherwise" select="wants"/></xsl:call-template></xsl:with-param>
      <xsl:with-param name="c"><xsl:call-template name="name">
        <xsl:with-param name="tree" select="$tree"/></xsl:call-template></xsl:with-param>
    </xsl:call-template>
  </xsl:for-each>
  <xsl:if test="$stem[criterion = 'splitting' and outcome != 'no-strength']">
    <xsl:for-each select="$stem[(criterion = 'breakage' or criterion = 'splitting' or criterion = 'ovalisation') and
      winds/item[$k]/safety/value != '']">
      <xsl:sort select="number(not(outcome = 'found' or outcome = 'self-weight'))" data-type="number"/>
      <xsl:sort select="critical_speed/value" data-type="number"/>
      <xsl:sort select="winds/item[$k]/safety/value" data-type="number"/>
      <xsl:if test="position() = 1">
        <xsl:value-of select="$gap"/>
        <xsl:call-template name="say">
          <xsl:with-param name="id">
            <xsl:text>t.criteria.wall</xsl:text><xsl:if test="outcome = 'found'">.found</xsl:if>
          </xsl:with-param>
          <xsl:with-param name="a"><xsl:call-template name="criterion-name"/></xsl:with-param>
          <xsl:with-param name="b"><xsl:call-template name="fixed">
            <xsl:with-param name="x" select="critical_speed/value"/><xsl:with-param name="pattern">0.0</xsl:with-param>
          </xsl:call-template></xsl:with-param>
          <xsl:with-param name="c"><xsl:call-template name="gust">
            <xsl:with-param name="x" select="critical_speed/value"/>
          </xsl:call-template></xsl:with-param>
          <xsl:with-param name="d"><xsl:call-template name="name">
            <xsl:with-param name="tree" select="$tree"/></xsl:call-template></xsl:with-param>
        </xsl:call-template>
      </xsl:if>
    </xsl:for-each>
    <xsl:call-template name="strength-across"/>
  </xsl:if>
  <xsl:if test="method/branch_strength/factor/value &lt; 1 and
    criteria/item[scope = 'branches' and criterion = 'breakage' and outcome != 'no-strength']">
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
      <xsl:with-param name="id">t.criteria.branches</xsl:with-param>
      <xsl:with-param name="a" select="format-number(method/branch_strength/factor/value, '0.00')"/>
      <xsl:with-param name="b" select="method/branch_strength/source"/>
    </xsl:call-template>
  </xsl:if>
</xsl:template>

<!-- The range of the strength that splitting depends on. -->
<xsl:template name="strength-across">
  <xsl:variable name="f" select="species/values/item[key = 'tangential_strength' and given = 'true'][1]"/>
  <xsl:if test="$f/low &lt; $f/value">
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
      <xsl:with-param name="id">t.criteria.across</xsl:with-param>
      <xsl:with-param name="a" select="format-number($f/value div 1e6, '0.##')"/>
      <xsl:with-param name="b" select="format-number($f/low div 1e6, '0.##')"/>
      <xsl:with-param name="c" select="format-number($f/high div 1e6, '0.##')"/>
    </xsl:call-template>
  </xsl:if>
  <xsl:value-of select="$gap"/>
  <xsl:call-template name="say">
    <xsl:with-param name="id">
      <xsl:text>t.criteria.nodes</xsl:text><xsl:if test="not(scenario/node_spacing/value != '')">.none</xsl:if>
    </xsl:with-param>
    <xsl:with-param name="a" select="format-number(scenario/node_spacing/value * 100, '0.#')"/>
  </xsl:call-template>
</xsl:template>

<xsl:template name="criteria-table">
  <xsl:if test="$trees/criteria/item[scope = 'stem' and wants != '' and outcome != 'no-strength']">
    <xsl:variable name="k" select="count($trees[1]/winds/item[status = 'ok'][last()]/preceding-sibling::item) + 1"/>
    <table class="data">
      <xsl:call-template name="caption">
        <xsl:with-param name="id">t.criteria</xsl:with-param>
        <xsl:with-param name="a">
          <xsl:call-template name="given"><xsl:with-param name="x" select="$trees[1]/winds/item[$k]/speed/value"/></xsl:call-template>
        </xsl:with-param>
      </xsl:call-template>
      <thead><tr>
        <xsl:if test="count($trees) &gt; 1">
          <xsl:call-template name="heads"><xsl:with-param name="of">c.tree</xsl:with-param></xsl:call-template>
        </xsl:if>
        <xsl:call-template name="heads">
          <xsl:with-param name="of">c.criterion;c.safety.only:–;c.wanted:–;c.reached:m/s;c.gust:m/s;c.height:m;c.stress.only:MPa;
            c.bears:MPa</xsl:with-param>
        </xsl:call-template>
      </tr></thead>
      <xsl:for-each select="$trees">
        <tbody>
          <xsl:for-each select="criteria/item[scope = 'stem' and wants != '' and outcome != 'no-strength']">
            <xsl:call-template name="criterion-row">
              <xsl:with-param name="k" select="$k"/><xsl:with-param name="first" select="position() = 1"/>
            </xsl:call-template>
          </xsl:for-each>
        </tbody>
      </xsl:for-each>
    </table>
    <p class="note">
      <xsl:call-template name="say"><xsl:with-param name="id">t.criteria.rule</xsl:with-param></xsl:call-template>
      <xsl:for-each select="$trees"><xsl:call-template name="criteria-notes">
        <xsl:with-param name="k" select="$k"/>
      </xsl:call-template></xsl:for-each>
    </p>
  </xsl:if>
</xsl:template>
</xsl:stylesheet>
