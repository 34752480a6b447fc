<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- The first page of a report: of one tree what fails, in which wind, how sure that is and what was not looked at, beside a
     picture; of several trees their ranking and all shapes. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform" xmlns:svg="http://www.w3.org/2000/svg"
                exclude-result-prefixes="svg">

<!-- The strongest wind with an answer. The context is a tree. -->
<xsl:template name="front-wind">
  <xsl:choose>
    <xsl:when test="verdict/speed/value != ''"><xsl:value-of select="verdict/speed/value"/></xsl:when>
    <xsl:otherwise><xsl:value-of select="winds/item[last()]/speed/value"/></xsl:otherwise>
  </xsl:choose>
</xsl:template>

<!-- A wind with as many figures as its interval allows: whole metres a second where that is wider than two of them, unless (near) it
     is within one of the wind that is given, on whose side it must be seen to be. The context is a tree. -->
<xsl:template name="front-figures">
  <xsl:param name="x"/><xsl:param name="near"/>
  <xsl:choose>
    <xsl:when test="not($near) and $x &gt;= 10 and interval/high_m_s - interval/low_m_s &gt; 2">
      <xsl:value-of select="format-number($x, '0')"/>
    </xsl:when>
    <xsl:otherwise><xsl:call-template name="number"><xsl:with-param name="x" select="$x"/></xsl:call-template></xsl:otherwise>
  </xsl:choose>
</xsl:template>

<!-- "25.2 m/s (3-s gust 38.3 m/s)" -->
<xsl:template name="front-speed">
  <xsl:param name="x"/><xsl:param name="id">fp.wind</xsl:param>
  <xsl:variable name="u"><xsl:call-template name="front-wind"/></xsl:variable>
  <xsl:variable name="near" select="$x - $u &lt; 1 and $u - $x &lt; 1"/>
  <xsl:call-template name="say">
    <xsl:with-param name="id" select="$id"/>
    <xsl:with-param name="a"><xsl:call-template name="front-figures">
      <xsl:with-param name="x" select="$x"/><xsl:with-param name="near" select="$near"/></xsl:call-template></xsl:with-param>
    <xsl:with-param name="b"><xsl:call-template name="front-figures">
      <xsl:with-param name="x" select="$x * $trees[1]/scenario/gust_over_mean/value"/>
      <xsl:with-param name="near" select="$near"/>
    </xsl:call-template></xsl:with-param>
  </xsl:call-template>
</xsl:template>

<!-- A row of safety: against what | safety | required, or the limit at which it fails | where. -->
<xsl:template name="front-safety">
  <xsl:param name="id"/><xsl:param name="safety"/><xsl:param name="high"/><xsl:param name="required"/><xsl:param name="where"/>
  <xsl:param name="name"/>
  <tr>
    <xsl:if test="$safety != '' and $required != '' and $safety &lt; $required">
      <xsl:attribute name="class">short</xsl:attribute>
    </xsl:if>
    <td>
      <xsl:call-template name="term"><xsl:with-param name="id" select="$id"/>
        <xsl:with-param name="otherwise" select="$name"/></xsl:call-template>
    </td>
    <td class="r">
      <b><xsl:call-template name="fixed">
        <xsl:with-param name="x" select="$safety"/><xsl:with-param name="pattern">0.00</xsl:with-param>
        <xsl:with-param name="bound" select="$required"/>
      </xsl:call-template>
      <xsl:if test="$high != ''">
        <xsl:text>–</xsl:text>
        <xsl:call-template name="fixed">
          <xsl:with-param name="x" select="$high"/><xsl:with-param name="pattern">0.00</xsl:with-param>
          <xsl:with-param name="bound" select="$required"/>
        </xsl:call-template>
      </xsl:if></b>
    </td>
    <td class="r">
      <xsl:call-template name="fixed">
        <xsl:with-param name="x" select="$required"/><xsl:with-param name="pattern">0.0#####</xsl:with-param>
      </xsl:call-template>
    </td>
    <td><xsl:copy-of select="$where"/></td>
  </tr>
</xsl:template>

<xsl:template name="front-section">
  <xsl:param name="section"/>
  <xsl:if test="$section/height/value != ''">
    <xsl:call-template name="say">
      <xsl:with-param name="id">fp.section</xsl:with-param>
      <xsl:with-param name="a">
        <xsl:call-template name="place">
          <xsl:with-param name="height" select="$section/height/value"/><xsl:with-param name="section" select="$section"/>
        </xsl:call-template>
      </xsl:with-param>
      <xsl:with-param name="b">
        <xsl:call-template name="number"><xsl:with-param name="x" select="100 * $section/diameter/value"/></xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
  </xsl:if>
</xsl:template>

<!-- What is on the tree, and how much of the wind blows with it. -->
<xsl:template name="front-load">
  <xsl:variable name="s" select="scenario"/>
  <xsl:if test="warnings/item[code = 'no-leaves']">
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say"><xsl:with-param name="id">fp.bare</xsl:with-param></xsl:call-template>
  </xsl:if>
  <xsl:if test="$s/snow/value &gt; 0">
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
      <xsl:with-param name="id">fp.snow</xsl:with-param>
      <xsl:with-param name="a">
        <xsl:call-template name="given"><xsl:with-param name="x" select="$s/snow/value"/></xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
  </xsl:if>
  <xsl:if test="$s/ice/value &gt; 0">
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
      <xsl:with-param name="id">fp.ice</xsl:with-param>
      <xsl:with-param name="a">
        <xsl:call-template name="given"><xsl:with-param name="x" select="1000 * $s/ice/value"/></xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
  </xsl:if>
  <xsl:if test="wetted/film_mm &gt; 0">
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
      <xsl:with-param name="id">fp.rain</xsl:with-param>
      <xsl:with-param name="a">
        <xsl:call-template name="given"><xsl:with-param name="x" select="wetted/film_mm"/></xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
  </xsl:if>
  <xsl:if test="$s/winter_wind/value &lt; 1">
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
      <xsl:with-param name="id">fp.share</xsl:with-param>
      <xsl:with-param name="a" select="format-number(100 * $s/winter_wind/value, '0.#')"/>
    </xsl:call-template>
  </xsl:if>
