<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- Winds from all around: what each direction does, and how often a climate brings the critical wind. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform">

<!-- Hours a year; what is more than none but rounds to none says so. -->
<xsl:template name="hours">
  <xsl:param name="x"/>
  <td class="r">
    <xsl:choose>
      <xsl:when test="$x &gt; 0 and $x &lt; 0.001">&lt; 0.001</xsl:when>
      <xsl:otherwise>
        <xsl:call-template name="steady">
          <xsl:with-param name="x" select="$x"/><xsl:with-param name="pattern">#,##0.0</xsl:with-param>
        </xsl:call-template>
      </xsl:otherwise>
    </xsl:choose>
  </td>
</xsl:template>

<xsl:template name="direction-row">
  <xsl:param name="climate"/>
  <tr>
    <xsl:if test="critical/within_limits = 'false' or winds/item[last()]/within_limits = 'false'">
      <xsl:attribute name="class">void</xsl:attribute>
    </xsl:if>
    <td class="r">
      <xsl:call-template name="fixed">
        <xsl:with-param name="x" select="$degrees * from/value"/><xsl:with-param name="pattern">0.#</xsl:with-param>
      </xsl:call-template>
    </td>
    <td class="r">
      <xsl:call-template name="number">
        <xsl:with-param name="x" select="winds/item[last()]/base_moment/value div 1000"/>
      </xsl:call-template>
    </td>
    <td class="r">
      <xsl:call-template name="number">
        <xsl:with-param name="x" select="winds/item[last()]/gust_load_factor/value"/>
      </xsl:call-template>
    </td>
    <xsl:call-template name="steady-cell">
      <xsl:with-param name="x" select="winds/item[last()]/tip_deflection/value"/>
      <xsl:with-param name="pattern"><xsl:choose>
        <xsl:when test="winds/item[last()]/tip_deflection/value &gt;= 10">0.0</xsl:when><xsl:otherwise>0.00</xsl:otherwise>
      </xsl:choose></xsl:with-param>
    </xsl:call-template>
    <!-- 0: without wind -->
    <xsl:variable name="lost"><xsl:choose>
      <xsl:when test="(loss | self::*[not(loss)]/critical_stem)/outcome = 'self-weight'">0</xsl:when>
      <xsl:otherwise><xsl:value-of select="(loss/critical_speed | self::*[not(loss)]/critical_stem/speed)/value"/></xsl:otherwise>
    </xsl:choose></xsl:variable>
    <xsl:variable name="part"><xsl:choose>
      <xsl:when test="critical/outcome = 'self-weight'">0</xsl:when>
      <xsl:otherwise><xsl:value-of select="critical/speed/value"/></xsl:otherwise>
    </xsl:choose></xsl:variable>
    <td class="r">
      <xsl:call-template name="number">
        <xsl:with-param name="x" select="winds/item[last()]/loss_safety/value"/>
      </xsl:call-template>
    </td>
    <xsl:call-template name="cell"><xsl:with-param name="x" select="$lost"/></xsl:call-template>
    <td class="r"><xsl:call-template name="gust"><xsl:with-param name="x" select="$lost"/></xsl:call-template></td>
    <td><xsl:for-each select="loss[outcome = 'found' or outcome = 'self-weight']">
      <xsl:call-template name="criterion-name"/>
    </xsl:for-each></td>
    <td class="r">
      <xsl:call-template name="number">
        <xsl:with-param name="x" select="winds/item[last()]/least_safety/value"/>
      </xsl:call-template>
    </td>
    <xsl:call-template name="cell"><xsl:with-param name="x" select="$part"/></xsl:call-template>
    <xsl:call-template name="cell">
      <xsl:with-param name="x" select="critical/governing_section/height/value"/>
    </xsl:call-template>
    <xsl:if test="$trees[1]/scenario/ground_file != ''">
      <xsl:call-template name="cell">
        <xsl:with-param name="x" select="speed_up/value"/><xsl:with-param name="pattern">0.00</xsl:with-param>
      </xsl:call-template>
    </xsl:if>
    <xsl:if test="$climate">
      <xsl:call-template name="hours"><xsl:with-param name="x" select="hours_a_year/value"/></xsl:call-template>
      <xsl:call-template name="hours"><xsl:with-param name="x" select="hours_a_year_10_min/value"/></xsl:call-template>
    </xsl:if>
  </tr>
</xsl:template>

