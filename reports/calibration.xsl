<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- The page of windfirm fit: what the measurements say about the tree. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform">
<xsl:import href="page.xsl"/>
<xsl:variable name="f" select="$r/fit"/>

<!-- About four significant digits. -->
<!-- "um/m" as it is written; the context has a unit. -->
<xsl:template name="unit-words">
  <xsl:choose>
    <xsl:when test="unit = 'um/m'">µm/m</xsl:when><xsl:when test="unit = 'deg'">°</xsl:when>
    <xsl:otherwise><xsl:value-of select="unit"/></xsl:otherwise>
  </xsl:choose>
</xsl:template>

<!-- A fitted parameter in words, with its key: "level0.youngs_modulus" is Young's modulus of the stem. -->
<xsl:template name="parameter-words">
  <xsl:variable name="level" select="substring-before(substring-after(name, 'level'), '.')"/>
  <xsl:variable name="key">
    <xsl:choose>
      <xsl:when test="starts-with(name, 'level') and $level != ''">
        <xsl:value-of select="substring-after(name, '.')"/></xsl:when>
      <xsl:when test="starts-with(name, 'each.')"><xsl:value-of select="substring-after(name, 'each.')"/></xsl:when>
      <xsl:otherwise><xsl:value-of select="name"/></xsl:otherwise>
    </xsl:choose>
  </xsl:variable>
  <xsl:variable name="words">
    <xsl:call-template name="term">
      <xsl:with-param name="id" select="concat('par.', $key)"/>
      <xsl:with-param name="otherwise"><xsl:call-template name="term">
        <xsl:with-param name="id" select="$key"/></xsl:call-template></xsl:with-param>
    </xsl:call-template>
  </xsl:variable>
  <xsl:choose>
    <xsl:when test="$words = ''"><xsl:value-of select="name"/></xsl:when>
    <xsl:otherwise>
      <xsl:value-of select="$words"/>
      <xsl:if test="$level != ''">
        <xsl:call-template name="say">
          <xsl:with-param name="id">par.of<xsl:if test="$level != '0'">.level</xsl:if></xsl:with-param>
          <xsl:with-param name="a" select="$level"/>
        </xsl:call-template>
      </xsl:if>
    </xsl:otherwise>
  </xsl:choose>
</xsl:template>

<xsl:template name="four">
  <xsl:param name="x"/>
  <xsl:variable name="a" select="$x * (1 - 2 * ($x &lt; 0))"/>
  <xsl:variable name="pattern">
    <xsl:choose>
      <xsl:when test="$a = 0 or $a &gt;= 1000">#,##0</xsl:when>
      <xsl:when test="$a &gt;= 100">0.0</xsl:when>
      <xsl:when test="$a &gt;= 10">0.00</xsl:when>
      <xsl:when test="$a &gt;= 1">0.000</xsl:when>
      <xsl:when test="$a &gt;= 0.01">0.0000</xsl:when>
      <xsl:when test="$a &gt;= 0.001">0.000000</xsl:when>
      <xsl:otherwise>0.0000000</xsl:otherwise>
    </xsl:choose>
  </xsl:variable>
  <xsl:call-template name="fixed">
    <xsl:with-param name="x" select="$x"/><xsl:with-param name="pattern" select="string($pattern)"/>
  </xsl:call-template>
</xsl:template>

<xsl:template name="range">
  <xsl:param name="low"/><xsl:param name="high"/>
  <xsl:choose>
    <xsl:when test="$low = '' and $high = ''">–</xsl:when>
    <xsl:otherwise>
      <xsl:call-template name="say">
        <xsl:with-param name="id">
          <xsl:choose>
            <xsl:when test="$low = ''">ft.below</xsl:when>
            <xsl:when test="$high = ''">ft.above</xsl:when>
            <xsl:otherwise>range</xsl:otherwise>
          </xsl:choose>
        </xsl:with-param>
        <xsl:with-param name="a">
          <xsl:call-template name="four">
            <xsl:with-param name="x" select="$low[. != ''] | $high[$low = '']"/>
          </xsl:call-template>
        </xsl:with-param>
        <xsl:with-param name="b">
          <xsl:call-template name="four"><xsl:with-param name="x" select="$high"/></xsl:call-template>
        </xsl:with-param>
      </xsl:call-template>
    </xsl:otherwise>
  </xsl:choose>
