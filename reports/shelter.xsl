<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- The page of a tree in its own shelter: slabs, wind inside and behind, branches windward and leeward. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform">
<xsl:import href="page.xsl"/>

<xsl:template match="/report" mode="title">
  <xsl:call-template name="say"><xsl:with-param name="id">sh.title</xsl:with-param></xsl:call-template>
</xsl:template>
<xsl:template match="/report" mode="sub">
  <xsl:value-of select="$r/species"/>
  <xsl:call-template name="say"><xsl:with-param name="id">list.more</xsl:with-param></xsl:call-template>
  <xsl:value-of select="$r/tree"/>
</xsl:template>

<xsl:template name="inputs">
  <table class="block">
    <xsl:call-template name="block-row">
      <xsl:with-param name="id">tb.wind</xsl:with-param>
      <xsl:with-param name="text">
        <xsl:call-template name="say">
          <xsl:with-param name="id">tb.wind.text</xsl:with-param>
          <xsl:with-param name="a">
            <xsl:call-template name="given"><xsl:with-param name="x" select="$r/speed_m_s"/></xsl:call-template>
          </xsl:with-param>
          <xsl:with-param name="b">
            <xsl:call-template name="given"><xsl:with-param name="x" select="$r/reference_height_m"/></xsl:call-template>
          </xsl:with-param>
        </xsl:call-template>
        <xsl:for-each select="$r/scenario[gust_over_mean/value]"><br/><xsl:call-template name="site-line"/></xsl:for-each>
      </xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="block-row">
      <xsl:with-param name="id">sh.law</xsl:with-param>
      <xsl:with-param name="text" select="concat($r/law/title, ' (', $r/law/name, ')')"/>
    </xsl:call-template>
    <xsl:call-template name="block-row">
      <xsl:with-param name="id">in.source</xsl:with-param><xsl:with-param name="text" select="string($r/law/source)"/>
    </xsl:call-template>
    <xsl:call-template name="block-row">
      <xsl:with-param name="id">m.valid</xsl:with-param><xsl:with-param name="text" select="string($r/law/validity)"/>
    </xsl:call-template>
    <xsl:call-template name="block-row">
      <xsl:with-param name="id">sh.covered</xsl:with-param>
      <xsl:with-param name="text">
        <xsl:call-template name="say">
          <xsl:with-param name="id">
            <xsl:choose>
              <xsl:when test="$r/energy = 'true'">sh.energy</xsl:when><xsl:otherwise>sh.speed</xsl:otherwise>
            </xsl:choose>
          </xsl:with-param>
          <xsl:with-param name="a" select="format-number(100 * $r/transmission, '0')"/>
          <xsl:with-param name="b" select="format-number($r/speed_share, '0.000')"/>
        </xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="block-row">
      <xsl:with-param name="id">sh.grid</xsl:with-param>
      <xsl:with-param name="text">
        <xsl:call-template name="say">
          <xsl:with-param name="id">sh.grid.text</xsl:with-param>
          <xsl:with-param name="a" select="count($r/slabs/item) - 1"/>
          <xsl:with-param name="b" select="format-number($r/step_m/item[1], '0.000')"/>
          <xsl:with-param name="c" select="concat($r/across, ' × ', $r/up)"/>
          <xsl:with-param name="d" select="concat(format-number($r/step_m/item[2], '0.000'), ' × ',
            format-number($r/step_m/item[3], '0.000'))"/>
        </xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="block-row">
      <xsl:with-param name="id">in.segments</xsl:with-param><xsl:with-param name="text" select="string($r/segments)"/>
    </xsl:call-template>
  </table>
</xsl:template>

<xsl:template name="summary">
  <xsl:variable name="last" select="$r/slabs/item[last()]"/>
  <div class="summary">
    <p>
      <xsl:call-template name="say">
        <xsl:with-param name="id">sh.summary</xsl:with-param>
        <xsl:with-param name="a" select="format-number(100 * $last/arriving_ratio, '0')"/>
        <xsl:with-param name="b" select="format-number(100 * $last/flux_ratio, '0')"/>
      </xsl:call-template>
    </p>
    <xsl:if test="$r/moved/passes">
      <p>
        <xsl:call-template name="say">
          <xsl:with-param name="id">sh.moments</xsl:with-param>
          <xsl:with-param name="a">
            <xsl:call-template name="number">
              <xsl:with-param name="x" select="$r/moved/base_moment_open_N_m div 1000"/>
            </xsl:call-template>
          </xsl:with-param>
          <xsl:with-param name="b">
            <xsl:call-template name="number">
              <xsl:with-param name="x" select="$r/moved/base_moment_own_N_m div 1000"/>
            </xsl:call-template>
          </xsl:with-param>
          <xsl:with-param name="c" select="$r/moved/passes"/>
        </xsl:call-template>
      </p>
    </xsl:if>
  </div>
