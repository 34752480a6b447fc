<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- The summary in words: one paragraph a tree, then the comparison and what to be careful about. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform">

<!-- "7.4 m" above ground -->
<xsl:template name="place">
  <xsl:param name="height"/><xsl:param name="section"/>
  <xsl:choose>
    <xsl:when test="$section/level &gt; 0">
      <xsl:call-template name="say">
        <xsl:with-param name="id">place.part</xsl:with-param><xsl:with-param name="a" select="format-number($height, '0.0')"/>
        <xsl:with-param name="b">
          <xsl:call-template name="part"><xsl:with-param name="level" select="$section/part"/></xsl:call-template>
        </xsl:with-param>
      </xsl:call-template>
    </xsl:when>
    <xsl:when test="$height &lt; 0.1">
      <xsl:call-template name="say"><xsl:with-param name="id">place.base</xsl:with-param></xsl:call-template>
    </xsl:when>
    <xsl:otherwise>
      <xsl:call-template name="say">
        <xsl:with-param name="id">place</xsl:with-param><xsl:with-param name="a" select="format-number($height, '0.0')"/>
      </xsl:call-template>
    </xsl:otherwise>
  </xsl:choose>
</xsl:template>

<!-- Every warning once: those about the file of the tree are with each species. -->
<xsl:variable name="warned" select="$r/warnings/item | $trees/warnings/item[not(text =
  ../../preceding-sibling::item/warnings/item/text)]"/>

<!-- A segment by its id in the file of the tree, its branching order and its thickness. -->
<xsl:template name="segment">
  <xsl:param name="section"/>
  <xsl:call-template name="say">
    <xsl:with-param name="id">segment.named</xsl:with-param>
    <xsl:with-param name="a" select="$section/id"/>
    <xsl:with-param name="b" select="$section/level"/>
    <xsl:with-param name="c">
      <xsl:call-template name="number"><xsl:with-param name="x" select="1000 * $section/diameter/value"/></xsl:call-template>
    </xsl:with-param>
  </xsl:call-template>
</xsl:template>

<!-- Wind speeds whose answers the method itself does not vouch for. -->
<xsl:template name="small">
  <xsl:variable name="beyond" select="winds/item[within_limits = 'false']"/>
  <xsl:if test="$beyond">
    <xsl:call-template name="say">
      <xsl:with-param name="id">sum.small</xsl:with-param>
      <xsl:with-param name="a">
        <xsl:choose>
          <xsl:when test="count($beyond) &gt; 4">
            <xsl:call-template name="say">
              <xsl:with-param name="id">range</xsl:with-param>
              <xsl:with-param name="a">
                <xsl:call-template name="given"><xsl:with-param name="x" select="$beyond[1]/speed/value"/></xsl:call-template>
              </xsl:with-param>
              <xsl:with-param name="b">
                <xsl:call-template name="given">
                  <xsl:with-param name="x" select="$beyond[last()]/speed/value"/>
                </xsl:call-template>
              </xsl:with-param>
            </xsl:call-template>
          </xsl:when>
          <xsl:otherwise>
            <xsl:call-template name="list"><xsl:with-param name="items" select="$beyond/speed/value"/></xsl:call-template>
          </xsl:otherwise>
        </xsl:choose>
      </xsl:with-param>
      <xsl:with-param name="b"><xsl:call-template name="name"/></xsl:with-param>
    </xsl:call-template>
  </xsl:if>
</xsl:template>