</xsl:template>
<xsl:template name="range-cell">
  <xsl:param name="low"/><xsl:param name="high"/>
  <td class="r">
    <xsl:call-template name="range">
      <xsl:with-param name="low" select="$low"/><xsl:with-param name="high" select="$high"/>
    </xsl:call-template>
  </td>
</xsl:template>
<xsl:template name="four-cell">
  <xsl:param name="x"/>
  <td class="r"><xsl:call-template name="four"><xsl:with-param name="x" select="$x"/></xsl:call-template></td>
</xsl:template>

<xsl:template name="value">
  <xsl:call-template name="four"><xsl:with-param name="x" select="value"/></xsl:call-template>
  <xsl:if test="unit != ''"><xsl:value-of select="concat('&#160;', unit)"/></xsl:if>
</xsl:template>

<xsl:template match="/report" mode="title"><xsl:value-of select="$r/title"/></xsl:template>
<xsl:template match="/report" mode="sub">
  <xsl:call-template name="say"><xsl:with-param name="id">ft.sub</xsl:with-param></xsl:call-template>
</xsl:template>

<!-- What one parameter comes to: a bound, an open side, or a value with its interval. -->
<xsl:template match="item" mode="estimate">
  <xsl:variable name="profile">
    <xsl:call-template name="range">
      <xsl:with-param name="low" select="profile_low"/><xsl:with-param name="high" select="profile_high"/>
    </xsl:call-template>
  </xsl:variable>
  <xsl:variable name="covariance">
    <xsl:call-template name="range">
      <xsl:with-param name="low" select="low"/><xsl:with-param name="high" select="high"/>
    </xsl:call-template>
  </xsl:variable>
  <xsl:variable name="value"><xsl:call-template name="value"/></xsl:variable>
  <xsl:variable name="profiled" select="profile_low != '' or profile_high != ''"/>
  <p>
    <b><xsl:call-template name="parameter-words"/></b>
    <xsl:call-template name="say"><xsl:with-param name="id">colon</xsl:with-param></xsl:call-template>
    <xsl:call-template name="say">
      <xsl:with-param name="id">
        <xsl:choose>
          <xsl:when test="bound != '' and $profiled"><xsl:value-of select="concat('ft.bound.profile.', bound)"/></xsl:when>
          <xsl:when test="bound != ''"><xsl:value-of select="concat('ft.bound.', bound)"/></xsl:when>
          <xsl:when test="(profile_low != '') != (profile_high != '')">ft.open</xsl:when>
          <xsl:when test="$profiled">ft.interval.profile</xsl:when>
          <xsl:otherwise>ft.interval</xsl:otherwise>
        </xsl:choose>
      </xsl:with-param>
      <xsl:with-param name="a" select="$value"/>
      <xsl:with-param name="b">
        <xsl:choose>
          <xsl:when test="$profiled"><xsl:value-of select="$profile"/></xsl:when>
          <xsl:otherwise>
            <xsl:value-of
        select="$covariance"/>
          </xsl:otherwise>
        </xsl:choose>
      </xsl:with-param>
      <xsl:with-param name="c"><xsl:if test="unit != ''"><xsl:value-of select="concat('&#160;', unit)"/></xsl:if></xsl:with-param>
    </xsl:call-template>
  </p>
</xsl:template>

