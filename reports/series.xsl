<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- The page of runs in time: what was run, panels of key frames, courses in time, amplitudes, methods, warnings. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform">
<xsl:import href="page.xsl"/>
<xsl:include href="explained.xsl"/>

<!-- A title the program gave is a string of its own; others are the user's. -->
<xsl:template match="/report" mode="title">
  <xsl:choose>
    <xsl:when test="$strings/s[@id = 'sr.title']/en = $r/title">
      <xsl:call-template name="say"><xsl:with-param name="id">sr.title</xsl:with-param></xsl:call-template>
    </xsl:when>
    <xsl:otherwise><xsl:value-of select="$r/title"/></xsl:otherwise>
  </xsl:choose>
</xsl:template>
<xsl:template match="/report" mode="sub">
  <xsl:call-template name="say">
    <xsl:with-param name="id">
      <xsl:choose>
        <xsl:when test="count($r/runs/item) = 1">sr.sub.one</xsl:when><xsl:otherwise>sr.sub</xsl:otherwise>
      </xsl:choose>
    </xsl:with-param>
    <xsl:with-param name="a" select="count($r/runs/item)"/>
  </xsl:call-template>
</xsl:template>

<xsl:template name="run-name">
  <xsl:value-of select="concat(count(preceding-sibling::item) + 1, '. ')"/><xsl:call-template name="run-words"/>
</xsl:template>

<xsl:variable name="semicolon">
  <xsl:call-template name="say"><xsl:with-param name="id">list.apart</xsl:with-param></xsl:call-template>
</xsl:variable>

<!-- "corrected; exact beams; steady wind; shelter: wakes; power law" -->
<xsl:template name="method-words">
  <xsl:call-template name="key"><xsl:with-param name="of">preset</xsl:with-param><xsl:with-param name="key" select="preset"/>
  </xsl:call-template>
  <xsl:value-of select="$semicolon"/>
  <xsl:call-template name="key"><xsl:with-param name="of">method</xsl:with-param><xsl:with-param name="key" select="solver"/>
  </xsl:call-template>
  <xsl:value-of select="$semicolon"/>
  <xsl:choose>
    <xsl:when test="gust != ''">
      <xsl:call-template name="key"><xsl:with-param name="of">gust</xsl:with-param><xsl:with-param name="key" select="gust"/>
      </xsl:call-template>
    </xsl:when>
    <xsl:otherwise>
      <xsl:call-template name="say"><xsl:with-param name="id">sr.steady</xsl:with-param></xsl:call-template>
    </xsl:otherwise>
  </xsl:choose>
  <xsl:if test="components = 3">, <xsl:call-template name="say"><xsl:with-param name="id">sr.components</xsl:with-param>
    </xsl:call-template></xsl:if>
  <xsl:if test="shelter != ''"><xsl:value-of select="$semicolon"/>
    <xsl:call-template name="say"><xsl:with-param name="id">sr.shelter</xsl:with-param>
    <xsl:with-param name="a"><xsl:call-template name="key">
      <xsl:with-param name="of">law</xsl:with-param><xsl:with-param name="key" select="shelter"/></xsl:call-template></xsl:with-param>
    </xsl:call-template></xsl:if>
  <xsl:value-of select="$semicolon"/>
  <xsl:call-template name="key"><xsl:with-param name="of">m.profile</xsl:with-param><xsl:with-param name="key" select="profile"/>
  </xsl:call-template>
</xsl:template>

<xsl:template match="item" mode="run"><xsl:call-template name="run-name"/></xsl:template>

<xsl:template name="runs">
  <table class="data runs">
    <xsl:call-template name="caption"><xsl:with-param name="id">sr.runs</xsl:with-param></xsl:call-template>
    <thead>
      <tr>
        <xsl:call-template name="heads">
          <xsl:with-param name="of">c.run;c.tree.model;c.how;c.wind.mean:m/s;c.youngs:GPa;
        c.mean:m;c.most:m;c.share.height:%;c.safety.least:</xsl:with-param>
        </xsl:call-template>
      </tr>
    </thead>
    <xsl:for-each select="$r/runs/item">
      <tbody>
        <tr>
          <td><xsl:call-template name="run-name"/></td>
          <td>
            <xsl:call-template name="run-tree"/>
            <xsl:call-template name="say"><xsl:with-param name="id">list.more</xsl:with-param></xsl:call-template>
            <xsl:value-of select="model_name | self::*[not(model_name)]/model"/>
          </td>
          <td><xsl:call-template name="method-words"/></td>
          <xsl:call-template name="n"><xsl:with-param name="x" select="wind_mean_m_s"/></xsl:call-template>
          <xsl:call-template name="n"><xsl:with-param name="x" select="youngs_modulus_Pa div 1e9"/></xsl:call-template>
          <xsl:call-template name="n"><xsl:with-param name="x" select="tip_deflection_mean_m"/></xsl:call-template>
          <xsl:call-template name="n"><xsl:with-param name="x" select="tip_deflection_largest_m"/></xsl:call-template>
          <xsl:call-template name="n">
            <xsl:with-param name="x" select="100 * tip_deflection_largest_m div height_m"/>
          </xsl:call-template>
          <xsl:call-template name="n"><xsl:with-param name="x" select="safety_least"/></xsl:call-template>
        </tr>
      </tbody>
    </xsl:for-each>
  </table>
