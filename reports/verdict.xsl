<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- Loss of the tree: the headline of a tree, what it was chosen from, what was not assessed, branches by thickness. The
     context is a tree. Results of earlier versions have no <verdict>: they know the stem's breakage alone. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform">

<!-- The wind at which the tree is lost; empty where none was found. -->
<xsl:template name="loss-speed">
  <xsl:value-of select="(verdict/critical_speed | self::*[not(verdict)]/critical_stem/speed)/value"/>
</xsl:template>

<!-- "27.3", "> 60" or a dash: a critical wind of a criterion; as gust with gust=1. -->
<xsl:template name="wind-of">
  <xsl:param name="of"/><xsl:param name="gust" select="0"/>
  <xsl:variable name="x">
    <xsl:choose>
      <xsl:when test="$of/outcome = 'found'"><xsl:value-of select="$of/critical_speed/value"/></xsl:when>
      <xsl:when test="$of/outcome = 'self-weight'">0</xsl:when>
      <xsl:when test="$of/outcome = 'above'"><xsl:value-of select="$of/speed_high/value"/></xsl:when>
    </xsl:choose>
  </xsl:variable>
  <xsl:if test="$of/outcome = 'above'">&gt;&#160;</xsl:if>
  <xsl:choose>
    <xsl:when test="$x = ''">–</xsl:when>
    <xsl:when test="$gust = 1">
      <xsl:call-template name="gust"><xsl:with-param name="x" select="$x"/></xsl:call-template>
    </xsl:when>
    <xsl:otherwise><xsl:value-of select="format-number($x, '0.0')"/></xsl:otherwise>
  </xsl:choose>
</xsl:template>

<!-- What was not assessed, a sentence each. -->
<xsl:template name="unassessed">
  <xsl:for-each select="verdict/not_assessed/item">
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
      <xsl:with-param name="id" select="concat('unassessed.', criterion)"/>
      <xsl:with-param name="a"><xsl:call-template name="unassessed-why"/></xsl:with-param>
    </xsl:call-template>
  </xsl:for-each>
  <xsl:if test="not(verdict)">
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
      <xsl:with-param name="id">unassessed.overturning</xsl:with-param>
      <xsl:with-param name="a">
        <xsl:call-template name="say"><xsl:with-param name="id">unassessed.unsaid</xsl:with-param></xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
  </xsl:if>
</xsl:template>

<xsl:template name="unassessed-why">
  <xsl:choose>
    <xsl:when test="criterion = 'size-effect'">
      <xsl:call-template name="say"><xsl:with-param name="id">unassessed.size</xsl:with-param></xsl:call-template>
    </xsl:when>
    <xsl:when test="criterion = 'soil'">
      <xsl:call-template name="say"><xsl:with-param name="id">unassessed.any-soil</xsl:with-param></xsl:call-template>
    </xsl:when>
    <xsl:when test="unsaid = 'true'">
      <xsl:call-template name="say"><xsl:with-param name="id">unassessed.unsaid</xsl:with-param></xsl:call-template>
    </xsl:when>
    <xsl:otherwise><xsl:call-template name="term">
      <xsl:with-param name="id" select="reason"/><xsl:with-param name="otherwise" select="reason"/></xsl:call-template></xsl:otherwise>
  </xsl:choose>
</xsl:template>

<!-- At which wind it overturns, where that governs. -->
<xsl:template name="overturns-first">
  <xsl:call-template name="say">
    <xsl:with-param name="id">
      <xsl:text>sum.</xsl:text>
      <xsl:if test="contains(' found above self-weight ', concat(' ', verdict/outcome, ' '))">overturn.</xsl:if>
      <xsl:value-of select="verdict/outcome"/>
    </xsl:with-param>
    <xsl:with-param name="a">
      <xsl:choose>
        <xsl:when test="verdict/outcome = 'found'">
          <xsl:value-of select="format-number(verdict/critical_speed/value, '0.0')"/>
        </xsl:when>
        <xsl:when test="verdict/outcome = 'above'">
          <xsl:call-template name="given"><xsl:with-param name="x" select="verdict/speed_high/value"/></xsl:call-template>
        </xsl:when>
        <xsl:otherwise>
          <xsl:call-template name="fixed"><xsl:with-param name="x" select="verdict/speed_low/value"/></xsl:call-template>
        </xsl:otherwise>
      </xsl:choose>
    </xsl:with-param>
    <xsl:with-param name="b">
      <xsl:call-template name="fixed"><xsl:with-param name="x" select="verdict/speed_high/value"/></xsl:call-template>
    </xsl:with-param>
    <xsl:with-param name="c"><xsl:call-template name="wind-of">
      <xsl:with-param name="of" select="verdict"/><xsl:with-param name="gust" select="1"/>
    </xsl:call-template></xsl:with-param>
    <xsl:with-param name="d">
      <xsl:call-template name="given"><xsl:with-param name="x" select="$trees[1]/scenario/wind_height/value"/></xsl:call-template>
    </xsl:with-param>
    <xsl:with-param name="e" select="$trees[1]/scenario/wind_terrain"/>
  </xsl:call-template>