<!-- The first sentence: how it stands at the highest wind speed that has an answer. -->
<xsl:template name="verdict">
  <xsl:variable name="last" select="winds/item[status = 'ok' and within_limits = 'true'][last()]"/>
  <xsl:variable name="stem" select="criteria/item[criterion = 'breakage' and scope = 'stem']/winds/item[speed/value =
    $last/speed/value]/safety[not($last/loss_safety)]"/>
  <xsl:variable name="safety" select="$last/loss_safety | $stem | $last[not(loss_safety or $stem)]/least_safety"/>
  <xsl:variable name="yields" select="criteria/item[criterion = 'elastic-limit' and scope = 'stem']/winds/item[speed/value =
    $last/speed/value and safety/value &lt; 1]"/>
  <xsl:variable name="rooted" select="verdict/criteria/item[criterion = 'overturning']"/>
  <xsl:variable name="known" select="verdict/criteria/item[loses_tree = 'true'] or (not(verdict) and critical/outcome != 'no-strength')"/>
  <xsl:variable name="bent" select="($last/mean_state/tip_deflection_share |
    $last[not(mean_state)]/tip_deflection_share)/value"/>
  <xsl:call-template name="say">
    <xsl:with-param name="id">
      <xsl:choose>
        <xsl:when test="not($last)">sum.nothing</xsl:when>
        <xsl:when test="not($known)">sum.unknown</xsl:when>
        <xsl:when test="$safety/value &lt;= 1 and verdict/safety_criterion = 'overturning'">sum.overturns</xsl:when>
        <xsl:when test="$safety/value &lt;= 1 and verdict/safety_criterion = 'splitting'">sum.splits</xsl:when>
        <xsl:when test="$safety/value &lt;= 1 and verdict/safety_criterion = 'ovalisation'">sum.flattens</xsl:when>
        <xsl:when test="$safety/value &lt;= 1">sum.breaks</xsl:when>
        <xsl:when test="$yields and not($safety/value &lt;= 1.5)">sum.yields</xsl:when>
        <xsl:otherwise>
          <xsl:choose>
            <xsl:when test="$safety/value = '' or $safety/value &gt; 3">sum.far</xsl:when>
            <xsl:when test="$safety/value &gt; 1.5">sum.reserve</xsl:when>
            <xsl:otherwise>sum.close</xsl:otherwise>
          </xsl:choose>
          <xsl:if test="$rooted">.root</xsl:if>
        </xsl:otherwise>
      </xsl:choose>
    </xsl:with-param>
    <xsl:with-param name="a"><xsl:call-template name="name"/></xsl:with-param>
    <xsl:with-param name="b">
      <xsl:call-template name="say">
        <xsl:with-param name="id">
          <xsl:choose>
            <xsl:when test="$bent &lt; 0.05">sum.bend.little</xsl:when>
            <xsl:when test="$bent &lt; 0.25">sum.bend.clear</xsl:when>
            <xsl:otherwise>sum.bend.far</xsl:otherwise>
          </xsl:choose>
        </xsl:with-param>
      </xsl:call-template>
    </xsl:with-param>
    <xsl:with-param name="c">
      <xsl:call-template name="given"><xsl:with-param name="x" select="$last/speed/value"/></xsl:call-template>
    </xsl:with-param>
    <xsl:with-param name="d">
      <xsl:call-template name="gust"><xsl:with-param name="x" select="$last/speed/value"/></xsl:call-template>
    </xsl:with-param>
  </xsl:call-template>
  <xsl:if test="$last and scenario/winter_wind/value &lt; 1">
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
      <xsl:with-param name="id">sum.winter</xsl:with-param>
      <xsl:with-param name="a">
        <xsl:call-template name="number"><xsl:with-param name="x" select="scenario/winter_wind/value"/></xsl:call-template>
      </xsl:with-param>
      <xsl:with-param name="b">
        <xsl:call-template name="number">
          <xsl:with-param name="x" select="scenario/winter_wind/value * $last/speed/value"/>
        </xsl:call-template>
      </xsl:with-param>
      <xsl:with-param name="c">
        <xsl:call-template name="gust">
          <xsl:with-param name="x" select="scenario/winter_wind/value * $last/speed/value"/>
        </xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
  </xsl:if>
</xsl:template>

<!-- How far the tip moves, and the top of a crown that reaches above the stem: at every wind speed up to three, else the first, the
     middle and the last. -->