</xsl:template>

<!-- Rows of the stem: its elastic limit, its breakage, and another criterion that loses the tree or is nearer than breakage,
     in any direction. -->
<xsl:template name="front-stem">
  <xsl:variable name="u"><xsl:call-template name="front-wind"/></xsl:variable>
  <xsl:variable name="asked" select="assessment/required/value | assessment/required[not(value)]"/>
  <xsl:variable name="stem" select="criteria/item[scope = 'stem' and winds/item[speed/value = $u]/safety/value != '']"/>
  <xsl:variable name="breaks" select="$stem[criterion = 'breakage']/winds/item[speed/value = $u]/safety/value"/>
  <xsl:variable name="wood"> breakage elastic-limit torsion splitting ovalisation </xsl:variable>
  <xsl:variable name="around" select="assessment/criteria/item | assessment[not(criteria)]/breakage"/>
  <xsl:variable name="near">
    <xsl:for-each select="$around[safety/value &lt;= 1 or safety/value &lt; 0.995 * $around[criterion = 'breakage']/safety/value]">
      <xsl:value-of select="concat(' ', criterion, ' ')"/></xsl:for-each>
  </xsl:variable>
  <xsl:for-each select="$stem[criterion = 'elastic-limit' or criterion = 'breakage' or contains($near, concat(' ', criterion, ' ')) or
    not(contains($wood, concat(' ', criterion, ' '))) or (winds/item[speed/value = $u]/safety/value &lt; 0.995 * $breaks)]">
    <xsl:sort select="($around[criterion = current()/criterion] | self::*[not($around[criterion = current()/criterion])]
      /winds/item[speed/value = $u])/safety/value" data-type="number"/>
    <xsl:variable name="at" select="winds/item[speed/value = $u]"/>
    <!-- in wind from another direction it may be less -->
    <xsl:variable name="least" select="$around[criterion = current()/criterion]/safety/value[. &lt; $at/safety/value]"/>
    <xsl:call-template name="front-safety">
      <xsl:with-param name="id" select="concat('fp.', criterion)"/>
      <xsl:with-param name="name"><xsl:call-template name="criterion-name"/></xsl:with-param>
      <xsl:with-param name="safety" select="$least | $at[not($least)]/safety/value"/>
      <xsl:with-param name="required">
        <xsl:choose>
          <xsl:when test="$asked and contains($wood, concat(' ', criterion, ' '))"><xsl:value-of select="$asked"/></xsl:when>
          <xsl:otherwise><xsl:value-of select="required_safety/value"/></xsl:otherwise>
        </xsl:choose>
      </xsl:with-param>
      <xsl:with-param name="where">
        <xsl:variable name="other" select="$least/../.."/>
        <xsl:choose>
          <xsl:when test="$other/from/value != $other/ancestor::assessment/from/value">
            <xsl:call-template name="say">
              <xsl:with-param name="id">fp.section.from</xsl:with-param>
              <xsl:with-param name="a"><xsl:call-template name="number">
                <xsl:with-param name="x" select="$other/height/value"/></xsl:call-template></xsl:with-param>
              <xsl:with-param name="b"><xsl:call-template name="compass">
                <xsl:with-param name="of" select="$other"/></xsl:call-template></xsl:with-param>
            </xsl:call-template>
          </xsl:when>
          <xsl:otherwise><xsl:call-template name="front-section">
            <xsl:with-param name="section" select="$at/governing_section"/></xsl:call-template></xsl:otherwise>
        </xsl:choose>
      </xsl:with-param>
    </xsl:call-template>
  </xsl:for-each>
  <xsl:if test="not($stem)">
    <tr><td colspan="4">
      <xsl:call-template name="say"><xsl:with-param name="id">fp.no-stem</xsl:with-param></xsl:call-template></td></tr>
  </xsl:if>
</xsl:template>

<!-- The branch that is nearest to failing, of those that are listed. -->
<xsl:template name="front-branch">
  <xsl:for-each select="verdict/thicknesses/item[safety/value != '']">
    <xsl:sort select="safety/value" data-type="number"/>
    <xsl:if test="position() = 1">
      <xsl:call-template name="front-safety">
        <xsl:with-param name="id">fp.branch</xsl:with-param>
        <xsl:with-param name="safety" select="safety/value"/>
        <xsl:with-param name="required">1</xsl:with-param>
        <xsl:with-param name="where"><xsl:call-template name="front-section">
          <xsl:with-param name="section" select="governing_section"/></xsl:call-template></xsl:with-param>
      </xsl:call-template>
    </xsl:if>
  </xsl:for-each>
</xsl:template>