</xsl:template>

<xsl:template name="amplitudes">
  <xsl:call-template name="h2"><xsl:with-param name="id">sr.h.levels</xsl:with-param></xsl:call-template>
  <table class="data runs">
    <xsl:call-template name="caption"><xsl:with-param name="id">sr.levels</xsl:with-param></xsl:call-template>
    <thead>
      <tr>
        <xsl:call-template name="heads">
          <xsl:with-param name="of">c.run;c.level;c.axes:;c.mean:m;c.largest:m;c.own:m;c.windward:m;c.leeward:m;
        c.own.windward:m;c.own.leeward:m</xsl:with-param>
        </xsl:call-template>
      </tr>
    </thead>
    <xsl:for-each select="$r/runs/item[frames &gt; 1]">
      <tbody>
        <xsl:for-each select="levels/item">
          <tr>
            <td>
              <xsl:if test="position() = 1">
                <xsl:for-each select="../.."><xsl:call-template name="run-name"/></xsl:for-each>
              </xsl:if>
            </td>
            <td><xsl:value-of select="position() - 1"/></td><td class="r"><xsl:value-of select="axes"/></td>
            <xsl:call-template name="n"><xsl:with-param name="x" select="mean_m"/></xsl:call-template>
            <xsl:call-template name="n"><xsl:with-param name="x" select="largest_m"/></xsl:call-template>
            <xsl:call-template name="n"><xsl:with-param name="x" select="own_m"/></xsl:call-template>
            <xsl:call-template name="n"><xsl:with-param name="x" select="windward_m"/></xsl:call-template>
            <xsl:call-template name="n"><xsl:with-param name="x" select="leeward_m"/></xsl:call-template>
            <xsl:call-template name="n"><xsl:with-param name="x" select="own_windward_m"/></xsl:call-template>
            <xsl:call-template name="n"><xsl:with-param name="x" select="own_leeward_m"/></xsl:call-template>
          </tr>
        </xsl:for-each>
      </tbody>
    </xsl:for-each>
  </table>
</xsl:template>

<xsl:template name="shapes">
  <xsl:if test="/report/figures/figure[@name = 'frames_all']">
    <xsl:call-template name="h2"><xsl:with-param name="id">sr.h.shapes</xsl:with-param></xsl:call-template>
    <xsl:call-template name="figure">
      <xsl:with-param name="name">modulus</xsl:with-param>
      <xsl:with-param name="a" select="$r/sweep/species_name"/>
      <xsl:with-param name="b">
        <xsl:call-template name="number"><xsl:with-param name="x" select="$r/sweep/speed_m_s"/></xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="figure"><xsl:with-param name="name">frames_all</xsl:with-param></xsl:call-template>
  </xsl:if>
  <xsl:if test="$r/runs/item[keys &gt; 1]">
    <xsl:call-template name="h2"><xsl:with-param name="id">sr.h.keys</xsl:with-param></xsl:call-template>
    <xsl:for-each select="$r/runs/item[keys &gt; 1]">
      <xsl:variable name="number" select="count(preceding-sibling::item) + 1"/>
      <xsl:call-template name="figure">
        <xsl:with-param name="name" select="concat('frames_', $number)"/><xsl:with-param name="id">cap.frames</xsl:with-param>
        <xsl:with-param name="a" select="$number"/>
        <xsl:with-param name="b"><xsl:call-template name="run-words"/></xsl:with-param>
      </xsl:call-template>
    </xsl:for-each>
  </xsl:if>
  <xsl:if test="$r/runs/item[frames &gt; 1]">
    <xsl:call-template name="h2"><xsl:with-param name="id">sr.h.time</xsl:with-param></xsl:call-template>
    <xsl:call-template name="figure"><xsl:with-param name="name">series</xsl:with-param></xsl:call-template>
    <xsl:call-template name="figure"><xsl:with-param name="name">leaf_angles</xsl:with-param></xsl:call-template>
  </xsl:if>
</xsl:template>