<xsl:template name="tips">
  <xsl:variable name="top" select="top[level &gt; 0]"/>
  <xsl:variable name="solved" select="winds/item[status = 'ok' and within_limits = 'true']"/>
  <xsl:for-each select="$solved[count($solved) &lt; 4 or position() = 1 or position() = ceiling(count($solved) div 2) or
    position() = last()]">
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
      <xsl:with-param name="id">sum.tip</xsl:with-param>
      <xsl:with-param name="a">
        <xsl:call-template name="given"><xsl:with-param name="x" select="speed/value"/></xsl:call-template>
      </xsl:with-param>
      <xsl:with-param name="b">
        <xsl:call-template name="number"><xsl:with-param name="x" select="(mean_state/tip_deflection |
          self::*[not(mean_state)]/tip_deflection)/value"/></xsl:call-template>
      </xsl:with-param>
      <xsl:with-param name="c">
        <xsl:call-template name="steady">
          <xsl:with-param name="x" select="100 * (mean_state/tip_deflection_share | self::*[not(mean_state)]/tip_deflection_share)/value"/>
          <xsl:with-param name="pattern">0.#</xsl:with-param>
        </xsl:call-template>
      </xsl:with-param>
      <xsl:with-param name="d">
        <xsl:call-template name="steady">
          <xsl:with-param name="x" select="$degrees * (mean_state/tip_angle |
            self::*[not(mean_state)]/tip_angle)/value"/><xsl:with-param name="pattern">0.0</xsl:with-param>
        </xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
    <xsl:if test="$top">
      <xsl:value-of select="$gap"/>
      <xsl:call-template name="say">
        <xsl:with-param name="id">sum.top<xsl:if test="position() &gt; 1">.too</xsl:if></xsl:with-param>
        <xsl:with-param name="a"><xsl:call-template name="number"><xsl:with-param name="x" select="(mean_state/top_deflection |
          self::*[not(mean_state)]/top_deflection)/value"/></xsl:call-template></xsl:with-param>
        <xsl:with-param name="b" select="format-number($top/height/value, '0.0')"/>
        <xsl:with-param name="c">
          <xsl:call-template name="part"><xsl:with-param name="level" select="$top/part"/></xsl:call-template>
        </xsl:with-param>
      </xsl:call-template>
    </xsl:if>
  </xsl:for-each>
</xsl:template>

<xsl:template name="strength">
  <xsl:variable name="last" select="winds/item[status = 'ok' and within_limits = 'true'][last()]"/>
  <xsl:variable name="root" select="criteria/item[criterion = 'overturning']/winds/item[speed/value = $last/speed/value]"/>
  <xsl:for-each select="criteria/item[criterion = 'breakage' and scope = 'stem']/winds/item[speed/value = $last/speed/value and
    safety/value != '']">
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
      <xsl:with-param name="id">sum.stress</xsl:with-param>
      <xsl:with-param name="a">
        <xsl:call-template name="given"><xsl:with-param name="x" select="speed/value"/></xsl:call-template>
      </xsl:with-param>
      <xsl:with-param name="b">
        <xsl:call-template name="place">
          <xsl:with-param name="height" select="governing_section/height/value"/>
          <xsl:with-param name="section" select="governing_section"/>
        </xsl:call-template>
      </xsl:with-param>
      <xsl:with-param name="c">
        <xsl:call-template name="fixed">
          <xsl:with-param name="x" select="100 div safety/value"/><xsl:with-param name="pattern">0</xsl:with-param>
        </xsl:call-template>
      </xsl:with-param>
      <xsl:with-param name="d">
        <xsl:call-template name="number">
          <xsl:with-param name="x" select="safety/value"/>
          <xsl:with-param name="bound" select="ancestor::*[assessment][1]/assessment/required"/>
        </xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
  </xsl:for-each>
  <xsl:for-each select="criteria/item[criterion = 'elastic-limit' and scope = 'stem']/winds/item[speed/value = $last/speed/value and
    safety/value != '']">
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
      <xsl:with-param name="id">sum.elastic</xsl:with-param>
      <xsl:with-param name="c">
        <xsl:call-template name="fixed">
          <xsl:with-param name="x" select="100 div safety/value"/><xsl:with-param name="pattern">0</xsl:with-param>
        </xsl:call-template>
      </xsl:with-param>
      <xsl:with-param name="d">
        <xsl:call-template name="number">
          <xsl:with-param name="x" select="safety/value"/>
          <xsl:with-param name="bound" select="ancestor::*[assessment][1]/assessment/required"/>
        </xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
  </xsl:for-each>
  <xsl:variable name="by" select="verdict/safety_criterion"/>
  <xsl:for-each select="criteria/item[criterion = $by and $by != 'breakage' and scope = 'stem' and wants != '']/winds/item[speed/value =
    $last/speed/value and safety/value != '']">
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
      <xsl:with-param name="id">sum.stress.by</xsl:with-param>
      <xsl:with-param name="b">
        <xsl:call-template name="place">
          <xsl:with-param name="height" select="governing_section/height/value"/>
          <xsl:with-param name="section" select="governing_section"/>
        </xsl:call-template>
      </xsl:with-param>
      <xsl:with-param name="c">
        <xsl:call-template name="fixed">
          <xsl:with-param name="x" select="100 div safety/value"/><xsl:with-param name="pattern">0</xsl:with-param>
        </xsl:call-template>
      </xsl:with-param>
      <xsl:with-param name="d">
        <xsl:call-template name="number">
          <xsl:with-param name="x" select="safety/value"/>
          <xsl:with-param name="bound" select="ancestor::*[assessment][1]/assessment/required"/>
        </xsl:call-template>
      </xsl:with-param>
      <xsl:with-param name="e"><xsl:for-each select="../.."><xsl:call-template name="criterion-name"/></xsl:for-each></xsl:with-param>
    </xsl:call-template>
  </xsl:for-each>
  <xsl:if test="$root/safety/value != ''">
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
      <xsl:with-param name="id">sum.root</xsl:with-param>
      <xsl:with-param name="a"><xsl:call-template name="fixed">
        <xsl:with-param name="x" select="100 div $root/safety/value"/><xsl:with-param name="pattern">0</xsl:with-param>
      </xsl:call-template></xsl:with-param>
      <xsl:with-param name="b">
        <xsl:call-template name="number">
          <xsl:with-param name="x" select="$root/safety/value"/>
          <xsl:with-param name="bound" select="$root/ancestor::*[assessment][1]/assessment/required"/>
        </xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
  </xsl:if>