<!-- Rows of the root. -->
<xsl:template name="front-root">
  <xsl:variable name="all" select="verdict/criteria/item"/>
  <xsl:variable name="least"
    select="assessment/overturning/safety/value[. &lt; $all[criterion = 'overturning']/safety/value]"/>
  <xsl:variable name="required">
    <xsl:choose>
      <xsl:when test="assessment"><xsl:value-of select="assessment/required"/></xsl:when>
      <xsl:otherwise><xsl:value-of select="criteria/item[criterion = 'overturning']/required_safety/value"/></xsl:otherwise>
    </xsl:choose>
  </xsl:variable>
  <xsl:choose>
    <xsl:when test="$all[criterion = 'overturning']">
      <xsl:call-template name="front-safety">
        <xsl:with-param name="id">fp.overturning</xsl:with-param>
        <xsl:with-param name="safety" select="$least | $all[criterion = 'overturning' and not($least)]/safety/value"/>
        <xsl:with-param name="required" select="$required"/>
        <xsl:with-param name="where">
          <xsl:if test="verdict/anchorage/name != ''">
            <xsl:call-template name="say">
              <xsl:with-param name="id"><xsl:for-each select="verdict/anchorage"><xsl:call-template name="anchorage-id"/>
              </xsl:for-each></xsl:with-param></xsl:call-template>
          </xsl:if>
          <xsl:for-each select="assessment/overturning[from/value != ../from/value]">
            <xsl:value-of select="$gap"/>
            <xsl:call-template name="say">
              <xsl:with-param name="id">fp.from</xsl:with-param>
              <xsl:with-param name="a">
                <xsl:call-template name="compass"><xsl:with-param name="of" select="."/></xsl:call-template></xsl:with-param>
            </xsl:call-template>
          </xsl:for-each>
        </xsl:with-param>
      </xsl:call-template>
      <xsl:if test="$all[criterion = 'overturning-saturated-low']">
        <xsl:call-template name="front-safety">
          <xsl:with-param name="id">fp.saturated</xsl:with-param>
          <xsl:with-param name="safety"
            select="assessment[$least]/saturated_low | $all[criterion = 'overturning-saturated-low' and not($least)]/safety/value"/>
          <xsl:with-param name="high"
            select="assessment[$least]/saturated_high | $all[criterion = 'overturning-saturated-high' and not($least)]/safety/value"/>
          <xsl:with-param name="required" select="$required"/>
        </xsl:call-template>
      </xsl:if>
    </xsl:when>
    <xsl:otherwise>
      <tr>
        <td><xsl:call-template name="say"><xsl:with-param name="id">fp.overturning</xsl:with-param></xsl:call-template></td>
        <td colspan="3" class="lack">
          <xsl:call-template name="say"><xsl:with-param name="id">fp.not-assessed</xsl:with-param></xsl:call-template></td>
      </tr>
    </xsl:otherwise>
  </xsl:choose>
</xsl:template>

<xsl:template name="front-safeties">
  <table class="data front-safety">
    <thead><tr><xsl:call-template name="heads">
      <xsl:with-param name="of">
        <xsl:text>fp.c.against;fp.c.safety:;</xsl:text>
        <xsl:choose><xsl:when test="assessment">fp.c.required:</xsl:when><xsl:otherwise>fp.c.limit:</xsl:otherwise></xsl:choose>
        <xsl:text>;fp.c.where</xsl:text>
      </xsl:with-param>
      <xsl:with-param name="units">no</xsl:with-param>
    </xsl:call-template></tr></thead>
    <tbody>
      <xsl:call-template name="front-stem"/><xsl:call-template name="front-branch"/><xsl:call-template name="front-root"/>
    </tbody>
  </table>
</xsl:template>

<!-- At which wind a tree is lost, and by what: "23.0 m/s (3-s gust 35.0 m/s): overturns". -->
<xsl:template name="front-lost">
  <xsl:param name="of" select="verdict"/>
  <xsl:variable name="by" select="$of/criterion"/>
  <xsl:choose>
    <xsl:when test="not($of) or not($of/criteria/item)">
      <xsl:call-template name="say"><xsl:with-param name="id">fp.unknown</xsl:with-param></xsl:call-template>
    </xsl:when>
    <xsl:when test="$of/within_limits = 'false'">
      <xsl:call-template name="say"><xsl:with-param name="id">outcome.void</xsl:with-param></xsl:call-template>
    </xsl:when>
    <xsl:otherwise>
      <xsl:if test="$of/outcome = 'found'">
        <b>
          <xsl:call-template name="front-speed"><xsl:with-param name="x" select="$of/critical_speed/value"/></xsl:call-template></b>
        <xsl:call-template name="say"><xsl:with-param name="id">colon</xsl:with-param></xsl:call-template>
      </xsl:if>
      <xsl:call-template name="front-outcome"><xsl:with-param name="of" select="$of"/></xsl:call-template>
    </xsl:otherwise>
  </xsl:choose>
</xsl:template>

<!-- What happens at the critical wind of a verdict, in words. -->
<xsl:template name="front-outcome">
  <xsl:param name="of" select="verdict"/>
  <xsl:variable name="by" select="$of/criterion"/>
  <xsl:call-template name="reached">
    <xsl:with-param name="of" select="$of"/>
    <xsl:with-param name="id">
      <xsl:choose>
        <xsl:when test="not(contains(' found above self-weight ', concat(' ', $of/outcome, ' ')))">
          <xsl:value-of select="concat('outcome.', $of/outcome)"/>
        </xsl:when>
        <xsl:when test="$by = 'overturning'"><xsl:value-of select="concat('outcome.overturn.', $of/outcome)"/></xsl:when>
        <xsl:when test="$by = 'breakage'"><xsl:value-of select="concat('outcome.', $of/outcome)"/></xsl:when>
        <xsl:when test="$of/outcome = 'found'"><xsl:value-of select="concat('outcome.', $by, '.found')"/></xsl:when>
        <xsl:otherwise><xsl:value-of select="concat('outcome.reached.', $of/outcome)"/></xsl:otherwise>
      </xsl:choose>
    </xsl:with-param>
  </xsl:call-template>
</xsl:template>

<!-- The 90 % interval of the critical wind: "15 to 41 m/s (3-s gust 23 to 62 m/s)". -->
<xsl:template name="front-interval">
  <xsl:choose>
    <xsl:when test="interval">
      <xsl:for-each select="interval">
        <xsl:call-template name="say">
          <xsl:with-param name="id">fp.wind</xsl:with-param>
          <xsl:with-param name="a"><xsl:call-template name="iv-range">
            <xsl:with-param name="low" select="low_m_s"/><xsl:with-param name="high" select="high_m_s"/>
          </xsl:call-template></xsl:with-param>
          <xsl:with-param name="b"><xsl:call-template name="iv-range">
            <xsl:with-param name="low" select="low_gust_m_s"/><xsl:with-param name="high" select="high_gust_m_s"/>
            <xsl:with-param name="end"><xsl:call-template name="iv-gust-end"/></xsl:with-param>
          </xsl:call-template></xsl:with-param>
        </xsl:call-template>
      </xsl:for-each>
    </xsl:when>
    <xsl:otherwise>
      <xsl:call-template name="say"><xsl:with-param name="id">fp.no-interval</xsl:with-param></xsl:call-template></xsl:otherwise>
  </xsl:choose>
</xsl:template>