<!-- The same data with the root the other way: its values, and which of the two the data prefer. -->
<xsl:template name="rival">
  <xsl:variable name="gap-of" select="$r/rival/aicc - $r/rival/own_aicc"/>
  <p>
    <xsl:call-template name="say">
      <xsl:with-param name="id">ft.rival</xsl:with-param>
      <xsl:with-param name="a">
        <xsl:call-template name="term">
          <xsl:with-param name="id" select="concat('rival.', $r/rival/text)"/>
          <xsl:with-param name="otherwise" select="$r/rival/text"/>
        </xsl:call-template>
      </xsl:with-param>
      <xsl:with-param name="b">
        <xsl:for-each select="$r/rival/parameters/item[nuisance = 'false']">
          <xsl:if test="position() &gt; 1">
            <xsl:call-template name="say"><xsl:with-param name="id">list.more</xsl:with-param></xsl:call-template>
          </xsl:if>
          <xsl:value-of select="concat(name, ' ')"/><xsl:call-template name="value"/>
          <xsl:choose>
            <xsl:when test="bound != ''">
              <xsl:call-template name="say"><xsl:with-param name="id">ft.at.bound</xsl:with-param></xsl:call-template>
            </xsl:when>
            <xsl:when test="low = ''">
              <xsl:call-template name="say"><xsl:with-param name="id">ft.loose</xsl:with-param></xsl:call-template>
            </xsl:when>
          </xsl:choose>
        </xsl:for-each>
      </xsl:with-param>
    </xsl:call-template>
    <xsl:if test="$r/rival/aicc != '' and $r/rival/own_aicc != ''">
      <xsl:value-of select="$gap"/>
      <xsl:call-template name="say">
        <xsl:with-param name="id">
          <xsl:choose>
            <xsl:when test="$gap-of &gt; 2">ft.prefer.this</xsl:when><xsl:when test="$gap-of &lt; -2">ft.prefer.other</xsl:when>
            <xsl:otherwise>ft.prefer.none</xsl:otherwise>
          </xsl:choose>
        </xsl:with-param>
        <xsl:with-param name="a">
          <xsl:call-template name="four"><xsl:with-param name="x" select="$r/rival/own_aicc"/></xsl:call-template>
        </xsl:with-param>
        <xsl:with-param name="b">
          <xsl:call-template name="four"><xsl:with-param name="x" select="$r/rival/aicc"/></xsl:call-template>
        </xsl:with-param>
      </xsl:call-template>
    </xsl:if>
  </p>
</xsl:template>

<xsl:template name="summary">
  <div class="summary">
    <xsl:apply-templates select="$f/parameters/item[nuisance = 'false']" mode="estimate"/>
    <xsl:choose>
      <xsl:when test="$f/not_determined/item">
        <xsl:for-each select="$f/not_determined/item">
          <p><b><xsl:call-template name="say"><xsl:with-param name="id">ft.not.determined</xsl:with-param></xsl:call-template>
            </b>
          <xsl:text> </xsl:text><xsl:value-of select="text"/>.</p>
        </xsl:for-each>
      </xsl:when>
      <xsl:when test="$f/freedom = 0">
        <p><xsl:call-template name="say"><xsl:with-param name="id">ft.determined.none</xsl:with-param></xsl:call-template></p>
      </xsl:when>
      <xsl:when test="$f/parameters/item[nuisance = 'false' and bound != '']">
        <p><xsl:call-template name="say"><xsl:with-param name="id">ft.determined.rest</xsl:with-param></xsl:call-template></p>
      </xsl:when>
      <xsl:otherwise>
        <p><xsl:call-template name="say"><xsl:with-param name="id">ft.determined</xsl:with-param></xsl:call-template></p>
      </xsl:otherwise>
    </xsl:choose>
    <xsl:if test="$r/rival"><xsl:call-template name="rival"/></xsl:if>
    <xsl:if test="$r/reference != ''">
      <p>
        <xsl:call-template name="say">
          <xsl:with-param name="id">ft.reference</xsl:with-param>
          <xsl:with-param name="a" select="$r/reference"/>
        </xsl:call-template>
      </p>
    </xsl:if>
  </div>
</xsl:template>

