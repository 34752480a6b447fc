<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- The key tables: totals of every tree at every wind speed; the critical wind speeds. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform">

<!-- Is the load that of gusts, and not of the mean wind alone? -->
<xsl:variable name="gusts" select="$trees/method/peak_method[name != 'mean']"/>

<!-- Does the crown of a tree reach above its stem? -->
<xsl:variable name="tops" select="$trees/top[level &gt; 0]"/>

<!-- Cells of one tree at one wind speed: those of its state in the mean wind, then those at the peak of the load. A
     quantity without a value gives a dash, a speed without answer says so. -->
<xsl:template name="result-cells">
  <xsl:choose>
    <xsl:when test="status = 'ok'">
      <td class="r">
        <xsl:call-template name="number"><xsl:with-param name="x" select="(mean_state/tip_deflection |
          self::*[not(mean_state)]/tip_deflection)/value"/></xsl:call-template>
      </td>
      <xsl:if test="$tops">
        <td class="r">
          <xsl:call-template name="number"><xsl:with-param name="x" select="(mean_state/top_deflection |
            self::*[not(mean_state)]/top_deflection)/value"/></xsl:call-template>
        </td>
      </xsl:if>
      <xsl:call-template name="steady-cell">
        <xsl:with-param name="x" select="100 * (mean_state/tip_deflection_share | self::*[not(mean_state)]/tip_deflection_share)/value"/>
      </xsl:call-template>
      <xsl:call-template name="steady-cell"><xsl:with-param name="x" select="$degrees * (mean_state/tip_angle |
        self::*[not(mean_state)]/tip_angle)/value"/></xsl:call-template>
      <xsl:if test="not($gusts)">
        <td class="r"><xsl:call-template name="number"><xsl:with-param name="x" select="drag/value"/></xsl:call-template></td>
      </xsl:if>
      <td class="r">
        <xsl:call-template name="number"><xsl:with-param name="x" select="(mean_state/base_moment |
          self::*[not(mean_state)]/base_moment)/value div 1000"/></xsl:call-template>
      </td>
      <xsl:if test="$gusts">
        <td class="r">
          <xsl:call-template name="fixed">
            <xsl:with-param name="x" select="peak/load_factor_gusts/value"/><xsl:with-param name="pattern">0.00</xsl:with-param>
          </xsl:call-template>
        </td>
        <td class="r">
          <xsl:call-template name="number"><xsl:with-param name="x" select="base_moment/value div 1000"/></xsl:call-template>
        </td>
      </xsl:if>
      <xsl:call-template name="steady-cell"><xsl:with-param name="x" select="largest_stress/value div 1e6"/></xsl:call-template>
      <td class="r">
        <xsl:call-template name="number"><xsl:with-param name="x" select="least_safety/value"/></xsl:call-template>
      </td>
      <xsl:call-template name="cell"><xsl:with-param name="x" select="governing_section/height/value"/></xsl:call-template>
      <td class="r">
        <xsl:call-template name="number"><xsl:with-param name="x" select="loss_safety/value"/></xsl:call-template>
      </td>
    </xsl:when>
    <xsl:otherwise>
      <td class="weak">
        <xsl:attribute name="colspan"><xsl:value-of select="9 + boolean($gusts) + boolean($tops)"/></xsl:attribute>
        <xsl:call-template name="say">
          <xsl:with-param name="id">no-answer</xsl:with-param>
          <xsl:with-param name="a">
            <xsl:call-template name="say"><xsl:with-param name="id" select="concat('status.', status)"/></xsl:call-template>
          </xsl:with-param>
        </xsl:call-template>
      </td>
    </xsl:otherwise>
  </xsl:choose>
</xsl:template>