</xsl:template>

<!-- At which wind the tree is lost, or why that has no answer. -->
<xsl:template name="loss">
  <xsl:choose>
    <xsl:when test="critical_stem/within_limits = 'false' or verdict/within_limits = 'false'">
      <xsl:call-template name="say">
        <xsl:with-param name="id">
          <xsl:choose>
            <xsl:when test="winds/item/within_limits = 'false'">sum.void</xsl:when><xsl:otherwise>sum.void.alone</xsl:otherwise>
          </xsl:choose>
        </xsl:with-param>
        <xsl:with-param name="a" select="format-number((verdict/critical_speed | self::*[not(verdict)]/critical_stem/speed)/value, '0.0')"/>
        <xsl:with-param name="b">
          <xsl:for-each select="method/solver"><xsl:value-of select="name"/></xsl:for-each>
        </xsl:with-param>
      </xsl:call-template>
    </xsl:when>
    <xsl:when test="critical_stem/outcome = 'above' and winds/item/within_limits = 'false'"/>
    <xsl:otherwise><xsl:call-template name="expected"/></xsl:otherwise>
  </xsl:choose>
</xsl:template>

<!-- At which wind the stem breaks, or why that is not known. -->
<xsl:template name="breaks-first">
  <xsl:call-template name="say">
    <xsl:with-param name="id" select="concat('sum.', critical_stem/outcome)"/>
    <xsl:with-param name="a">
      <xsl:choose>
        <xsl:when test="critical_stem/outcome = 'found'">
          <xsl:value-of select="format-number(critical_stem/speed/value, '0.0')"/>
        </xsl:when>
        <xsl:when test="critical_stem/outcome = 'above'">
          <xsl:call-template name="given"><xsl:with-param name="x" select="critical_stem/speed_high/value"/></xsl:call-template>
        </xsl:when>
        <xsl:otherwise>
          <xsl:call-template name="fixed"><xsl:with-param name="x" select="critical_stem/speed_low/value"/></xsl:call-template>
        </xsl:otherwise>
      </xsl:choose>
    </xsl:with-param>
    <xsl:with-param name="b">
      <xsl:choose>
        <xsl:when test="critical_stem/outcome = 'found'">
          <xsl:call-template name="place">
            <xsl:with-param name="height" select="critical_stem/governing_section/height/value"/>
            <xsl:with-param name="section" select="critical_stem/governing_section"/>
          </xsl:call-template>
        </xsl:when>
        <xsl:otherwise>
          <xsl:call-template name="fixed"><xsl:with-param name="x" select="critical_stem/speed_high/value"/></xsl:call-template>
        </xsl:otherwise>
      </xsl:choose>
    </xsl:with-param>
    <xsl:with-param name="c">
      <xsl:choose>
        <xsl:when test="critical_stem/outcome = 'found'">
          <xsl:call-template name="gust"><xsl:with-param name="x" select="critical_stem/speed/value"/></xsl:call-template>
        </xsl:when>
        <xsl:otherwise>
          <xsl:call-template name="gust"><xsl:with-param name="x" select="critical_stem/speed_high/value"/></xsl:call-template>
        </xsl:otherwise>
      </xsl:choose>
    </xsl:with-param>
    <xsl:with-param name="d">
      <xsl:call-template name="given"><xsl:with-param name="x" select="$trees[1]/scenario/wind_height/value"/></xsl:call-template>
    </xsl:with-param>
    <xsl:with-param name="e" select="$trees[1]/scenario/wind_terrain"/>
  </xsl:call-template>