</xsl:template>

<!-- Overturning where it does not govern; then saturated soil. -->
<xsl:template name="overturns-too">
  <xsl:variable name="all" select="verdict/criteria/item"/>
  <xsl:variable name="dry" select="$all[criterion = 'overturning']"/>
  <xsl:if test="$dry">
    <xsl:if test="verdict/criterion != 'overturning'">
      <xsl:value-of select="$gap"/>
      <xsl:call-template name="say">
        <xsl:with-param name="id">sum.overturn.too</xsl:with-param>
        <xsl:with-param name="a">
          <xsl:call-template name="wind-of"><xsl:with-param name="of" select="$dry"/></xsl:call-template>
        </xsl:with-param>
        <xsl:with-param name="b"><xsl:call-template name="wind-of">
          <xsl:with-param name="of" select="$dry"/><xsl:with-param name="gust" select="1"/>
        </xsl:call-template></xsl:with-param>
      </xsl:call-template>
    </xsl:if>
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
      <xsl:with-param name="id">sum.saturated</xsl:with-param>
      <xsl:with-param name="a"><xsl:call-template name="wind-of">
        <xsl:with-param name="of" select="$all[criterion = 'overturning-saturated-low']"/>
      </xsl:call-template></xsl:with-param>
      <xsl:with-param name="b"><xsl:call-template name="wind-of">
        <xsl:with-param name="of" select="$all[criterion = 'overturning-saturated-high']"/>
      </xsl:call-template></xsl:with-param>
      <xsl:with-param name="c"><xsl:call-template name="wind-of">
        <xsl:with-param name="of" select="$all[criterion = 'overturning-saturated-low']"/><xsl:with-param name="gust" select="1"/>
      </xsl:call-template></xsl:with-param>
      <xsl:with-param name="d"><xsl:call-template name="wind-of">
        <xsl:with-param name="of" select="$all[criterion = 'overturning-saturated-high']"/><xsl:with-param name="gust" select="1"/>
      </xsl:call-template></xsl:with-param>
      <xsl:with-param name="e" select="format-number(verdict/anchorage/saturated_low, '0.00')"/>
      <xsl:with-param name="f" select="format-number(verdict/anchorage/saturated_high, '0.00')"/>
    </xsl:call-template>
  </xsl:if>
</xsl:template>

<!-- When it moves as far as the limits that are given; that does not lose it. The context is a tree. -->
<xsl:template name="room-lines">
  <xsl:for-each select="verdict/criteria/item[(criterion = 'corridor' or criterion = 'tip-angle') and (outcome = 'found' or
    outcome = 'above' or outcome = 'self-weight')]">
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
      <xsl:with-param name="id" select="concat('sum.', criterion, '.', outcome)"/>
      <xsl:with-param name="a"><xsl:call-template name="room-limit"/></xsl:with-param>
      <xsl:with-param name="b">
        <xsl:choose>
          <xsl:when test="outcome = 'above'">
            <xsl:call-template name="given"><xsl:with-param name="x" select="speed_high/value"/></xsl:call-template>
          </xsl:when>
          <xsl:otherwise>
            <xsl:call-template name="fixed"><xsl:with-param name="x" select="critical_speed/value"/></xsl:call-template>
          </xsl:otherwise>
        </xsl:choose>
      </xsl:with-param>
      <xsl:with-param name="c"><xsl:call-template name="gust">
        <xsl:with-param name="x" select="self::*[outcome = 'above']/speed_high/value | self::*[outcome != 'above']/critical_speed/value"/>
      </xsl:call-template></xsl:with-param>
    </xsl:call-template>
  </xsl:for-each>
</xsl:template>