<xsl:template name="direction-table">
  <xsl:param name="n"/>
  <xsl:variable name="around" select="$trees[1]/directions"/>
  <xsl:variable name="climate" select="$around/climate_file != ''"/>
  <xsl:variable name="ground" select="$trees[1]/scenario/ground_file != ''"/>
  <table class="data">
    <xsl:call-template name="table-caption">
      <xsl:with-param name="n" select="$n"/>
      <xsl:with-param name="text">
        <xsl:call-template name="say">
          <xsl:with-param name="id">
            <xsl:choose>
              <xsl:when test="$around/north/value = 0">t.around</xsl:when><xsl:otherwise>t.around.north</xsl:otherwise>
            </xsl:choose>
          </xsl:with-param>
          <xsl:with-param name="a">
            <xsl:call-template name="given">
              <xsl:with-param name="x" select="$trees[1]/winds/item[last()]/speed/value"/>
            </xsl:call-template>
          </xsl:with-param>
          <xsl:with-param name="b">
            <xsl:call-template name="fixed">
              <xsl:with-param name="x" select="$degrees * $around/north/value"/>
              <xsl:with-param name="pattern">0.#</xsl:with-param>
            </xsl:call-template>
          </xsl:with-param>
        </xsl:call-template>
        <xsl:value-of select="$gap"/>
        <xsl:call-template name="say">
          <xsl:with-param name="id">t.around.main</xsl:with-param>
          <xsl:with-param name="a">
            <xsl:call-template name="fixed">
              <xsl:with-param name="x" select="$degrees * $around/main_from/value"/>
              <xsl:with-param name="pattern">0.#</xsl:with-param>
            </xsl:call-template>
          </xsl:with-param>
        </xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
    <thead>
      <tr>
        <xsl:call-template name="head">
          <xsl:with-param name="id">c.from</xsl:with-param><xsl:with-param name="unit">°</xsl:with-param>
        </xsl:call-template>
        <xsl:call-template name="head">
          <xsl:with-param name="id">c.moment</xsl:with-param><xsl:with-param name="unit">kN m</xsl:with-param>
        </xsl:call-template>
        <xsl:call-template name="head">
          <xsl:with-param name="id">c.gusts</xsl:with-param><xsl:with-param name="unit">–</xsl:with-param>
        </xsl:call-template>
        <xsl:call-template name="head">
          <xsl:with-param name="id">c.deflection</xsl:with-param><xsl:with-param name="unit">m</xsl:with-param>
        </xsl:call-template>
        <xsl:call-template name="heads">
          <xsl:with-param name="of">c.safety.tree:–;c.lost:m/s;c.gust:m/s;c.by;c.safety:–;c.part:m/s;c.height:m</xsl:with-param>
        </xsl:call-template>
        <xsl:if test="$ground">
          <xsl:call-template name="head">
            <xsl:with-param name="id">c.exposure</xsl:with-param><xsl:with-param name="unit">–</xsl:with-param>
          </xsl:call-template>
        </xsl:if>
        <xsl:if test="$climate">
          <xsl:call-template name="head">
            <xsl:with-param name="id">c.hours</xsl:with-param><xsl:with-param name="unit">h/a</xsl:with-param>
          </xsl:call-template>
          <xsl:call-template name="head">
            <xsl:with-param name="id">c.hours.10</xsl:with-param><xsl:with-param name="unit">h/a</xsl:with-param>
          </xsl:call-template>
        </xsl:if>
      </tr>
    </thead>
    <xsl:for-each select="$trees">
      <tbody class="long">
        <xsl:if test="count($trees) &gt; 1"><tr><td colspan="14"><b><xsl:call-template name="name"/></b></td></tr></xsl:if>
        <xsl:for-each select="directions/directions/item">
          <xsl:call-template name="direction-row"><xsl:with-param name="climate" select="$climate"/></xsl:call-template>
        </xsl:for-each>
        <xsl:if test="$climate">
          <tr>
            <td colspan="{11 + number($ground)}">
              <xsl:call-template name="say"><xsl:with-param name="id">t.around.all</xsl:with-param></xsl:call-template>
            </td>
            <xsl:call-template name="hours">
              <xsl:with-param name="x" select="directions/hours_a_year/value"/>
            </xsl:call-template>
            <xsl:call-template name="hours">
              <xsl:with-param name="x" select="directions/hours_a_year_10_min/value"/>
            </xsl:call-template>
          </tr>
        </xsl:if>
      </tbody>
    </xsl:for-each>
  </table>
  <xsl:if test="$climate">
    <p class="note">
      <xsl:call-template name="say">
        <xsl:with-param name="id">t.around.climate</xsl:with-param>
        <xsl:with-param name="a"><xsl:value-of select="$reference"/></xsl:with-param>
        <xsl:with-param name="b">
          <xsl:call-template name="fixed">
            <xsl:with-param name="x" select="$around/strongest_10_min_over_hourly/value"/>
            <xsl:with-param name="pattern">0.000</xsl:with-param>
          </xsl:call-template>
        </xsl:with-param>
        <xsl:with-param name="c" select="$around/averaging_law"/>
        <xsl:with-param name="d">
          <xsl:call-template name="base-name"><xsl:with-param name="path" select="$around/climate_file"/></xsl:call-template>
        </xsl:with-param>
      </xsl:call-template>
      <xsl:if test="$trees/directions/searched_to_the_end = 'true'">
        <xsl:value-of select="$gap"/>
        <xsl:call-template name="say">
          <xsl:with-param name="id">t.around.above</xsl:with-param>
          <xsl:with-param name="a">
            <xsl:call-template name="given"><xsl:with-param name="x" select="$around/searched_to/value"/></xsl:call-template>
          </xsl:with-param>
        </xsl:call-template>
      </xsl:if>
    </p>
  </xsl:if>
</xsl:template>
</xsl:stylesheet>