<!-- "yes": the critical winds from all directions agree within half a per cent. -->
<xsl:template name="same-from-all">
  <xsl:variable name="all" select="directions/directions/item[(loss | self::*[not(loss)]/critical_stem)/outcome = 'found']"/>
  <xsl:variable name="first" select="($all[1]/loss/critical_speed | $all[1][not(loss)]/critical_stem/speed)/value"/>
  <xsl:variable name="off" select="$all[(loss/critical_speed | self::*[not(loss)]/critical_stem/speed)/value &gt; 1.0025 * $first or
    (loss/critical_speed | self::*[not(loss)]/critical_stem/speed)/value &lt; 0.9975 * $first]"/>
  <xsl:if test="$all and not($off) and count($all) = count(directions/directions/item)">yes</xsl:if>
</xsl:template>

<xsl:template name="compass">
  <xsl:param name="of"/>
  <xsl:value-of select="format-number($degrees * $of/from/value, '0.#')"/>
</xsl:template>

<!-- Of which wind the critical wind and the figures of an assessment are, and what is less in wind from elsewhere. -->
<xsl:template name="front-assessed">
  <xsl:variable name="a" select="assessment"/>
  <xsl:call-template name="say">
    <xsl:with-param name="id">
      <xsl:choose>
        <xsl:when test="$a/from_specified = 'true'">fp.direction.specified</xsl:when>
        <xsl:otherwise>fp.direction.first</xsl:otherwise>
      </xsl:choose>
    </xsl:with-param>
    <xsl:with-param name="a"><xsl:call-template name="compass"><xsl:with-param name="of" select="$a"/></xsl:call-template></xsl:with-param>
    <xsl:with-param name="b" select="count($a/directions/item)"/>
  </xsl:call-template>
  <xsl:for-each select="($a/breakage | $a/overturning)[from/value != $a/from/value]">
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
      <xsl:with-param name="id" select="concat('fp.direction.', name())"/>
      <xsl:with-param name="a"><xsl:call-template name="compass"><xsl:with-param name="of" select="."/></xsl:call-template></xsl:with-param>
    </xsl:call-template>
  </xsl:for-each>
</xsl:template>

<!-- The wind in which the tree is lost from the direction in which it is weakest, and of which direction everything else is. The
     context is that direction. -->
<xsl:template name="front-weakest">
  <xsl:variable name="x" select="(loss/critical_speed | self::*[not(loss)]/critical_stem/speed)/value"/>
  <xsl:variable name="around" select="../.."/>
  <xsl:variable name="off" select="from/value - $around/main_from/value"/>
  <xsl:call-template name="say">
    <xsl:with-param name="id">fp.direction.lost</xsl:with-param>
    <xsl:with-param name="a"><xsl:call-template name="compass"><xsl:with-param name="of" select="."/></xsl:call-template></xsl:with-param>
    <xsl:with-param name="b" select="$around/number"/>
    <xsl:with-param name="c">
      <xsl:for-each select="$around/.."><xsl:call-template name="front-speed">
        <xsl:with-param name="x" select="$x"/></xsl:call-template></xsl:for-each>
    </xsl:with-param>
  </xsl:call-template>
  <xsl:if test="$off &gt; 0.001 or $off &lt; -0.001">
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
      <xsl:with-param name="id">fp.direction.main</xsl:with-param>
      <xsl:with-param name="a" select="format-number($degrees * $around/main_from/value, '0.#')"/>
    </xsl:call-template>
  </xsl:if>
</xsl:template>

<!-- The direction in which the tree is weakest, or which one was computed. -->
<xsl:template name="front-direction">
  <xsl:variable name="all" select="directions/directions/item[(loss | self::*[not(loss)]/critical_stem)/outcome = 'found']"/>
  <xsl:variable name="same"><xsl:call-template name="same-from-all"/></xsl:variable>
  <xsl:choose>
    <xsl:when test="assessment/from/value != ''"><xsl:call-template name="front-assessed"/></xsl:when>
    <xsl:when test="$same = 'yes'">
      <xsl:call-template name="say">
        <xsl:with-param name="id">fp.direction.all</xsl:with-param><xsl:with-param name="a" select="directions/number"/>
      </xsl:call-template>
    </xsl:when>
    <xsl:when test="$all">
      <xsl:for-each select="$all">
        <xsl:sort select="(loss/critical_speed | self::*[not(loss)]/critical_stem/speed)/value" data-type="number"/>
        <xsl:if test="position() = 1">
          <xsl:call-template name="front-weakest"/>
        </xsl:if>
      </xsl:for-each>
    </xsl:when>
    <xsl:when test="directions/directions/item">
      <xsl:call-template name="say">
        <xsl:with-param name="id">
          <xsl:choose>
            <xsl:when test="directions/directions/item[(loss | self::*[not(loss)]/critical_stem)/outcome != 'above']">
              <xsl:text>fp.direction.none</xsl:text></xsl:when>
            <xsl:otherwise>fp.direction.above</xsl:otherwise>
          </xsl:choose>
        </xsl:with-param>
        <xsl:with-param name="a" select="directions/number"/>
        <xsl:with-param name="b"><xsl:call-template name="given">
          <xsl:with-param name="x" select="(verdict | self::*[not(verdict)]/critical_stem)/speed_high/value"/>
        </xsl:call-template></xsl:with-param>
      </xsl:call-template>
    </xsl:when>
    <xsl:when test="assessment/directions/item"> <!-- results of earlier versions -->
      <xsl:for-each select="assessment/directions/item[breakage/value != '' or overturning/value != '']">
        <xsl:sort select="(breakage[not(../overturning/value &lt; value)] | overturning[not(../breakage/value &lt;= value)])/value"
                  data-type="number"/>
        <xsl:if test="position() = 1">
          <xsl:call-template name="say">
            <xsl:with-param name="id">fp.direction.weakest</xsl:with-param>
            <xsl:with-param name="a" select="format-number($degrees * from/value, '0.#')"/>
            <xsl:with-param name="b" select="count(../item)"/>
          </xsl:call-template>
        </xsl:if>
      </xsl:for-each>
    </xsl:when>
    <xsl:when test="assessment">
      <xsl:call-template name="say"><xsl:with-param name="id">fp.direction.same</xsl:with-param></xsl:call-template>
    </xsl:when>
    <xsl:otherwise>
      <xsl:call-template name="say">
        <xsl:with-param name="id">fp.direction.one</xsl:with-param>
        <xsl:with-param name="a" select="format-number($degrees * scenario/azimuth/value, '0')"/>
        <xsl:with-param name="b" select="format-number((630 - $degrees * scenario/azimuth/value) mod 360, '0')"/>
      </xsl:call-template>
    </xsl:otherwise>
  </xsl:choose>