<!-- The part that fails first, where it is not the stem; then from which other direction a part fails in less wind. -->
<xsl:template name="fails-first">
  <xsl:variable name="first" select="first | self::*[not(first)]/critical"/>
  <xsl:variable name="main" select="$first[governing_section/level &gt; 0 and outcome = 'found' and within_limits = 'true']"/>
  <xsl:for-each select="$main">
    <xsl:variable name="section" select="governing_section"/>
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
      <xsl:with-param name="id">
        <xsl:text>sum.part</xsl:text>
        <xsl:if test="twig = 'true' or (not(twig) and $section/diameter/value &lt; ../verdict/branches_from/value)">.twig</xsl:if>
      </xsl:with-param>
      <xsl:with-param name="a"><xsl:call-template name="part">
        <xsl:with-param name="level" select="$section/part"/>
      </xsl:call-template></xsl:with-param>
      <xsl:with-param name="b"><xsl:call-template name="segment">
        <xsl:with-param name="section" select="$section"/>
      </xsl:call-template></xsl:with-param>
      <xsl:with-param name="c" select="format-number($section/height/value, '0.0')"/>
      <xsl:with-param name="d" select="format-number(speed/value, '0.0')"/>
      <xsl:with-param name="e">
        <xsl:call-template name="gust"><xsl:with-param name="x" select="speed/value"/></xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
  </xsl:for-each>
  <xsl:for-each select="directions/directions/item/first[governing_section/level &gt; 0 and outcome = 'found' and within_limits = 'true']">
    <xsl:sort select="speed/value" data-type="number"/>
    <xsl:if test="position() = 1 and not($first/speed/value &lt;= 1.005 * speed/value)">
      <xsl:value-of select="$gap"/>
      <xsl:call-template name="say">
        <xsl:with-param name="id">sum.part.from</xsl:with-param>
        <xsl:with-param name="a" select="format-number($degrees * ../from/value, '0.#')"/>
        <xsl:with-param name="b"><xsl:call-template name="part">
          <xsl:with-param name="level" select="governing_section/part"/>
        </xsl:call-template></xsl:with-param>
        <xsl:with-param name="c" select="format-number(speed/value, '0.0')"/>
        <xsl:with-param name="d">
          <xsl:call-template name="gust"><xsl:with-param name="x" select="speed/value"/></xsl:call-template>
        </xsl:with-param>
      </xsl:call-template>
    </xsl:if>
  </xsl:for-each>
</xsl:template>

<!-- An outcome of a search in words, of the string `id`. -->
<xsl:template name="reached">
  <xsl:param name="of"/><xsl:param name="id"/>
  <xsl:call-template name="say">
    <xsl:with-param name="id" select="$id"/>
    <xsl:with-param name="a">
      <xsl:choose>
        <xsl:when test="$of/outcome = 'above'">
          <xsl:call-template name="given"><xsl:with-param name="x" select="$of/speed_high/value"/></xsl:call-template>
        </xsl:when>
        <xsl:otherwise>
          <xsl:call-template name="fixed"><xsl:with-param name="x" select="$of/speed_low/value"/></xsl:call-template>
        </xsl:otherwise>
      </xsl:choose>
    </xsl:with-param>
    <xsl:with-param name="b">
      <xsl:call-template name="fixed"><xsl:with-param name="x" select="$of/speed_high/value"/></xsl:call-template>
    </xsl:with-param>
  </xsl:call-template>
</xsl:template>

<!-- The segment that fails, and what its weight does to it at rest. -->
<xsl:template name="failing">
  <xsl:param name="section"/>
  <xsl:if test="$section/diameter/value != ''">
    <span class="why">
      <xsl:call-template name="segment"><xsl:with-param name="section" select="$section"/></xsl:call-template>
      <xsl:if test="$section/weight_stress/value != ''">
        <xsl:call-template name="say">
          <xsl:with-param name="id">segment.weight</xsl:with-param>
          <xsl:with-param name="a">
            <xsl:call-template name="fixed">
              <xsl:with-param name="x" select="$section/weight_stress/value div 1000000"/>
            </xsl:call-template>
          </xsl:with-param>
        </xsl:call-template>
      </xsl:if>
    </span>
  </xsl:if>
</xsl:template>

<!-- Rows of the table of critical winds: every criterion that loses the tree, the one that governs marked; overturning also
     in saturated soil. -->