</xsl:template>

<!-- At which wind it breaks, or why that is not known. -->
<!-- At which wind the tree is lost; then what else fails. -->
<xsl:template name="expected">
  <xsl:choose>
    <xsl:when test="verdict/criterion = 'overturning'"><xsl:call-template name="overturns-first"/></xsl:when>
    <xsl:when test="verdict/criterion != 'breakage'"><xsl:call-template name="section-first"/></xsl:when>
    <xsl:otherwise><xsl:call-template name="breaks-first"/></xsl:otherwise>
  </xsl:choose>
  <xsl:if test="critical/outcome = 'self-weight' and critical/governing_section/diameter/value != ''">
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
      <xsl:with-param name="id">sum.segment</xsl:with-param>
      <xsl:with-param name="a">
        <xsl:call-template name="part"><xsl:with-param name="level" select="critical/governing_section/part"/></xsl:call-template>
      </xsl:with-param>
      <xsl:with-param name="b">
        <xsl:call-template name="segment"><xsl:with-param name="section" select="critical/governing_section"/></xsl:call-template>
      </xsl:with-param>
      <xsl:with-param name="c" select="format-number(critical/governing_section/height/value, '0.0')"/>
    </xsl:call-template>
  </xsl:if>
  <!-- the criterion of the stem that is reached first, or its breakage where another one was named before -->
  <xsl:variable name="stem" select="verdict[criterion != 'breakage']/criteria/item[loses_tree = 'true' and outcome = 'found' and
    within_limits = 'true' and criterion != 'overturning' and (criterion = 'breakage' or ../../criterion = 'overturning')]"/>
  <xsl:for-each select="$stem">
    <xsl:sort select="critical_speed/value" data-type="number"/>
    <xsl:if test="position() = 1">
      <xsl:value-of select="$gap"/>
      <xsl:call-template name="say">
        <xsl:with-param name="id" select="concat('sum.stem.', criterion)"/>
        <xsl:with-param name="a" select="format-number(critical_speed/value, '0.0')"/>
        <xsl:with-param name="b">
          <xsl:call-template name="place">
            <xsl:with-param name="height" select="height/value"/>
            <xsl:with-param name="section"
              select="../../../criteria/item[criterion = current()/criterion and scope = 'stem']/governing_section"/>
          </xsl:call-template>
        </xsl:with-param>
        <xsl:with-param name="c">
          <xsl:call-template name="gust"><xsl:with-param name="x" select="critical_speed/value"/></xsl:call-template>
        </xsl:with-param>
      </xsl:call-template>
    </xsl:if>
  </xsl:for-each>
  <xsl:if test="verdict/criterion != 'breakage' and not($stem) and critical_stem/outcome = 'above'">
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
      <xsl:with-param name="id">sum.stem.above</xsl:with-param>
      <xsl:with-param name="a">
        <xsl:call-template name="given"><xsl:with-param name="x" select="critical_stem/speed_high/value"/></xsl:call-template>
      </xsl:with-param>
      <xsl:with-param name="b">
        <xsl:call-template name="gust"><xsl:with-param name="x" select="critical_stem/speed_high/value"/></xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
  </xsl:if>
  <xsl:call-template name="overturns-too"/>
  <xsl:call-template name="room-lines"/>
  <xsl:call-template name="fails-first"/>
  <xsl:variable name="same"><xsl:call-template name="same-from-all"/></xsl:variable>
  <xsl:if test="$same = 'yes'">
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
      <xsl:with-param name="id">sum.weakest.none</xsl:with-param><xsl:with-param name="a" select="directions/number"/>
    </xsl:call-template>
  </xsl:if>
  <xsl:for-each select="directions[$same != 'yes']/directions/item[(loss | self::*[not(loss)]/critical_stem)/outcome = 'found' and
    critical_stem/within_limits = 'true']">
    <xsl:sort select="(loss/critical_speed | self::*[not(loss)]/critical_stem/speed)/value" data-type="number"/>
    <xsl:if test="position() = 1">
      <xsl:value-of select="$gap"/>
      <xsl:call-template name="say">
        <xsl:with-param name="id">sum.weakest</xsl:with-param>
        <xsl:with-param name="a">
          <xsl:call-template name="fixed">
            <xsl:with-param name="x" select="$degrees * from/value"/><xsl:with-param name="pattern">0.#</xsl:with-param>
          </xsl:call-template>
        </xsl:with-param>
        <xsl:with-param name="b" select="format-number((loss/critical_speed | self::*[not(loss)]/critical_stem/speed)/value, '0.0')"/>
        <xsl:with-param name="c" select="../../number"/>
        <xsl:with-param name="d">
          <xsl:call-template name="gust"><xsl:with-param name="x" select="(loss/critical_speed |
            self::*[not(loss)]/critical_stem/speed)/value"/></xsl:call-template>
        </xsl:with-param>
      </xsl:call-template>
    </xsl:if>
  </xsl:for-each>
  <xsl:if test="(model/leaf_area/value &gt; 0 or model/frontal_area/value &gt; 0) and
    (verdict/critical_speed | self::*[not(verdict)]/critical_stem/speed)/value &gt; species/streamlining/speed_high/value">
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
      <xsl:with-param name="id">
        <xsl:text>sum.extrapolated</xsl:text><xsl:if test="not(verdict/criteria/item[criterion = 'overturning'])">.stem</xsl:if>
      </xsl:with-param>
      <xsl:with-param name="a">
        <xsl:call-template name="given">
          <xsl:with-param name="x" select="species/streamlining/speed_high/value"/>
        </xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
  </xsl:if>