</xsl:template>

<xsl:template name="front-facts">
  <table class="block facts">
    <xsl:call-template name="block-row">
      <xsl:with-param name="id">
        <xsl:text>fp.lost</xsl:text><xsl:if test="not(verdict/criteria/item[criterion = 'overturning'])">.stem</xsl:if>
      </xsl:with-param>
      <xsl:with-param name="text"><xsl:call-template name="front-lost"/></xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="block-row">
      <xsl:with-param name="id">fp.sure</xsl:with-param>
      <xsl:with-param name="text"><xsl:call-template name="front-interval"/></xsl:with-param>
    </xsl:call-template>
    <xsl:if test="assessment">
      <xsl:call-template name="block-row">
        <xsl:with-param name="id">fp.return</xsl:with-param>
        <xsl:with-param name="text"><xsl:call-template name="as-years"/></xsl:with-param>
      </xsl:call-template>
    </xsl:if>
    <xsl:if test="assessment/low != ''">
      <xsl:call-template name="block-row">
        <xsl:with-param name="id">fp.least</xsl:with-param>
        <xsl:with-param name="text">
          <xsl:call-template name="say">
            <xsl:with-param name="id">fp.least.text</xsl:with-param>
            <xsl:with-param name="a"><xsl:call-template name="fixed">
              <xsl:with-param name="x" select="assessment/low"/><xsl:with-param name="pattern">0.00</xsl:with-param>
              <xsl:with-param name="bound" select="assessment/required"/>
            </xsl:call-template></xsl:with-param>
            <xsl:with-param name="b"><xsl:call-template name="fixed">
              <xsl:with-param name="x" select="assessment/high"/><xsl:with-param name="pattern">0.00</xsl:with-param>
              <xsl:with-param name="bound" select="assessment/required"/>
            </xsl:call-template></xsl:with-param>
          </xsl:call-template>
        </xsl:with-param>
      </xsl:call-template>
    </xsl:if>
    <xsl:call-template name="block-row">
      <xsl:with-param name="id">fp.direction</xsl:with-param>
      <xsl:with-param name="text"><xsl:call-template name="front-direction"/></xsl:with-param>
    </xsl:call-template>
  </table>
</xsl:template>

<!-- What nobody looked at in any of the trees of the page, and how much of the input was measured. -->
<xsl:template name="front-missing">
  <div class="lacks">
    <h3><xsl:call-template name="say"><xsl:with-param name="id">fp.lacks</xsl:with-param></xsl:call-template></h3>
    <ul>
      <xsl:for-each select="$trees/verdict/not_assessed/item">
        <xsl:if test="not(../../../preceding-sibling::item/verdict/not_assessed/item[criterion = current()/criterion])"><li>
          <xsl:call-template name="say">
            <xsl:with-param name="id">
              <xsl:choose>
                <xsl:when test="criterion = 'size-effect' or criterion = 'soil'">fp.lacks.</xsl:when>
                <xsl:otherwise>unassessed.</xsl:otherwise>
              </xsl:choose>
              <xsl:value-of select="criterion"/>
            </xsl:with-param>
            <xsl:with-param name="a"><xsl:call-template name="unassessed-why"/></xsl:with-param>
          </xsl:call-template>
        </li></xsl:if>
      </xsl:for-each>
      <xsl:choose>
        <xsl:when test="$trees/assessment">
          <li><xsl:call-template name="say"><xsl:with-param name="id">
            <xsl:choose>
              <xsl:when test="$trees[assessment]/model[judged_to/value != '' or not(judged_to)]">fp.lacks.card</xsl:when>
              <xsl:otherwise>fp.lacks.limbs</xsl:otherwise>
            </xsl:choose>
          </xsl:with-param></xsl:call-template></li>
        </xsl:when>
        <!-- a crown that hangs on a stem without branches -->
        <xsl:when test="$trees/model[levels = 1][leaf_area/value &gt; 0 or frontal_area/value &gt; 0]">
          <li><xsl:call-template name="say"><xsl:with-param name="id">fp.lacks.limbs</xsl:with-param></xsl:call-template></li>
        </xsl:when>
        <xsl:otherwise>
          <li><xsl:call-template name="say"><xsl:with-param name="id">fp.lacks.tree</xsl:with-param></xsl:call-template></li>
        </xsl:otherwise>
      </xsl:choose>
      <li><xsl:call-template name="say"><xsl:with-param name="id">fp.lacks.all</xsl:with-param></xsl:call-template></li>
      <xsl:if test="$trees[1]/scenario and count($trees) &gt; 1 and not($trees/directions)">
        <li><xsl:call-template name="say"><xsl:with-param name="id">fp.lacks.directions</xsl:with-param></xsl:call-template></li>
      </xsl:if>
      <xsl:if test="$trees[not(interval)]">
        <li><xsl:call-template name="say"><xsl:with-param name="id">fp.lacks.interval</xsl:with-param></xsl:call-template></li>
      </xsl:if>
    </ul>
    <p class="care"><xsl:call-template name="care"/></p>
    <xsl:call-template name="care-scan"/>
  </div>
</xsl:template>

<!-- A figure of the report on the first page. -->
<xsl:template name="front-figure">
  <xsl:param name="name"/>
  <xsl:apply-templates select="/report/figures/figure[@name = $name]"/>
</xsl:template>