<xsl:template name="estimates">
  <xsl:variable name="resampled" select="$f/resampled &gt; 19"/>
  <table class="data">
    <xsl:call-template name="caption"><xsl:with-param name="id">ft.estimates</xsl:with-param></xsl:call-template>
    <thead>
      <tr>
        <xsl:call-template name="heads">
          <xsl:with-param name="of">c.parameter;in.unit;c.estimate:;c.covariance:;c.profile:</xsl:with-param>
          <xsl:with-param name="units">no</xsl:with-param>
        </xsl:call-template>
        <xsl:if test="$resampled">
          <xsl:call-template name="heads">
            <xsl:with-param name="of">c.bootstrap:</xsl:with-param><xsl:with-param name="units">no</xsl:with-param>
          </xsl:call-template>
        </xsl:if>
        <xsl:call-template name="heads">
          <xsl:with-param name="of">c.bounds:</xsl:with-param><xsl:with-param name="units">no</xsl:with-param>
        </xsl:call-template>
      </tr>
    </thead>
    <tbody>
      <xsl:for-each select="$f/parameters/item">
        <tr>
          <td><xsl:call-template name="parameter-words"/></td><td><xsl:call-template name="unit-words"/></td>
          <xsl:call-template name="four-cell"><xsl:with-param name="x" select="value"/></xsl:call-template>
          <xsl:call-template name="range-cell">
            <xsl:with-param name="low" select="low"/><xsl:with-param name="high" select="high"/>
          </xsl:call-template>
          <xsl:call-template name="range-cell">
            <xsl:with-param name="low" select="profile_low"/><xsl:with-param name="high" select="profile_high"/>
          </xsl:call-template>
          <xsl:if test="$resampled">
            <xsl:call-template name="range-cell">
              <xsl:with-param name="low" select="bootstrap_low"/><xsl:with-param name="high" select="bootstrap_high"/>
            </xsl:call-template>
          </xsl:if>
          <td class="r">
            <xsl:if test="nuisance = 'false'">
              <xsl:call-template name="range">
                <xsl:with-param name="low" select="bound_low"/><xsl:with-param name="high" select="bound_high"/>
              </xsl:call-template>
            </xsl:if>
            <xsl:if test="bound != ''">
              <xsl:text> </xsl:text>
              <b>
                <xsl:call-template name="say">
                  <xsl:with-param name="id" select="concat('ft.on.bound.', bound)"/>
                </xsl:call-template>
              </b>
            </xsl:if>
          </td>
        </tr>
      </xsl:for-each>
    </tbody>
  </table>
</xsl:template>

<xsl:template name="correlations">
  <table class="data">
    <xsl:call-template name="caption"><xsl:with-param name="id">ft.correlations</xsl:with-param></xsl:call-template>
    <thead>
      <tr>
        <th/>
        <xsl:for-each select="$f/parameters/item[nuisance = 'false']">
          <th class="r"><xsl:call-template name="parameter-words"/></th>
        </xsl:for-each>
      </tr>
    </thead>
    <tbody>
      <xsl:for-each select="$f/parameters/item[nuisance = 'false']">
        <xsl:variable name="row" select="position()"/>
        <tr>
          <td><xsl:call-template name="parameter-words"/></td>
          <xsl:for-each select="correlation/item">
            <td class="r">
              <xsl:if test="position() &lt;= $row">
                <xsl:call-template name="fixed">
                  <xsl:with-param name="x" select="."/><xsl:with-param name="pattern">0.00</xsl:with-param>
                </xsl:call-template>
              </xsl:if>
            </td>
          </xsl:for-each>
        </tr>
      </xsl:for-each>
    </tbody>
  </table>
</xsl:template>

