<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- The page of a gusty wind: what was asked for and what came out. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform">
<xsl:import href="page.xsl"/>

<xsl:template match="/report" mode="title">
  <xsl:call-template name="say">
    <xsl:with-param name="id">wd.title</xsl:with-param>
    <xsl:with-param name="a"><xsl:call-template name="key">
      <xsl:with-param name="of">gust</xsl:with-param><xsl:with-param name="key" select="$r/model/name"/></xsl:call-template>
    </xsl:with-param>
  </xsl:call-template>
</xsl:template>
<xsl:template match="/report" mode="sub">
  <xsl:call-template name="say">
    <xsl:with-param name="id">wd.sub</xsl:with-param>
    <xsl:with-param name="a">
      <xsl:call-template name="given"><xsl:with-param name="x" select="$r/speed_m_s"/></xsl:call-template>
    </xsl:with-param>
    <xsl:with-param name="b">
      <xsl:call-template name="given"><xsl:with-param name="x" select="$r/height_m"/></xsl:call-template>
    </xsl:with-param>
    <xsl:with-param name="c">
      <xsl:call-template name="given"><xsl:with-param name="x" select="$r/steps * $r/step_s"/></xsl:call-template>
    </xsl:with-param>
  </xsl:call-template>
</xsl:template>

<xsl:template name="summary">
  <xsl:variable name="s" select="$r/statistics/item[1]"/>
  <div class="summary">
    <p>
      <xsl:call-template name="say">
        <xsl:with-param name="id">wd.summary</xsl:with-param>
        <xsl:with-param name="a">
          <xsl:call-template name="number"><xsl:with-param name="x" select="$s/mean_m_s"/></xsl:call-template>
        </xsl:with-param>
        <xsl:with-param name="b" select="$r/beaufort"/>
        <xsl:with-param name="c">
          <xsl:call-template name="number"><xsl:with-param name="x" select="$s/highest_m_s"/></xsl:call-template>
        </xsl:with-param>
        <xsl:with-param name="d">
          <xsl:call-template name="number"><xsl:with-param name="x" select="$s/gust_factor"/></xsl:call-template>
        </xsl:with-param>
      </xsl:call-template>
    </p>
    <xsl:if test="$r/findings/item">
      <p>
        <xsl:call-template name="say">
          <xsl:with-param name="id">
            <xsl:choose>
              <xsl:when test="$r/findings/item[within = 'false']">wd.some</xsl:when><xsl:otherwise>wd.all</xsl:otherwise>
            </xsl:choose>
          </xsl:with-param>
          <xsl:with-param name="a" select="count($r/findings/item[within = 'false'])"/>
          <xsl:with-param name="b" select="count($r/findings/item)"/>
        </xsl:call-template>
      </p>
    </xsl:if>
  </div>
</xsl:template>

<!-- One row a property, one column a component. along="yes": it says something of the wind along its mean only. -->
<xsl:template name="property">
  <xsl:param name="key"/><xsl:param name="unit"/><xsl:param name="along"/>
  <tr>
    <td>
      <xsl:call-template name="say">
        <xsl:with-param name="id" select="concat('wd.', $key)"/>
        <xsl:with-param name="a">
          <xsl:call-template name="given">
            <xsl:with-param name="x" select="$r/statistics/item[1]/gust_window_s"/>
          </xsl:call-template>
        </xsl:with-param>
        <xsl:with-param name="b">
          <xsl:call-template name="given">
            <xsl:with-param name="x" select="$r/statistics/item[1]/gust_period_s"/>
          </xsl:call-template>
        </xsl:with-param>
        <xsl:with-param name="c" select="$r/statistics/item[1]/gust_periods"/>
      </xsl:call-template>
      <xsl:if test="$unit != ''"><xsl:value-of select="concat(', ', $unit)"/></xsl:if>
    </td>
    <xsl:for-each select="$r/statistics/item">
      <xsl:variable name="meant" select="not($along) or position() = 1"/>
      <xsl:call-template name="n"><xsl:with-param name="x" select="*[name() = $key][$meant]"/></xsl:call-template>
    </xsl:for-each>
  </tr>
</xsl:template>