<xsl:template name="picture">
  <xsl:param name="name"/>
  <xsl:variable name="p" select="/report/picture[@name = $name]"/>
  <xsl:if test="$p">
    <img class="{$name}" src="{$p}">
      <xsl:attribute name="alt">
        <xsl:call-template name="say"><xsl:with-param name="id" select="concat('job.', $name)"/></xsl:call-template>
      </xsl:attribute>
    </img>
  </xsl:if>
</xsl:template>

<!-- Whose report it is. -->
<xsl:template name="job-head">
  <xsl:if test="/report/picture[@name = 'logo'] or $r/job/organisation != ''">
    <p class="from">
      <xsl:call-template name="picture"><xsl:with-param name="name">logo</xsl:with-param></xsl:call-template>
      <xsl:value-of select="$r/job/organisation"/>
    </p>
  </xsl:if>
</xsl:template>

<xsl:template name="job-block">
  <xsl:if test="$r/job[client != '' or site != '' or tree_number != '']">
    <p class="job">
      <xsl:for-each select="$r/job/*[name() = 'client' or name() = 'site' or name() = 'tree_number'][. != '']">
        <span>
          <i><xsl:call-template name="say"><xsl:with-param name="id" select="concat('job.', name())"/></xsl:call-template></i>
          <xsl:text> </xsl:text><xsl:value-of select="."/>
        </span>
        <xsl:text> </xsl:text>
      </xsl:for-each>
    </p>
  </xsl:if>
</xsl:template>

<xsl:template name="signature">
  <xsl:if test="$r/job/disclaimer != ''"><p class="note"><xsl:value-of select="$r/job/disclaimer"/></p></xsl:if>
  <table class="sign">
    <xsl:if test="$r/job/assessor != ''">
      <tr class="who"><td colspan="5"><xsl:value-of select="$r/job/assessor"/></td></tr>
    </xsl:if>
    <tr>
      <td>
        <xsl:call-template name="say"><xsl:with-param name="id">fp.sign.name</xsl:with-param></xsl:call-template></td><td class="gap"/>
      <td>
        <xsl:call-template name="say"><xsl:with-param name="id">fp.sign.date</xsl:with-param></xsl:call-template></td><td class="gap"/>
      <td><xsl:call-template name="say"><xsl:with-param name="id">fp.sign.hand</xsl:with-param></xsl:call-template></td>
    </tr>
  </table>
</xsl:template>

<!-- The headline of a tree: the word of an assessment, or how it stands in the strongest wind, and that nobody looked at its
     roots. -->
<xsl:template name="headline">
  <xsl:variable name="small"><xsl:call-template name="small"/></xsl:variable>
  <xsl:choose>
    <xsl:when test="method/solver/as_printed = 'true'">
      <xsl:call-template name="say">
        <xsl:with-param name="id">sum.printed</xsl:with-param>
        <xsl:with-param name="a"><xsl:call-template name="name"/></xsl:with-param>
      </xsl:call-template>
    </xsl:when>
    <xsl:when test="$small != ''"><xsl:value-of select="$small"/></xsl:when>
    <xsl:when test="assessment">
      <xsl:call-template name="say"><xsl:with-param name="id" select="concat('as.word.', assessment/word)"/></xsl:call-template>
    </xsl:when>
    <xsl:otherwise>
      <xsl:call-template name="verdict"/>
      <xsl:if test="not(verdict/criteria/item[criterion = 'overturning'])">
        <xsl:value-of select="$gap"/>
        <xsl:call-template name="say"><xsl:with-param name="id">fp.roots</xsl:with-param></xsl:call-template>
      </xsl:if>
    </xsl:otherwise>
  </xsl:choose>
</xsl:template>

<!-- How grave the headline is, for the colour of its box. -->
<xsl:template name="grade">
  <xsl:variable name="safety" select="verdict/safety/value"/>
  <xsl:choose>
    <xsl:when test="assessment/word = 'lost' or assessment/word = 'insufficient'">bad</xsl:when>
    <xsl:when test="assessment/word = 'sufficient'">good</xsl:when>
    <xsl:when test="assessment">open</xsl:when>
    <xsl:when test="$safety != '' and $safety &lt;= 1">bad</xsl:when>
    <xsl:otherwise>open</xsl:otherwise>
  </xsl:choose>
</xsl:template>

<xsl:template name="front-one">
  <xsl:variable name="grade"><xsl:call-template name="grade"/></xsl:variable>
  <xsl:variable name="u"><xsl:call-template name="front-wind"/></xsl:variable>
  <div class="verdict {$grade}">
    <p class="word"><xsl:call-template name="headline"/></p>
    <p>
      <xsl:call-template name="say">
        <xsl:with-param name="id"><xsl:text>fp.in</xsl:text><xsl:if test="scenario/design != ''">.design</xsl:if>
          <xsl:if test="scenario/design != '' and scenario/wind_terrain = scenario/terrain">.same</xsl:if></xsl:with-param>
        <xsl:with-param name="a">
          <xsl:call-template name="given"><xsl:with-param name="x" select="$u"/></xsl:call-template></xsl:with-param>
        <xsl:with-param name="b">
          <xsl:call-template name="gust"><xsl:with-param name="x" select="$u"/></xsl:call-template></xsl:with-param>
        <xsl:with-param name="c"><xsl:call-template name="given">
          <xsl:with-param name="x" select="scenario/wind_height/value"/></xsl:call-template></xsl:with-param>
        <xsl:with-param name="d" select="scenario/wind_terrain"/><xsl:with-param name="e" select="scenario/design"/>
        <xsl:with-param name="f" select="scenario/terrain"/>
      </xsl:call-template>
      <xsl:call-template name="front-load"/>
      <xsl:for-each select="assessment/because/item">
        <xsl:value-of select="$gap"/>
        <xsl:call-template name="say">
          <xsl:with-param name="id">
            <xsl:value-of select="concat('as.because.', reason)"/>
            <xsl:if test="reason = 'saturated-soil' and ../../saturated_high &lt; 1">.sure</xsl:if>
          </xsl:with-param>
        </xsl:call-template>
      </xsl:for-each>
    </p>
    <xsl:call-template name="front-safeties"/>
    <xsl:call-template name="front-facts"/>
  </div>
  <!-- much is said above: the figure is smaller, so that the page holds the signature -->
  <xsl:variable name="much" select="count(assessment/because/item) + 2 * boolean(assessment/directions/item) +
    count(scenario/snow[value &gt; 0] | scenario/ice[value &gt; 0] | wetted | scenario/winter_wind[value &lt; 1]) +
    boolean(assessment/return_period_by != '')"/>
  <div class="cols{substring(' tight', 1, 6 * ($much &gt; 5))}">
    <div class="col">
      <xsl:call-template name="front-missing"/>
      <xsl:call-template name="picture"><xsl:with-param name="name">photo</xsl:with-param></xsl:call-template>
    </div>
    <div class="col picture">
      <xsl:call-template name="front-figure"><xsl:with-param name="name">front</xsl:with-param></xsl:call-template></div>
  </div>