<!-- One block a wind speed, so that species stand under one another; a single tree gives one running block. -->
<xsl:template name="result-tables">
  <table class="data">
    <xsl:call-template name="table-caption">
      <xsl:with-param name="n" select="1"/>
      <xsl:with-param name="text">
        <xsl:call-template name="say">
          <xsl:with-param name="id">
            <xsl:text>t.results</xsl:text><xsl:if test="$gusts">.gusts</xsl:if>
          </xsl:with-param>
        </xsl:call-template>
        <xsl:if test="$tops">
          <xsl:value-of select="$gap"/>
          <xsl:call-template name="say"><xsl:with-param name="id">t.tops</xsl:with-param></xsl:call-template>
        </xsl:if>
        <xsl:if test="$trees/model/key = 'card'">
          <xsl:value-of select="$gap"/>
          <xsl:call-template name="say"><xsl:with-param name="id">t.crown.stem</xsl:with-param></xsl:call-template>
        </xsl:if>
        <xsl:if test="$trees/winds/item/within_limits = 'false'">
          <xsl:value-of select="$gap"/>
          <xsl:call-template name="say"><xsl:with-param name="id">t.void</xsl:with-param></xsl:call-template>
        </xsl:if>
        <xsl:if test="$trees/winds/item[beyond_loss = 'true' or (not(beyond_loss) and status = 'ok' and least_safety/value &lt;= 1)]">
          <xsl:value-of select="$gap"/>
          <xsl:call-template name="say"><xsl:with-param name="id">t.broken</xsl:with-param></xsl:call-template>
        </xsl:if>
      </xsl:with-param>
    </xsl:call-template>
    <thead>
      <tr>
        <xsl:call-template name="head">
          <xsl:with-param name="id">c.wind</xsl:with-param><xsl:with-param name="unit">m/s</xsl:with-param>
        </xsl:call-template>
        <xsl:if test="count($trees) &gt; 1">
          <xsl:call-template name="head">
            <xsl:with-param name="id">c.tree</xsl:with-param><xsl:with-param name="class"/>
          </xsl:call-template>
        </xsl:if>
        <xsl:call-template name="head">
          <xsl:with-param name="id">c.deflection</xsl:with-param><xsl:with-param name="unit">m</xsl:with-param>
        </xsl:call-template>
        <xsl:if test="$tops">
          <xsl:call-template name="head">
            <xsl:with-param name="id">c.top</xsl:with-param><xsl:with-param name="unit">m</xsl:with-param>
          </xsl:call-template>
        </xsl:if>
        <xsl:call-template name="head">
          <xsl:with-param name="id">c.share</xsl:with-param><xsl:with-param name="unit">%</xsl:with-param>
        </xsl:call-template>
        <xsl:call-template name="head">
          <xsl:with-param name="id">c.angle</xsl:with-param><xsl:with-param name="unit">°</xsl:with-param>
        </xsl:call-template>
        <xsl:if test="not($gusts)">
          <xsl:call-template name="head">
            <xsl:with-param name="id">c.drag</xsl:with-param><xsl:with-param name="unit">N</xsl:with-param>
          </xsl:call-template>
        </xsl:if>
        <xsl:call-template name="head">
          <xsl:with-param name="id">c.moment</xsl:with-param><xsl:with-param name="unit">kN m</xsl:with-param>
        </xsl:call-template>
        <xsl:if test="$gusts">
          <xsl:call-template name="head">
            <xsl:with-param name="id">c.gusts</xsl:with-param><xsl:with-param name="unit">–</xsl:with-param>
          </xsl:call-template>
          <xsl:call-template name="head">
            <xsl:with-param name="id">c.moment.peak</xsl:with-param><xsl:with-param name="unit">kN m</xsl:with-param>
          </xsl:call-template>
        </xsl:if>
        <xsl:call-template name="head">
          <xsl:with-param name="id">c.stress</xsl:with-param><xsl:with-param name="unit">MPa</xsl:with-param>
        </xsl:call-template>
        <xsl:call-template name="head">
          <xsl:with-param name="id">c.safety</xsl:with-param><xsl:with-param name="unit">–</xsl:with-param>
        </xsl:call-template>
        <xsl:call-template name="head">
          <xsl:with-param name="id">c.height</xsl:with-param><xsl:with-param name="unit">m</xsl:with-param>
        </xsl:call-template>
        <xsl:call-template name="head">
          <xsl:with-param name="id">c.safety.tree</xsl:with-param><xsl:with-param name="unit">–</xsl:with-param>
        </xsl:call-template>
      </tr>
    </thead>
    <xsl:choose>
      <xsl:when test="count($trees) = 1">
        <tbody class="long">
          <xsl:for-each select="$trees/winds/item">
            <tr>
              <xsl:if test="within_limits = 'false' or beyond_loss = 'true' or (not(beyond_loss) and status = 'ok' and
                least_safety/value &lt;= 1)">
                <xsl:attribute name="class">void</xsl:attribute>
              </xsl:if>
              <td class="r">
                <xsl:call-template name="given"><xsl:with-param name="x" select="speed/value"/></xsl:call-template>
              </td>
              <xsl:call-template name="result-cells"/>
            </tr>
          </xsl:for-each>
        </tbody>
      </xsl:when>
      <xsl:otherwise>
        <xsl:for-each select="$trees[1]/winds/item">
          <xsl:variable name="p" select="position()"/>
          <tbody>
            <xsl:for-each select="$trees">
              <tr>
                <xsl:if test="winds/item[$p][within_limits = 'false' or beyond_loss = 'true' or (not(beyond_loss) and status = 'ok' and
                  least_safety/value &lt;= 1)]">
                  <xsl:attribute name="class">void</xsl:attribute>
                </xsl:if>
                <td class="r">
                  <xsl:if test="position() = 1">
                    <xsl:call-template name="given">
                      <xsl:with-param name="x" select="winds/item[$p]/speed/value"/>
                    </xsl:call-template>
                  </xsl:if>
                </td>
                <td><xsl:call-template name="name"/></td>
                <xsl:for-each select="winds/item[$p]"><xsl:call-template name="result-cells"/></xsl:for-each>
              </tr>
            </xsl:for-each>
          </tbody>
        </xsl:for-each>
      </xsl:otherwise>
    </xsl:choose>
  </table>
  <table>
    <xsl:attribute name="class">data losses<xsl:if test="count($trees) = 1"> whole</xsl:if></xsl:attribute>
    <xsl:call-template name="table-caption">
      <xsl:with-param name="n" select="2"/>
      <xsl:with-param name="text">
        <xsl:call-template name="say"><xsl:with-param name="id">t.critical</xsl:with-param></xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
    <thead><tr><xsl:call-template name="heads">
      <xsl:with-param name="of">c.tree;c.criterion;c.outcome;c.critical:m/s;c.gust:m/s;c.height:m;c.evidence:m/s</xsl:with-param>
    </xsl:call-template></tr></thead>
    <xsl:for-each select="$trees">
      <tbody>
        <xsl:choose>
          <xsl:when test="verdict/criteria/item"><xsl:call-template name="loss-rows"/></xsl:when>
          <xsl:otherwise>
            <xsl:call-template name="breaks"><xsl:with-param name="at" select="critical_stem"/></xsl:call-template>
          </xsl:otherwise>
        </xsl:choose>
        <xsl:call-template name="unassessed-rows"/>
        <xsl:if test="critical/governing_section/level &gt; 0">
          <xsl:call-template name="breaks"><xsl:with-param name="at" select="critical"/></xsl:call-template>
        </xsl:if>
      </tbody>
    </xsl:for-each>
  </table>