<!-- The key frames one after the other, for the screen alone; hidden until its script runs. -->
<xsl:template name="play">
  <section id="live" class="live" hidden="hidden">
    <xsl:call-template name="live-frames"/>
    <div class="cols">
      <div class="col stage"></div>
      <div class="col picture">
        <table class="block" aria-live="polite">
          <xsl:call-template name="live-row"><xsl:with-param name="key">time</xsl:with-param>
            <xsl:with-param name="unit">s</xsl:with-param></xsl:call-template>
          <xsl:call-template name="live-row"><xsl:with-param name="key">wind</xsl:with-param>
            <xsl:with-param name="id">lv.wind.now</xsl:with-param><xsl:with-param name="unit">m/s</xsl:with-param></xsl:call-template>
          <xsl:call-template name="live-row"><xsl:with-param name="key">tip</xsl:with-param>
            <xsl:with-param name="id">lv.tip.now</xsl:with-param><xsl:with-param name="unit">m</xsl:with-param></xsl:call-template>
          <xsl:call-template name="live-row"><xsl:with-param name="key">moment</xsl:with-param>
            <xsl:with-param name="id">lv.moment.now</xsl:with-param><xsl:with-param name="unit">kN m</xsl:with-param></xsl:call-template>
          <xsl:call-template name="live-row"><xsl:with-param name="key">safety</xsl:with-param>
            <xsl:with-param name="id">lv.safety.now</xsl:with-param></xsl:call-template>
        </table>
        <p class="care beyond" hidden="hidden">
          <xsl:call-template name="say"><xsl:with-param name="id">lv.broken</xsl:with-param></xsl:call-template></p>
        <p class="note"><xsl:call-template name="say"><xsl:with-param name="id">lv.frames.note</xsl:with-param></xsl:call-template></p>
        <p class="note stems" hidden="hidden">
          <xsl:call-template name="say"><xsl:with-param name="id">lv.stems</xsl:with-param></xsl:call-template></p>
      </div>
    </div>
  </section>
</xsl:template>

<xsl:template match="/report" mode="body">
  <div class="summary">
    <xsl:variable name="broken" select="$r/runs/item[breaks_at_s != '']"/>
    <xsl:if test="count($r/runs/item) &gt; 3">
      <p>
        <xsl:call-template name="say">
          <xsl:with-param name="id">sr.summary.many</xsl:with-param>
          <xsl:with-param name="a" select="count($r/runs/item)"/><xsl:with-param name="b" select="count($broken)"/>
          <xsl:with-param name="c"><xsl:if test="$broken">
            <xsl:call-template name="say">
              <xsl:with-param name="id">sr.summary.which</xsl:with-param>
              <xsl:with-param name="a"><xsl:for-each select="$broken">
                <xsl:if test="position() &gt; 1">
                  <xsl:call-template name="say"><xsl:with-param name="id">list.more</xsl:with-param></xsl:call-template></xsl:if>
                <xsl:value-of select="count(preceding-sibling::item) + 1"/>
              </xsl:for-each></xsl:with-param>
            </xsl:call-template></xsl:if></xsl:with-param>
          <xsl:with-param name="d" select="count($r/runs/item[safety_least != '']) - count($broken[safety_least != ''])"/>
        </xsl:call-template>
      </p>
    </xsl:if>
    <xsl:for-each select="$r/runs/item[count($r/runs/item) &lt;= 3]">
      <p>
        <xsl:if test="count($r/runs/item) &gt; 1"><xsl:value-of select="concat(position(), '. ')"/></xsl:if>
        <xsl:call-template name="say">
          <xsl:with-param name="id">sr.summary</xsl:with-param>
          <xsl:with-param name="a"><xsl:call-template name="run-tree"/></xsl:with-param>
          <xsl:with-param name="b"><xsl:call-template name="number">
            <xsl:with-param name="x" select="wind_mean_m_s"/></xsl:call-template></xsl:with-param>
          <xsl:with-param name="c"><xsl:call-template name="number">
            <xsl:with-param name="x" select="tip_deflection_largest_m"/></xsl:call-template></xsl:with-param>
          <xsl:with-param name="d"><xsl:call-template name="number">
            <xsl:with-param name="x" select="100 * tip_deflection_largest_m div height_m"/></xsl:call-template></xsl:with-param>
        </xsl:call-template>
        <xsl:value-of select="$gap"/>
        <xsl:call-template name="say">
          <xsl:with-param name="id">sr.summary.<xsl:choose>
            <xsl:when test="breaks_at_s != ''">breaks</xsl:when><xsl:when test="safety_least != ''">holds</xsl:when>
            <xsl:otherwise>unknown</xsl:otherwise></xsl:choose></xsl:with-param>
          <xsl:with-param name="a"><xsl:call-template name="number">
            <xsl:with-param name="x" select="breaks_at_s"/></xsl:call-template></xsl:with-param>
          <xsl:with-param name="b"><xsl:call-template name="number">
            <xsl:with-param name="x" select="safety_least"/></xsl:call-template></xsl:with-param>
        </xsl:call-template>
      </p>
    </xsl:for-each>
    <xsl:if test="$r/note != ''"><p><xsl:value-of select="$r/note"/></p></xsl:if>
  </div>
  <xsl:call-template name="not-looked"><xsl:with-param name="id">nl.series</xsl:with-param></xsl:call-template>
  <xsl:if test="script"><xsl:call-template name="play"/></xsl:if>
  <xsl:call-template name="h2"><xsl:with-param name="id">sr.h.runs</xsl:with-param></xsl:call-template>
  <xsl:call-template name="runs"/>
  <xsl:call-template name="shapes"/>
  <xsl:if test="$r/runs/item[frames &gt; 1]"><xsl:call-template name="amplitudes"/></xsl:if>
  <xsl:apply-templates select="$r/explained/item" mode="section"/>
  <xsl:call-template name="findings"><xsl:with-param name="id">h.departures</xsl:with-param></xsl:call-template>
</xsl:template>
</xsl:stylesheet>