<xsl:template name="sensors">
  <table class="data">
    <caption>
      <xsl:call-template name="say"><xsl:with-param name="id">ft.sensors</xsl:with-param></xsl:call-template>
      <xsl:value-of select="$gap"/>
      <xsl:call-template name="say">
        <xsl:with-param name="id">
          <xsl:choose>
            <xsl:when test="$f/freedom = 0">ft.chi.none</xsl:when>
            <xsl:when test="$f/sigma_estimated = 'true'">ft.chi.estimated</xsl:when><xsl:otherwise>ft.chi</xsl:otherwise>
          </xsl:choose>
        </xsl:with-param>
        <xsl:with-param name="a">
          <xsl:if test="$f/freedom != 0">
            <xsl:call-template name="four"><xsl:with-param name="x" select="$f/reduced_chi_square"/></xsl:call-template>
          </xsl:if>
        </xsl:with-param>
        <xsl:with-param name="b" select="$f/freedom"/>
      </xsl:call-template>
    </caption>
    <thead>
      <tr>
        <xsl:call-template name="heads">
          <xsl:with-param name="of">c.of.tree;c.test;c.sensor;c.kind;c.sensor.height:m;
        c.readings:;c.sigma:;c.rms:;in.unit;c.neighbours:</xsl:with-param>
        </xsl:call-template>
      </tr>
    </thead>
    <tbody>
      <xsl:for-each select="$f/sensors/item">
        <tr>
          <td><xsl:value-of select="tree"/></td><td><xsl:value-of select="test"/></td><td><xsl:value-of select="sensor"/></td>
          <td>
            <xsl:call-template name="term">
              <xsl:with-param name="id" select="concat('sensor.', kind)"/><xsl:with-param name="otherwise" select="kind"/>
            </xsl:call-template>
          </td>
          <td class="r">
            <xsl:if test="height != ''">
              <xsl:call-template name="given"><xsl:with-param name="x" select="height"/></xsl:call-template>
            </xsl:if>
          </td>
          <td class="r"><xsl:value-of select="readings"/></td>
          <td class="r">
            <xsl:choose>
              <xsl:when test="estimated = 'true'">
                <xsl:call-template name="four"><xsl:with-param name="x" select="sigma"/></xsl:call-template> (e)</xsl:when>
              <xsl:otherwise><xsl:call-template name="given"><xsl:with-param name="x" select="sigma"/></xsl:call-template></xsl:otherwise>
            </xsl:choose>
          </td>
          <xsl:call-template name="four-cell"><xsl:with-param name="x" select="rms"/></xsl:call-template>
          <td><xsl:call-template name="unit-words"/></td>
          <xsl:call-template name="cell">
            <xsl:with-param name="x" select="correlation"/><xsl:with-param name="pattern">0.00</xsl:with-param>
          </xsl:call-template>
        </tr>
      </xsl:for-each>
    </tbody>
  </table>
</xsl:template>

<xsl:template name="sways">
  <table class="data">
    <xsl:call-template name="caption"><xsl:with-param name="id">ft.sways</xsl:with-param></xsl:call-template>
    <thead>
      <tr>
        <xsl:call-template name="heads">
          <xsl:with-param name="of">c.test;c.frequency.sway:Hz;c.plus:Hz;c.damping:%;c.plus:%;c.explained:%</xsl:with-param>
        </xsl:call-template>
      </tr>
    </thead>
    <tbody>
      <xsl:for-each select="$r/sways/item">
        <tr>
          <td><xsl:value-of select="test"/></td>
          <xsl:call-template name="cell">
            <xsl:with-param name="x" select="frequency"/><xsl:with-param name="pattern">0.0000</xsl:with-param>
          </xsl:call-template>
          <xsl:call-template name="cell">
            <xsl:with-param name="x" select="1.96 * frequency_sd"/><xsl:with-param name="pattern">0.0000</xsl:with-param>
          </xsl:call-template>
          <xsl:call-template name="cell">
            <xsl:with-param name="x" select="damping"/><xsl:with-param name="pattern">0.00</xsl:with-param>
          </xsl:call-template>
          <xsl:call-template name="cell">
            <xsl:with-param name="x" select="1.96 * damping_sd"/><xsl:with-param name="pattern">0.00</xsl:with-param>
          </xsl:call-template>
          <xsl:call-template name="cell"><xsl:with-param name="x" select="explained"/></xsl:call-template>
        </tr>
      </xsl:for-each>
    </tbody>
  </table>
</xsl:template>