</xsl:template>

<!-- What has no answer. -->
<xsl:template name="voids">
  <xsl:if test="winds/item[status != 'ok']">
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
      <xsl:with-param name="id">sum.no-answer</xsl:with-param>
      <xsl:with-param name="a">
        <xsl:call-template name="list">
          <xsl:with-param name="items" select="winds/item[status != 'ok']/speed/value"/>
        </xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
  </xsl:if>
</xsl:template>

<!-- Which bends most and least at the highest wind speed with answers for all, and which breaks first. -->
<xsl:template name="compare">
  <xsl:variable name="k">
    <xsl:for-each select="$trees[1]/winds/item">
      <xsl:sort select="position()" data-type="number" order="descending"/>
      <xsl:variable name="p" select="count(preceding-sibling::item) + 1"/>
      <xsl:if test="not($trees/winds/item[$p][status != 'ok' or
        loss_safety/value &lt;= 1])"><xsl:value-of select="concat($p, ' ')"/></xsl:if>
    </xsl:for-each>
  </xsl:variable>
  <xsl:if test="$k != ''">
    <xsl:variable name="p" select="number(substring-before($k, ' '))"/>
    <xsl:variable name="most">
      <xsl:for-each select="$trees">
        <xsl:sort select="winds/item[$p]/*[self::mean_state or (self::tip_deflection and
          not(../mean_state))]/descendant-or-self::tip_deflection/value" data-type="number" order="descending"/>
        <xsl:if test="position() = 1"><xsl:value-of select="count(preceding-sibling::item) + 1"/></xsl:if>
      </xsl:for-each>
    </xsl:variable>
    <xsl:variable name="least">
      <xsl:for-each select="$trees">
        <xsl:sort select="winds/item[$p]/*[self::mean_state or (self::tip_deflection and
          not(../mean_state))]/descendant-or-self::tip_deflection/value" data-type="number"/>
        <xsl:if test="position() = 1"><xsl:value-of select="count(preceding-sibling::item) + 1"/></xsl:if>
      </xsl:for-each>
    </xsl:variable>
    <xsl:call-template name="say">
      <xsl:with-param name="id">sum.most</xsl:with-param>
      <xsl:with-param name="a">
        <xsl:call-template name="given">
          <xsl:with-param name="x" select="$trees[1]/winds/item[$p]/speed/value"/>
        </xsl:call-template>
      </xsl:with-param>
      <xsl:with-param name="b">
        <xsl:call-template name="name"><xsl:with-param name="tree" select="$trees[number($most)]"/></xsl:call-template>
      </xsl:with-param>
      <xsl:with-param name="c">
        <xsl:call-template name="number">
          <xsl:with-param name="x" select="$trees[number($most)]/winds/item[$p]/*[self::mean_state or (self::tip_deflection and
          not(../mean_state))]/descendant-or-self::tip_deflection/value"/>
        </xsl:call-template>
      </xsl:with-param>
      <xsl:with-param name="d">
        <xsl:call-template name="name"><xsl:with-param name="tree" select="$trees[number($least)]"/></xsl:call-template>
      </xsl:with-param>
      <xsl:with-param name="e">
        <xsl:call-template name="number">
          <xsl:with-param name="x" select="$trees[number($least)]/winds/item[$p]/*[self::mean_state or (self::tip_deflection and
          not(../mean_state))]/descendant-or-self::tip_deflection/value"/>
        </xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
    <xsl:value-of select="$gap"/>
  </xsl:if>
  <xsl:for-each select="$trees[(verdict/critical_speed | self::*[not(verdict)]/critical_stem/speed)/value != '']">
    <xsl:sort select="(verdict/critical_speed | self::*[not(verdict)]/critical_stem/speed)/value" data-type="number"/>
    <xsl:if test="position() = 1">
      <xsl:call-template name="say">
        <xsl:with-param name="id">sum.first</xsl:with-param>
        <xsl:with-param name="a"><xsl:call-template name="name"/></xsl:with-param>
        <xsl:with-param name="b" select="format-number((verdict/critical_speed | self::*[not(verdict)]/critical_stem/speed)/value, '0.0')"/>
        <xsl:with-param name="c">
          <xsl:call-template name="gust"><xsl:with-param name="x" select="(verdict/critical_speed |
            self::*[not(verdict)]/critical_stem/speed)/value"/></xsl:call-template>
        </xsl:with-param>
      </xsl:call-template>
    </xsl:if>
  </xsl:for-each>