<xsl:template name="statistics">
  <table class="data whole">
    <xsl:call-template name="caption"><xsl:with-param name="id">wd.statistics</xsl:with-param></xsl:call-template>
    <thead>
      <tr>
        <xsl:call-template name="heads">
          <xsl:with-param name="of">c.property</xsl:with-param><xsl:with-param name="units">no</xsl:with-param>
        </xsl:call-template>
        <xsl:for-each select="$r/statistics/item">
          <th class="r">
            <xsl:call-template name="say">
              <xsl:with-param name="id" select="concat('wd.component.', position())"/>
            </xsl:call-template>
          </th>
        </xsl:for-each>
      </tr>
    </thead>
    <tbody>
      <xsl:call-template name="property">
        <xsl:with-param name="key">mean_m_s</xsl:with-param><xsl:with-param name="unit">m/s</xsl:with-param>
      </xsl:call-template>
      <xsl:call-template name="property">
        <xsl:with-param name="key">deviation_m_s</xsl:with-param><xsl:with-param name="unit">m/s</xsl:with-param>
      </xsl:call-template>
      <xsl:call-template name="property">
        <xsl:with-param name="key">intensity</xsl:with-param><xsl:with-param name="along">yes</xsl:with-param>
      </xsl:call-template>
      <xsl:call-template name="property">
        <xsl:with-param name="key">lowest_m_s</xsl:with-param><xsl:with-param name="unit">m/s</xsl:with-param>
      </xsl:call-template>
      <xsl:call-template name="property">
        <xsl:with-param name="key">highest_m_s</xsl:with-param><xsl:with-param name="unit">m/s</xsl:with-param>
      </xsl:call-template>
      <xsl:call-template name="property"><xsl:with-param name="key">skewness</xsl:with-param></xsl:call-template>
      <xsl:call-template name="property"><xsl:with-param name="key">kurtosis</xsl:with-param></xsl:call-template>
      <xsl:call-template name="property">
        <xsl:with-param name="key">time_scale_s</xsl:with-param><xsl:with-param name="unit">s</xsl:with-param>
      </xsl:call-template>
      <xsl:call-template name="property">
        <xsl:with-param name="key">length_scale_m</xsl:with-param><xsl:with-param name="unit">m</xsl:with-param>
        <xsl:with-param name="along">yes</xsl:with-param>
      </xsl:call-template>
      <xsl:call-template name="property">
        <xsl:with-param name="key">gust_factor</xsl:with-param><xsl:with-param name="along">yes</xsl:with-param>
      </xsl:call-template>
      <xsl:call-template name="property">
        <xsl:with-param name="key">peak_factor</xsl:with-param><xsl:with-param name="along">yes</xsl:with-param>
      </xsl:call-template>
    </tbody>
  </table>
</xsl:template>

<xsl:template name="asked">
  <table class="data">
    <xsl:call-template name="caption"><xsl:with-param name="id">wd.findings</xsl:with-param></xsl:call-template>
    <thead>
      <tr>
        <xsl:call-template name="heads">
          <xsl:with-param name="of">c.property;c.asked:;c.got:;c.off:%;c.scatter:%;c.verdict</xsl:with-param>
        </xsl:call-template>
      </tr>
    </thead>
    <tbody>
      <xsl:for-each select="$r/findings/item">
        <tr>
          <td>
            <xsl:call-template name="term">
              <xsl:with-param name="id" select="concat('finding.', name)"/><xsl:with-param name="otherwise" select="name"/>
            </xsl:call-template>
            <xsl:if test="unit != '-'"><xsl:value-of select="concat(', ', unit)"/></xsl:if>
          </td>
          <xsl:call-template name="n"><xsl:with-param name="x" select="asked"/></xsl:call-template>
          <xsl:call-template name="n"><xsl:with-param name="x" select="got"/></xsl:call-template>
          <xsl:call-template name="n"><xsl:with-param name="x" select="100 * (got div asked - 1)"/></xsl:call-template>
          <xsl:call-template name="n">
            <xsl:with-param name="x" select="100 * scatter div (asked * (1 - 2 * (asked &lt; 0)))"/>
          </xsl:call-template>
          <td>
            <xsl:call-template name="say"><xsl:with-param name="id" select="concat('wd.within.', within)"/></xsl:call-template>
          </td>
        </tr>
      </xsl:for-each>
    </tbody>
  </table>
</xsl:template>