<xsl:template name="loss-rows">
  <xsl:variable name="tree" select="."/>
  <xsl:for-each select="verdict/criteria/item">
    <xsl:variable name="of" select="criterion"/>
    <xsl:variable name="governs" select="$of = ../../criterion"/>
    <xsl:variable name="section" select="$tree/criteria/item[criterion = $of and
      scope = substring('treestem', 1 + 4 * not($of = 'corridor'), 4)]/governing_section"/>
    <tr>
      <xsl:attribute name="class">
        <xsl:if test="within_limits = 'false'">void </xsl:if><xsl:if test="$governs">governs</xsl:if>
      </xsl:attribute>
      <td><xsl:if test="position() = 1">
        <xsl:call-template name="name"><xsl:with-param name="tree" select="$tree"/></xsl:call-template>
      </xsl:if></td>
      <td><xsl:call-template name="criterion-name"/></td>
      <td>
        <xsl:if test="$governs">
          <xsl:call-template name="say"><xsl:with-param name="id">governs</xsl:with-param></xsl:call-template>
          <xsl:call-template name="say"><xsl:with-param name="id">colon</xsl:with-param></xsl:call-template>
        </xsl:if>
        <xsl:call-template name="reached">
          <xsl:with-param name="of" select="."/>
          <xsl:with-param name="id">
            <xsl:choose>
              <xsl:when test="within_limits = 'false'">outcome.void</xsl:when>
              <xsl:when test="not(contains(' found above self-weight ', concat(' ', outcome, ' ')))">
                <xsl:value-of select="concat('outcome.', outcome)"/>
              </xsl:when>
              <xsl:when test="starts-with($of, 'overturning')"><xsl:value-of select="concat('outcome.overturn.', outcome)"/></xsl:when>
              <xsl:when test="$of = 'breakage'"><xsl:value-of select="concat('outcome.', outcome)"/></xsl:when>
              <xsl:when test="$of = 'corridor' or $of = 'tip-angle'">
                <xsl:value-of select="concat('outcome.', $of, '.', outcome)"/>
              </xsl:when>
              <xsl:when test="outcome = 'found'"><xsl:value-of select="concat('outcome.', $of, '.found')"/></xsl:when>
              <xsl:otherwise><xsl:value-of select="concat('outcome.reached.', outcome)"/></xsl:otherwise>
            </xsl:choose>
          </xsl:with-param>
        </xsl:call-template>
        <xsl:call-template name="failing"><xsl:with-param name="section" select="$section"/></xsl:call-template>
      </td>
      <xsl:call-template name="cell"><xsl:with-param name="x" select="critical_speed/value"/></xsl:call-template>
      <td class="r"><xsl:call-template name="gust"><xsl:with-param name="x" select="critical_speed/value"/></xsl:call-template></td>
      <xsl:choose>
        <xsl:when test="$section">
          <xsl:call-template name="cell"><xsl:with-param name="x" select="height/value"/></xsl:call-template>
        </xsl:when>
        <xsl:otherwise><td class="r">–</td></xsl:otherwise>
      </xsl:choose>
      <td class="r"><xsl:if test="position() = 1">
        <xsl:call-template name="given">
          <xsl:with-param name="x" select="$tree/species/streamlining/speed_high/value"/>
        </xsl:call-template>
      </xsl:if></td>
    </tr>
  </xsl:for-each>
</xsl:template>

<!-- Rows of the same table: what was not assessed, and why. The context is a tree. -->
<xsl:template name="unassessed-rows">
  <xsl:for-each select="verdict/not_assessed/item">
    <tr>
      <td/>
      <td><xsl:call-template name="criterion-name"/></td>
      <td colspan="5">
        <xsl:call-template name="say">
          <xsl:with-param name="id">outcome.unassessed</xsl:with-param>
          <xsl:with-param name="a"><xsl:call-template name="unassessed-why"/></xsl:with-param>
        </xsl:call-template>
      </td>
    </tr>
  </xsl:for-each>
</xsl:template>

<!-- By what an anchorage was found: its method, or the largest moment of a test that is more. -->
<xsl:template name="anchorage-id">
  <xsl:text>anchorage.</xsl:text>
  <xsl:choose>
    <xsl:when test="moment_carried/value &gt; moment_by_method/value">carried</xsl:when>
    <xsl:otherwise><xsl:value-of select="name"/></xsl:otherwise>
  </xsl:choose>
</xsl:template>