</xsl:template>

<!-- What to be careful about: how many values are not measured, and crowns beyond their evidence. -->
<xsl:template name="care">
  <xsl:variable name="values" select="$trees/species/values/item[used = 'true' and value != '']"/>
  <xsl:variable name="doubtful" select="$values[status = 'assumed' or status = 'borrowed']"/>
  <xsl:variable name="untested" select="$trees[critical_stem/within_limits = 'true' and
    not(method/solver/as_printed = 'true') and (model/leaf_area/value &gt; 0 or model/frontal_area/value &gt; 0) and
    (verdict/critical_speed | self::*[not(verdict)]/critical_stem/speed)/value &gt;
    species/streamlining/speed_high/value]"/>
  <xsl:call-template name="say">
    <xsl:with-param name="id">
      <xsl:choose><xsl:when test="$doubtful">sum.care</xsl:when><xsl:otherwise>sum.care.sure</xsl:otherwise></xsl:choose>
    </xsl:with-param>
    <xsl:with-param name="a" select="count($doubtful)"/><xsl:with-param name="b" select="count($values)"/>
    <xsl:with-param name="c" select="4"/>
  </xsl:call-template>
  <xsl:if test="$untested">
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
      <xsl:with-param name="id">sum.care.crown</xsl:with-param>
      <xsl:with-param name="a">
        <xsl:call-template name="names">
          <xsl:with-param name="of" select="$untested"/><xsl:with-param name="last">list.last</xsl:with-param>
        </xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
  </xsl:if>