<xsl:template name="model">
  <xsl:call-template name="h2"><xsl:with-param name="id">h.method</xsl:with-param></xsl:call-template>
  <table class="block">
    <xsl:call-template name="block-row">
      <xsl:with-param name="id">wd.model</xsl:with-param>
      <xsl:with-param name="text">
        <xsl:value-of select="$r/model/title"/> (<code><xsl:value-of select="$r/model/name"/></code>)</xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="block-row">
      <xsl:with-param name="id">in.source</xsl:with-param><xsl:with-param name="text" select="string($r/model/source)"/>
    </xsl:call-template>
    <xsl:call-template name="block-row">
      <xsl:with-param name="id">m.valid</xsl:with-param><xsl:with-param name="text" select="string($r/model/validity)"/>
    </xsl:call-template>
    <xsl:if test="$r/model/differs != ''">
      <xsl:call-template name="block-row">
        <xsl:with-param name="id">m.differs</xsl:with-param><xsl:with-param name="text" select="string($r/model/differs)"/>
      </xsl:call-template>
    </xsl:if>
    <xsl:call-template name="fact">
      <xsl:with-param name="id">wd.step</xsl:with-param><xsl:with-param name="x" select="$r/step_s"/>
      <xsl:with-param name="unit">s</xsl:with-param><xsl:with-param name="pattern">#,##0.#####</xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="block-row">
      <xsl:with-param name="id">wd.steps</xsl:with-param><xsl:with-param name="text" select="string($r/steps)"/>
    </xsl:call-template>
    <xsl:call-template name="block-row">
      <xsl:with-param name="id">wd.points</xsl:with-param><xsl:with-param name="text" select="string($r/points)"/>
    </xsl:call-template>
    <xsl:call-template name="block-row">
      <xsl:with-param name="id">p.seed</xsl:with-param><xsl:with-param name="text" select="string($r/seed)"/>
    </xsl:call-template>
    <xsl:if test="$r/joint != ''">
      <xsl:call-template name="fact">
        <xsl:with-param name="id">wd.joint</xsl:with-param><xsl:with-param name="x" select="100 * $r/joint"/>
        <xsl:with-param name="unit">%</xsl:with-param>
      </xsl:call-template>
    </xsl:if>
    <xsl:if test="$r/coherence_error != ''">
      <xsl:call-template name="fact">
        <xsl:with-param name="id">wd.coherence</xsl:with-param><xsl:with-param name="x" select="$r/coherence_error"/>
      </xsl:call-template>
    </xsl:if>
  </table>
  <xsl:if test="$r/model/parameters/item">
    <table class="data">
      <xsl:call-template name="caption"><xsl:with-param name="id">wd.parameters</xsl:with-param></xsl:call-template>
      <thead>
        <tr>
          <xsl:call-template name="heads">
            <xsl:with-param name="of">c.parameter;in.value:;in.unit;c.meaning</xsl:with-param>
            <xsl:with-param name="units">no</xsl:with-param>
          </xsl:call-template>
        </tr>
      </thead>
      <tbody>
        <xsl:for-each select="$r/model/parameters/item">
          <tr>
            <td>
              <xsl:call-template name="key">
                <xsl:with-param name="of">par</xsl:with-param><xsl:with-param name="key" select="name"/>
              </xsl:call-template> (<code><xsl:value-of select="name"/></code>)</td>
            <td class="r"><xsl:call-template name="given"><xsl:with-param name="x" select="value"/></xsl:call-template></td>
            <td><xsl:value-of select="translate(unit, '-', '–')"/></td><td><xsl:value-of select="meaning"/></td>
          </tr>
        </xsl:for-each>
      </tbody>
    </table>
  </xsl:if>
</xsl:template>

<xsl:template match="/report" mode="body">
  <xsl:call-template name="summary"/>
  <xsl:call-template name="not-looked"><xsl:with-param name="id">nl.wind</xsl:with-param></xsl:call-template>
  <xsl:call-template name="figure"><xsl:with-param name="name">wind</xsl:with-param></xsl:call-template>
  <xsl:call-template name="statistics"/>
  <xsl:if test="$r/findings/item"><xsl:call-template name="asked"/></xsl:if>
  <xsl:call-template name="figure"><xsl:with-param name="name">wind_coherence</xsl:with-param></xsl:call-template>
  <xsl:call-template name="findings"/>
  <xsl:call-template name="model"/>
</xsl:template>
</xsl:stylesheet>