</xsl:template>

<xsl:template name="thirds">
  <table class="data whole">
    <xsl:call-template name="caption"><xsl:with-param name="id">sh.thirds</xsl:with-param></xsl:call-template>
    <thead>
      <tr>
        <xsl:call-template name="heads">
          <xsl:with-param name="of">c.ends;c.number:;c.wind.open:m/s;c.wind.own:m/s;
        c.move.open:m;c.move.own:m;c.swing.open:m;c.swing.own:m</xsl:with-param>
        </xsl:call-template>
      </tr>
    </thead>
    <tbody>
      <xsl:for-each select="$r/moved/thirds/item[number &gt; 0]">
        <tr>
          <td>
            <xsl:call-template name="say">
              <xsl:with-param name="id" select="concat('sh.third.', count(preceding-sibling::item) + 1)"/>
            </xsl:call-template>
          </td>
          <td class="r"><xsl:value-of select="number"/></td>
          <xsl:for-each select="wind_m_s/item | move_m/item | swing_m/item">
            <xsl:call-template name="n"><xsl:with-param name="x" select="."/></xsl:call-template>
          </xsl:for-each>
        </tr>
      </xsl:for-each>
    </tbody>
  </table>
</xsl:template>

<xsl:template name="slabs">
  <table class="data">
    <xsl:call-template name="caption">
      <xsl:with-param name="id">sh.slabs</xsl:with-param>
      <xsl:with-param name="a" select="format-number($r/across * $r/step_m/item[2], '0.0')"/>
      <xsl:with-param name="b" select="format-number($r/up * $r/step_m/item[3], '0.0')"/>
    </xsl:call-template>
    <thead>
      <tr>
        <xsl:call-template name="heads">
          <xsl:with-param name="of">c.slab;c.front:m;c.wood:m²;c.leaves:m²;c.covered:m²;
        cell.cylinder:;cell.hole:;cell.slit:;cell.transmitting:;
        c.full:;c.arriving:–;c.flux:–</xsl:with-param>
        </xsl:call-template>
      </tr>
    </thead>
    <tbody class="long">
      <xsl:for-each select="$r/slabs/item">
        <tr>
          <xsl:choose>
            <xsl:when test="position() = last()">
              <td>
                <b><xsl:call-template name="say"><xsl:with-param name="id">sh.behind</xsl:with-param></xsl:call-template></b>
              </td>
            </xsl:when>
            <xsl:otherwise><td><xsl:value-of select="position()"/></td></xsl:otherwise>
          </xsl:choose>
          <xsl:call-template name="cell">
            <xsl:with-param name="x" select="front_m"/><xsl:with-param name="pattern">0.00</xsl:with-param>
          </xsl:call-template>
          <xsl:choose>
            <xsl:when test="position() = last()"><td colspan="8"/></xsl:when>
            <xsl:otherwise>
              <xsl:for-each select="wood_m2 | leaf_m2 | covered_m2">
                <xsl:call-template name="n"><xsl:with-param name="x" select="."/></xsl:call-template>
              </xsl:for-each>
              <td class="r"><xsl:value-of select="cylinder"/></td><td class="r"><xsl:value-of select="hole"/></td>
              <td class="r"><xsl:value-of select="slit"/></td><td class="r"><xsl:value-of select="transmitting"/></td>
              <td class="r"><xsl:value-of select="full"/></td>
            </xsl:otherwise>
          </xsl:choose>
          <xsl:call-template name="cell">
            <xsl:with-param name="x" select="arriving_ratio"/><xsl:with-param name="pattern">0.000</xsl:with-param>
          </xsl:call-template>
          <xsl:call-template name="cell">
            <xsl:with-param name="x" select="flux_ratio"/><xsl:with-param name="pattern">0.000</xsl:with-param>
          </xsl:call-template>
        </tr>
      </xsl:for-each>
    </tbody>
  </table>
</xsl:template>

<xsl:template match="/report" mode="body">
  <xsl:call-template name="summary"/>
  <xsl:call-template name="not-looked"><xsl:with-param name="id">nl.shelter</xsl:with-param></xsl:call-template>
  <xsl:call-template name="inputs"/>
  <xsl:call-template name="slabs"/>
  <xsl:call-template name="figure"><xsl:with-param name="name">shelter_wind</xsl:with-param></xsl:call-template>
  <xsl:call-template name="figure"><xsl:with-param name="name">shelter_slabs</xsl:with-param></xsl:call-template>
  <xsl:if test="$r/moved/passes">
    <xsl:call-template name="thirds"/>
    <xsl:call-template name="figure"><xsl:with-param name="name">shelter_motion</xsl:with-param></xsl:call-template>
  </xsl:if>
  <xsl:call-template name="findings"/>
</xsl:template>
</xsl:stylesheet>