<xsl:template name="method">
  <xsl:call-template name="h2"><xsl:with-param name="id">ft.h.method</xsl:with-param></xsl:call-template>
  <p>
    <xsl:call-template name="say"><xsl:with-param name="id">ft.method</xsl:with-param></xsl:call-template>
    <xsl:if test="$r/loss != 'none'">
      <xsl:value-of select="$gap"/>
      <xsl:call-template name="say">
        <xsl:with-param name="id">ft.method.loss</xsl:with-param>
        <xsl:with-param name="a" select="$r/loss"/>
      </xsl:call-template>
    </xsl:if>
    <xsl:if test="$r/priors = 'true'">
      <xsl:value-of select="$gap"/>
      <xsl:call-template name="say"><xsl:with-param name="id">ft.method.priors</xsl:with-param></xsl:call-template>
    </xsl:if>
    <xsl:if test="$f/starts &gt; 0">
      <xsl:value-of select="$gap"/>
      <xsl:call-template name="say">
        <xsl:with-param name="id">ft.method.starts</xsl:with-param>
        <xsl:with-param name="a" select="$f/starts"/><xsl:with-param name="b" select="$f/starts_same"/>
      </xsl:call-template>
    </xsl:if>
  </p>
  <table class="block">
    <xsl:call-template name="block-row">
      <xsl:with-param name="id">ft.trees</xsl:with-param>
      <xsl:with-param name="text">
        <xsl:for-each select="$r/trees/item">
          <xsl:if test="position() &gt; 1"><br/></xsl:if>
          <xsl:call-template name="say">
            <xsl:with-param name="id">ft.tree</xsl:with-param>
            <xsl:with-param name="a" select="name"/><xsl:with-param name="b" select="species"/>
            <xsl:with-param name="c">
              <xsl:call-template name="given"><xsl:with-param name="x" select="height"/></xsl:call-template>
            </xsl:with-param>
            <xsl:with-param name="d" select="segments"/>
          </xsl:call-template>
          <xsl:if test="rest">
            <xsl:call-template name="say"><xsl:with-param name="id" select="concat('ft.rest.', rest)"/></xsl:call-template>
          </xsl:if>
        </xsl:for-each>
      </xsl:with-param>
    </xsl:call-template>
  </table>
</xsl:template>

<xsl:template match="/report" mode="body">
  <xsl:call-template name="summary"/>
  <xsl:call-template name="not-looked"><xsl:with-param name="id">nl.calibration</xsl:with-param></xsl:call-template>
  <xsl:call-template name="findings"><xsl:with-param name="id">ft.h.beware</xsl:with-param></xsl:call-template>
  <xsl:if test="$r/note != ''">
    <xsl:call-template name="h2"><xsl:with-param name="id">ft.h.study</xsl:with-param></xsl:call-template>
    <p><xsl:value-of select="$r/note"/></p>
  </xsl:if>
  <xsl:if test="$r/source != ''">
    <p class="note">
      <xsl:call-template name="say">
        <xsl:with-param name="id">ft.source</xsl:with-param>
        <xsl:with-param name="a" select="$r/source"/>
      </xsl:call-template>
    </p>
  </xsl:if>
  <xsl:call-template name="h2"><xsl:with-param name="id">ft.h.estimates</xsl:with-param></xsl:call-template>
  <xsl:call-template name="estimates"/>
  <xsl:if test="count($f/parameters/item[nuisance = 'false']) &gt; 1"><xsl:call-template name="correlations"/></xsl:if>
  <xsl:call-template name="sensors"/>
  <xsl:if test="$r/sways/item"><xsl:call-template name="sways"/></xsl:if>
  <xsl:call-template name="h2"><xsl:with-param name="id">ft.h.readings</xsl:with-param></xsl:call-template>
  <xsl:call-template name="figure"><xsl:with-param name="name">fit_readings</xsl:with-param></xsl:call-template>
  <xsl:call-template name="figure"><xsl:with-param name="name">fit_residuals</xsl:with-param></xsl:call-template>
  <xsl:call-template name="h2"><xsl:with-param name="id">ft.h.profiles</xsl:with-param></xsl:call-template>
  <xsl:call-template name="figure"><xsl:with-param name="name">fit_profiles</xsl:with-param></xsl:call-template>
  <xsl:if test="$r/records &gt; 0">
    <xsl:call-template name="h2"><xsl:with-param name="id">ft.h.records</xsl:with-param></xsl:call-template>
    <xsl:call-template name="figure"><xsl:with-param name="name">fit_records</xsl:with-param></xsl:call-template>
  </xsl:if>
  <xsl:call-template name="method"/>
</xsl:template>
</xsl:stylesheet>