<!-- How the anchorage was found. -->
<xsl:template name="anchorage-note">
  <xsl:for-each select="verdict/anchorage[name != '']">
    <p>
      <xsl:call-template name="say">
        <xsl:with-param name="id">anchorage</xsl:with-param>
        <xsl:with-param name="a"><xsl:for-each select="../.."><xsl:call-template name="name"/></xsl:for-each></xsl:with-param>
        <xsl:with-param name="b">
          <!-- results of earlier versions have the moment alone -->
          <xsl:call-template name="number">
            <xsl:with-param name="x" select="(moment_by_method | moment[not(../moment_by_method)])/value div 1000"/></xsl:call-template>
        </xsl:with-param>
        <xsl:with-param name="c">
          <xsl:call-template name="say"><xsl:with-param name="id" select="concat('anchorage.', name)"/></xsl:call-template>
        </xsl:with-param>
        <xsl:with-param name="d">
          <xsl:call-template name="fine"><xsl:with-param name="text" select="text"/></xsl:call-template></xsl:with-param>
        <xsl:with-param name="e" select="source"/>
        <xsl:with-param name="f">
          <xsl:call-template name="fine"><xsl:with-param name="text" select="validity"/></xsl:call-template></xsl:with-param>
      </xsl:call-template>
      <xsl:value-of select="$gap"/>
      <xsl:if test="moment_carried/value &gt; moment_by_method/value">
        <xsl:call-template name="say">
          <xsl:with-param name="id">anchorage.more</xsl:with-param>
          <xsl:with-param name="a">
            <xsl:call-template name="number"><xsl:with-param name="x" select="moment_carried/value div 1000"/></xsl:call-template>
          </xsl:with-param>
        </xsl:call-template>
        <xsl:value-of select="$gap"/>
      </xsl:if>
      <xsl:call-template name="say"><xsl:with-param name="id">anchorage.static</xsl:with-param></xsl:call-template>
    </p>
  </xsl:for-each>
</xsl:template>

<!-- Branches by thickness. -->
<xsl:template name="branch-table">
  <table class="data">
    <xsl:call-template name="caption">
      <xsl:with-param name="id">t.branches</xsl:with-param>
      <xsl:with-param name="a"><xsl:call-template name="given">
        <xsl:with-param name="x" select="100 * $trees[1]/verdict/branches_from/value"/>
      </xsl:call-template></xsl:with-param>
      <xsl:with-param name="b">
        <xsl:call-template name="given"><xsl:with-param name="x" select="$trees[1]/verdict/speed/value"/></xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
    <thead><tr><xsl:call-template name="heads">
      <xsl:with-param name="of">c.br.tree;c.br.thickness:cm;c.br.segments:;c.br.safety:;c.br.fails:m/s;c.br.worst</xsl:with-param>
    </xsl:call-template></tr></thead>
    <tbody>
      <xsl:for-each select="$trees/verdict/thicknesses/item">
        <tr>
          <td><xsl:if test="position() = 1 or not(preceding-sibling::item)">
            <xsl:for-each select="../../.."><xsl:call-template name="name"/></xsl:for-each>
          </xsl:if></td>
          <td class="r">
            <xsl:call-template name="given"><xsl:with-param name="x" select="100 * thickness_low/value"/></xsl:call-template>
            <xsl:text>–</xsl:text>
            <xsl:if test="thickness_high/value != ''">
              <xsl:call-template name="given"><xsl:with-param name="x" select="100 * thickness_high/value"/></xsl:call-template>
            </xsl:if>
          </td>
          <td class="r"><xsl:value-of select="segments"/></td>
          <td class="r"><xsl:call-template name="number"><xsl:with-param name="x" select="safety/value"/></xsl:call-template></td>
          <td class="r">
            <xsl:choose>
              <xsl:when test="fails_at/value != ''">
                <xsl:call-template name="given"><xsl:with-param name="x" select="fails_at/value"/></xsl:call-template>
              </xsl:when>
              <xsl:otherwise>–</xsl:otherwise>
            </xsl:choose>
          </td>
          <td>
            <xsl:if test="governing_section/diameter/value != ''">
              <xsl:call-template name="say">
                <xsl:with-param name="id">br.worst</xsl:with-param>
                <xsl:with-param name="a">
                  <xsl:call-template name="part"><xsl:with-param name="level" select="governing_section/part"/></xsl:call-template>
                </xsl:with-param>
                <xsl:with-param name="b">
                  <xsl:call-template name="segment"><xsl:with-param name="section" select="governing_section"/></xsl:call-template>
                </xsl:with-param>
                <xsl:with-param name="c" select="format-number(governing_section/height/value, '0.0')"/>
              </xsl:call-template>
            </xsl:if>
          </td>
        </tr>
      </xsl:for-each>
    </tbody>
  </table>
</xsl:template>
</xsl:stylesheet>