</xsl:template>

<!-- A row of the ranking; the context is a tree. -->
<xsl:template name="rank-row">
  <xsl:param name="rank"/>
  <xsl:variable name="valid" select="not(method/solver/as_printed = 'true') and not(verdict/within_limits = 'false')"/>
  <tr>
    <td class="r"><xsl:value-of select="$rank"/></td>
    <td><b><xsl:call-template name="name"/></b></td>
    <td class="r">
      <xsl:choose>
        <xsl:when test="$valid and verdict/criteria/item">
          <xsl:call-template name="wind-of"><xsl:with-param name="of" select="verdict"/></xsl:call-template>
        </xsl:when>
        <xsl:otherwise>–</xsl:otherwise>
      </xsl:choose>
    </td>
    <td class="r">
      <xsl:choose>
        <xsl:when test="$valid and verdict/criteria/item">
          <xsl:call-template name="wind-of">
            <xsl:with-param name="of" select="verdict"/><xsl:with-param name="gust" select="1"/></xsl:call-template>
        </xsl:when>
        <xsl:otherwise>–</xsl:otherwise>
      </xsl:choose>
    </td>
    <td class="r">
      <xsl:choose>
        <xsl:when test="interval">
          <xsl:for-each select="interval">
            <xsl:call-template name="iv-range">
              <xsl:with-param name="low" select="low_m_s"/><xsl:with-param name="high" select="high_m_s"/>
              <xsl:with-param name="id">fp.range</xsl:with-param>
            </xsl:call-template>
          </xsl:for-each>
        </xsl:when>
        <xsl:otherwise>–</xsl:otherwise>
      </xsl:choose>
    </td>
    <td class="r">
      <xsl:call-template name="fixed">
        <xsl:with-param name="x" select="verdict/safety/value"/><xsl:with-param name="pattern">0.00</xsl:with-param>
      </xsl:call-template>
    </td>
    <td>
      <xsl:choose>
        <xsl:when test="method/solver/as_printed = 'true'">
          <xsl:call-template name="say"><xsl:with-param name="id">fp.printed</xsl:with-param></xsl:call-template>
        </xsl:when>
        <xsl:when test="not(verdict/criteria/item)">
          <xsl:call-template name="say"><xsl:with-param name="id">fp.unknown</xsl:with-param></xsl:call-template>
        </xsl:when>
        <xsl:when test="not($valid)">
          <xsl:call-template name="say"><xsl:with-param name="id">outcome.void</xsl:with-param></xsl:call-template>
        </xsl:when>
        <xsl:otherwise>
          <xsl:call-template name="front-outcome"/>
          <xsl:for-each select="verdict[criterion = 'overturning']/criteria/item[loses_tree = 'true' and outcome = 'found' and
            within_limits = 'true' and criterion != 'overturning']">
            <xsl:sort select="critical_speed/value" data-type="number"/>
            <xsl:if test="position() = 1">
              <xsl:call-template name="say">
                <xsl:with-param name="id">fp.stem-too</xsl:with-param>
                <xsl:with-param name="a" select="format-number(critical_speed/value, '0.0')"/>
              </xsl:call-template>
            </xsl:if>
          </xsl:for-each>
        </xsl:otherwise>
      </xsl:choose>
      <xsl:if test="verdict/not_assessed/item[criterion = 'overturning']">
        <xsl:call-template name="say"><xsl:with-param name="id">fp.no-root</xsl:with-param></xsl:call-template>
      </xsl:if>
    </td>
  </tr>
</xsl:template>

<xsl:template name="front-more">
  <xsl:variable name="void">
    <xsl:for-each select="$trees">
      <xsl:if test="method/solver/as_printed = 'true'">x</xsl:if><xsl:call-template name="small"/></xsl:for-each>
  </xsl:variable>
  <xsl:variable name="known" select="$trees[verdict/outcome = 'found' and verdict/within_limits = 'true' and
    not(method/solver/as_printed = 'true')]"/>
  <xsl:variable name="u"><xsl:for-each select="$trees[1]"><xsl:call-template name="front-wind"/></xsl:for-each></xsl:variable>
  <xsl:if test="$void = ''"><p class="first"><b><xsl:call-template name="compare"/></b></p></xsl:if>
  <table class="data rank">
    <xsl:call-template name="caption">
      <xsl:with-param name="id">fp.t.rank</xsl:with-param>
      <xsl:with-param name="a"><xsl:call-template name="given">
        <xsl:with-param name="x" select="$trees[1]/scenario/wind_height/value"/></xsl:call-template></xsl:with-param>
      <xsl:with-param name="b" select="$trees[1]/scenario/wind_terrain"/>
      <xsl:with-param name="c">
        <xsl:call-template name="given"><xsl:with-param name="x" select="$u"/></xsl:call-template></xsl:with-param>
    </xsl:call-template>
    <thead><tr><xsl:call-template name="heads">
      <xsl:with-param name="of">fp.c.rank:;c.tree;fp.c.mean:m/s;c.gust:m/s;fp.c.interval:m/s;fp.c.safety.loss:;fp.c.words</xsl:with-param>
    </xsl:call-template></tr></thead>
    <tbody class="long">
      <xsl:for-each select="$known">
        <xsl:sort select="verdict/critical_speed/value" data-type="number"/>
        <xsl:call-template name="rank-row"><xsl:with-param name="rank" select="position()"/></xsl:call-template>
      </xsl:for-each>
      <xsl:for-each select="$trees[not(verdict/outcome = 'found' and verdict/within_limits = 'true' and
        not(method/solver/as_printed = 'true'))]">
        <xsl:call-template name="rank-row"><xsl:with-param name="rank">–</xsl:with-param></xsl:call-template>
      </xsl:for-each>
    </tbody>
  </table>
  <xsl:call-template name="front-missing"/>
  <xsl:call-template name="picture"><xsl:with-param name="name">photo</xsl:with-param></xsl:call-template>
  <xsl:call-template name="front-figure"><xsl:with-param name="name">shapes</xsl:with-param></xsl:call-template>