</xsl:template>

<!-- The part that breaks first, or of results that know no other criterion the stem: a row of the table of critical
     wind speeds. -->
<xsl:template name="breaks">
  <xsl:param name="at"/>
  <tr>
    <xsl:if test="$at/within_limits = 'false'"><xsl:attribute name="class">void</xsl:attribute></xsl:if>
    <td><xsl:if test="name($at) != 'critical'"><xsl:call-template name="name"/></xsl:if></td>
    <td>
      <xsl:choose>
        <xsl:when test="name($at) = 'critical'">
          <xsl:call-template name="say"><xsl:with-param name="id">c.first.part</xsl:with-param></xsl:call-template>
        </xsl:when>
        <xsl:otherwise>
          <xsl:call-template name="say"><xsl:with-param name="id">criterion.breakage</xsl:with-param></xsl:call-template>
        </xsl:otherwise>
      </xsl:choose>
    </td>
    <td>
      <xsl:call-template name="reached">
        <xsl:with-param name="of" select="$at"/>
        <xsl:with-param name="id"><xsl:choose>
          <xsl:when test="$at/within_limits = 'false'">outcome.void</xsl:when>
          <xsl:otherwise><xsl:value-of select="concat('outcome.', $at/outcome)"/></xsl:otherwise>
        </xsl:choose></xsl:with-param>
      </xsl:call-template>
      <xsl:if test="$at/governing_section/level &gt; 0"> (<xsl:call-template name="part">
        <xsl:with-param name="level" select="$at/governing_section/part"/></xsl:call-template>)</xsl:if>
      <xsl:call-template name="failing"><xsl:with-param name="section" select="$at/governing_section"/></xsl:call-template>
    </td>
    <xsl:call-template name="cell"><xsl:with-param name="x" select="$at/speed/value"/></xsl:call-template>
    <td class="r"><xsl:call-template name="gust"><xsl:with-param name="x" select="$at/speed/value"/></xsl:call-template></td>
    <xsl:call-template name="cell"><xsl:with-param name="x" select="$at/governing_section/height/value"/></xsl:call-template>
    <td class="r">
      <xsl:call-template name="given">
        <xsl:with-param name="x" select="species/streamlining/speed_high/value[../../../model/leaf_area/value &gt; 0 or
          ../../../model/frontal_area/value &gt; 0 or not(../../../model/generator = 'measured')]"/>
      </xsl:call-template>
    </td>
  </tr>
</xsl:template>
</xsl:stylesheet>