</xsl:template>

<!-- What a scan may lack: wood, and the crown. -->
<xsl:template name="care-scan">
  <xsl:for-each select="$warned[code = 'unseen-wood' or code = 'stems-apart']">
    <p class="care">
      <xsl:call-template name="term">
        <xsl:with-param name="id" select="concat('warn.', code)"/><xsl:with-param name="otherwise" select="code"/>
      </xsl:call-template>
      <xsl:call-template name="say"><xsl:with-param name="id">colon</xsl:with-param></xsl:call-template>
      <xsl:call-template name="warning"/>
    </p>
  </xsl:for-each>
</xsl:template>

<xsl:template name="summary">
  <div class="summary">
    <xsl:for-each select="$trees">
      <xsl:variable name="small"><xsl:call-template name="small"/></xsl:variable>
      <p>
        <b>
          <xsl:choose>
            <xsl:when test="method/solver/as_printed = 'true'">
              <xsl:call-template name="say">
                <xsl:with-param name="id">sum.printed</xsl:with-param>
                <xsl:with-param name="a"><xsl:call-template name="name"/></xsl:with-param>
              </xsl:call-template>
            </xsl:when>
            <xsl:when test="$small != ''"><xsl:value-of select="$small"/></xsl:when>
            <xsl:otherwise><xsl:call-template name="verdict"/><xsl:call-template name="unassessed"/></xsl:otherwise>
          </xsl:choose>
        </b>
      </p>
      <p>
        <xsl:if test="assessment/from/value != ''">
          <xsl:call-template name="say">
            <xsl:with-param name="id">sum.from</xsl:with-param>
            <xsl:with-param name="a">
              <xsl:call-template name="compass"><xsl:with-param name="of" select="assessment"/></xsl:call-template></xsl:with-param>
          </xsl:call-template>
          <xsl:value-of select="$gap"/>
        </xsl:if>
        <xsl:call-template name="tips"/>
      </p>
      <p><xsl:call-template name="strength"/></p>
      <p><xsl:call-template name="loss"/><xsl:call-template name="iv-brief"/><xsl:call-template name="voids"/></p>
    </xsl:for-each>
  </div>
  <p>
    <xsl:call-template name="say">
      <xsl:with-param name="id"><xsl:text>sum.wind</xsl:text><xsl:if test="$gusts">.gusts</xsl:if></xsl:with-param>
      <xsl:with-param name="a" select="$reference"/>
      <xsl:with-param name="b">
        <xsl:call-template name="term">
          <xsl:with-param name="id" select="concat('peak.', $gusts[1]/name)"/>
          <xsl:with-param name="otherwise" select="$gusts[1]/title"/>
        </xsl:call-template>
      </xsl:with-param>
      <xsl:with-param name="c">
        <xsl:for-each select="$trees/winds/item/peak/load_factor_gusts/value[. != '']">
          <xsl:sort data-type="number"/>
          <xsl:if test="position() = 1 or position() = last()">
            <xsl:if test="position() &gt; 1">
              <xsl:call-template name="say"><xsl:with-param name="id">sum.to</xsl:with-param></xsl:call-template>
            </xsl:if>
            <xsl:value-of select="format-number(., '0.0')"/>
          </xsl:if>
        </xsl:for-each>
      </xsl:with-param>
    </xsl:call-template>
    <xsl:if test="$warned">
      <xsl:value-of select="$gap"/>
      <xsl:call-template name="say">
        <xsl:with-param name="id">
          <xsl:choose>
            <xsl:when test="count($warned) = 1">sum.warning</xsl:when><xsl:otherwise>sum.warnings</xsl:otherwise>
          </xsl:choose>
        </xsl:with-param>
        <xsl:with-param name="a" select="count($warned)"/><xsl:with-param name="b" select="6"/>
      </xsl:call-template>
    </xsl:if>
  </p>
</xsl:template>
</xsl:stylesheet>