</xsl:template>

<!-- The tree at the wind of a slider, for the screen alone; hidden until its script runs. -->
<xsl:template name="live">
  <section id="live" class="live" hidden="hidden">
    <h3><xsl:call-template name="say"><xsl:with-param name="id">lv.head</xsl:with-param></xsl:call-template></h3>
    <p class="controls">
      <label><xsl:call-template name="say"><xsl:with-param name="id">c.tree</xsl:with-param></xsl:call-template>
        <xsl:text> </xsl:text><select>
        <xsl:for-each select="$trees[position() &lt;= 64]">
          <option value="{position() - 1}"><xsl:call-template name="name"/></option>
        </xsl:for-each>
      </select></label>
      <label><xsl:call-template name="say"><xsl:with-param name="id">lv.wind</xsl:with-param></xsl:call-template>
        <xsl:text> </xsl:text><input type="range" min="0" step="1" value="0"/></label>
      <button type="button" class="switch">
        <xsl:call-template name="say"><xsl:with-param name="id">lv.switch</xsl:with-param></xsl:call-template></button>
      <xsl:text> </xsl:text>
      <xsl:call-template name="live-play"/>
    </p>
    <div class="cols">
      <div class="col stage"></div>
      <div class="col picture">
        <table class="block" aria-live="polite">
          <xsl:call-template name="live-row"><xsl:with-param name="key">speed</xsl:with-param>
            <xsl:with-param name="unit">m/s</xsl:with-param></xsl:call-template>
          <xsl:call-template name="live-row"><xsl:with-param name="key">gust</xsl:with-param>
            <xsl:with-param name="unit">m/s</xsl:with-param></xsl:call-template>
          <xsl:call-template name="live-row"><xsl:with-param name="key">tip</xsl:with-param>
            <xsl:with-param name="unit">m</xsl:with-param></xsl:call-template>
          <xsl:call-template name="live-row"><xsl:with-param name="key">top</xsl:with-param>
            <xsl:with-param name="unit">m</xsl:with-param></xsl:call-template>
          <xsl:call-template name="live-row"><xsl:with-param name="key">moment</xsl:with-param>
            <xsl:with-param name="unit">kN m</xsl:with-param></xsl:call-template>
          <xsl:call-template name="live-row"><xsl:with-param name="key">breakage</xsl:with-param></xsl:call-template>
          <xsl:call-template name="live-row"><xsl:with-param name="key">safety</xsl:with-param></xsl:call-template>
        </table>
        <p class="care beyond" hidden="hidden">
          <xsl:call-template name="say"><xsl:with-param name="id">lv.beyond</xsl:with-param></xsl:call-template>
        </p>
        <p class="note"><xsl:call-template name="say"><xsl:with-param name="id">lv.note</xsl:with-param></xsl:call-template></p>
        <p class="note at">
          <xsl:attribute name="data-words">
            <xsl:call-template name="say"><xsl:with-param name="id">lv.at</xsl:with-param></xsl:call-template>
          </xsl:attribute>&#160;</p>
      </div>
    </div>
    <div class="around" hidden="hidden">
      <h3><xsl:call-template name="say"><xsl:with-param name="id">lv.around</xsl:with-param></xsl:call-template></h3>
      <p class="controls">
        <label><xsl:call-template name="say"><xsl:with-param name="id">lv.from</xsl:with-param></xsl:call-template>
          <xsl:text> </xsl:text><input type="range" class="azimuth" min="0" step="1" value="0"/></label>
      </p>
      <div class="cols">
        <div class="col rose"><xsl:attribute name="data-north">
          <xsl:call-template name="say"><xsl:with-param name="id">lv.north</xsl:with-param></xsl:call-template>
        </xsl:attribute></div>
        <div class="col picture">
          <table class="block" aria-live="polite">
            <xsl:call-template name="live-row"><xsl:with-param name="key">a-from</xsl:with-param>
              <xsl:with-param name="unit">°</xsl:with-param></xsl:call-template>
            <xsl:call-template name="live-row"><xsl:with-param name="key">a-lost</xsl:with-param>
              <xsl:with-param name="unit">m/s</xsl:with-param></xsl:call-template>
            <xsl:call-template name="live-row"><xsl:with-param name="key">a-moment</xsl:with-param>
              <xsl:with-param name="unit">kN m</xsl:with-param></xsl:call-template>
            <xsl:call-template name="live-row"><xsl:with-param name="key">a-safety</xsl:with-param></xsl:call-template>
          </table>
          <p class="note"><xsl:call-template name="say"><xsl:with-param name="id">lv.rose</xsl:with-param></xsl:call-template></p>
        </div>
      </div>
    </div>
  </section>
</xsl:template>

<!-- Figures that stand on the first page. -->
<xsl:variable name="in-front">
  <xsl:choose><xsl:when test="count($trees) = 1">front</xsl:when><xsl:otherwise>shapes</xsl:otherwise></xsl:choose>
</xsl:variable>

<xsl:template name="front">
  <section class="front">
    <xsl:choose>
      <xsl:when test="count($trees) = 1">
        <xsl:for-each select="$trees"><xsl:call-template name="front-one"/></xsl:for-each></xsl:when>
      <xsl:otherwise><xsl:call-template name="front-more"/></xsl:otherwise>
    </xsl:choose>
    <xsl:call-template name="signature"/>
  </section>
</xsl:template>
</xsl:stylesheet>
