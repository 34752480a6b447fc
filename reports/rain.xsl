<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- The page of rain on a branch: what ran, what the drops did, budgets, prisms against beam theory, speed. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform">
<xsl:import href="page.xsl"/>

<xsl:template match="/report" mode="title">
  <xsl:call-template name="say"><xsl:with-param name="id">rn.title</xsl:with-param></xsl:call-template>
</xsl:template>
<xsl:template match="/report" mode="sub">
  <xsl:variable name="run" select="$r/runs/item[1]"/>
  <xsl:choose>
    <xsl:when test="$lang = 'zh' and $run/species_zh != ''"><xsl:value-of select="normalize-space($run/species_zh)"/>，</xsl:when>
    <xsl:otherwise><xsl:value-of select="normalize-space($run/species)"/>, </xsl:otherwise>
  </xsl:choose>
  <xsl:call-template name="term">
    <xsl:with-param name="id" select="concat('rn.form.', $run/form)"/><xsl:with-param name="otherwise" select="$run/form"/>
  </xsl:call-template>
</xsl:template>

<xsl:template name="rain-runs">
  <table class="data">
    <xsl:call-template name="caption"><xsl:with-param name="id">rn.runs</xsl:with-param></xsl:call-template>
    <thead>
      <tr>
        <xsl:call-template name="heads">
          <xsl:with-param name="of">c.rn.run;c.rn.preset;c.rn.leaves:;c.rn.grid:;c.rn.hits:;
            c.rn.ran:;c.rn.merged:;c.rn.hung:;c.rn.fell:;c.rn.f:Hz;c.rn.speed:1/s</xsl:with-param>
        </xsl:call-template>
      </tr>
    </thead>
    <tbody>
      <xsl:for-each select="$r/runs/item">
        <tr>
          <td><xsl:value-of select="position()"/>&#160;<xsl:call-template name="term">
            <xsl:with-param name="id" select="concat('rn.name.', translate(name, ' ,', '--'))"/>
            <xsl:with-param name="otherwise" select="name"/></xsl:call-template></td>
          <td><xsl:call-template name="term">
            <xsl:with-param name="id" select="concat('rn.preset.', preset)"/>
            <xsl:with-param name="otherwise" select="preset"/></xsl:call-template></td>
          <xsl:for-each select="leaves | grid | hits | ran | merged | hung | fell">
            <xsl:sort select="string-length(substring-before('leaves grid hits ran merged hung fell ',
                concat(name(), ' ')))" data-type="number"/>
            <xsl:call-template name="count"><xsl:with-param name="x" select="."/></xsl:call-template>
          </xsl:for-each>
          <xsl:call-template name="n"><xsl:with-param name="x" select="frequency_Hz"/></xsl:call-template>
          <xsl:call-template name="cell">
            <xsl:with-param name="x" select="steps_a_second"/><xsl:with-param name="pattern">0</xsl:with-param>
          </xsl:call-template>
        </tr>
      </xsl:for-each>
    </tbody>
  </table>
</xsl:template>

<!-- the first leaf as it was taken -->
<xsl:template name="rain-leaf">
  <table class="data">
    <xsl:call-template name="caption"><xsl:with-param name="id">rn.leaf</xsl:with-param></xsl:call-template>
    <thead>
      <tr>
        <xsl:call-template name="heads">
          <xsl:with-param name="of">c.rn.run;c.rn.vein:mm;c.rn.area:cm²;c.rn.mass:mg;c.rn.petiole:mm;c.rn.thick:mm;
            c.rn.modulus:GPa;c.rn.angle:°;c.rn.receding:°;c.rn.advancing:°;c.rn.hanging:mg</xsl:with-param>
        </xsl:call-template>
      </tr>
    </thead>
    <tbody>
      <xsl:for-each select="$r/runs/item">
        <tr>
          <td><xsl:value-of select="position()"/></td>
          <xsl:call-template name="n"><xsl:with-param name="x" select="vein_mm"/></xsl:call-template>
          <xsl:call-template name="n"><xsl:with-param name="x" select="leaf_cm2"/></xsl:call-template>
          <xsl:call-template name="n"><xsl:with-param name="x" select="leaf_mg"/></xsl:call-template>
          <xsl:call-template name="n"><xsl:with-param name="x" select="petiole_mm"/></xsl:call-template>
          <xsl:call-template name="n"><xsl:with-param name="x" select="petiole_diameter_mm"/></xsl:call-template>
          <xsl:call-template name="n"><xsl:with-param name="x" select="petiole_GPa"/></xsl:call-template>
          <xsl:call-template name="n"><xsl:with-param name="x" select="contact_angle_deg"/></xsl:call-template>
          <xsl:call-template name="n"><xsl:with-param name="x" select="receding_deg"/></xsl:call-template>
          <xsl:call-template name="n"><xsl:with-param name="x" select="advancing_deg"/></xsl:call-template>
          <xsl:call-template name="n"><xsl:with-param name="x" select="hanging_mg"/></xsl:call-template>
        </tr>
      </xsl:for-each>
    </tbody>
  </table>
</xsl:template>

<!-- the four kinds of springs -->
<xsl:template name="rain-springs">
  <table class="data">
    <xsl:call-template name="caption"><xsl:with-param name="id">rn.springs</xsl:with-param></xsl:call-template>
    <thead>
      <tr>
        <xsl:call-template name="heads">
          <xsl:with-param name="of">c.rn.run;c.rn.kind;c.rn.number:;c.rn.lowest:N/m;c.rn.highest:N/m</xsl:with-param>
        </xsl:call-template>
      </tr>
    </thead>
    <tbody>
      <xsl:for-each select="$r/runs/item">
        <xsl:variable name="n" select="position()"/>
        <xsl:for-each select="spring_kinds/item">
          <tr>
            <td><xsl:value-of select="$n"/></td>
            <td><xsl:call-template name="say"><xsl:with-param name="id" select="concat('rn.kind.', name)"/></xsl:call-template></td>
            <xsl:call-template name="count"><xsl:with-param name="x" select="number"/></xsl:call-template>
            <xsl:call-template name="n"><xsl:with-param name="x" select="low"/></xsl:call-template>
            <xsl:call-template name="n"><xsl:with-param name="x" select="high"/></xsl:call-template>
          </tr>
        </xsl:for-each>
      </xsl:for-each>
    </tbody>
  </table>
</xsl:template>

<!-- springs without a law for their constants -->
<xsl:template name="rain-order">
  <xsl:call-template name="h2"><xsl:with-param name="id">rn.order.h</xsl:with-param></xsl:call-template>
  <table class="data">
    <xsl:call-template name="caption">
      <xsl:with-param name="id">rn.order</xsl:with-param>
      <xsl:with-param name="a">
          <xsl:call-template name="given"><xsl:with-param name="x" select="$r/order_N_m"/></xsl:call-template>
        </xsl:with-param>
    </xsl:call-template>
    <thead>
      <tr>
        <xsl:call-template name="heads">
          <xsl:with-param name="of"
                        select="'c.rn.prisms:;c.rn.restoring:N/m;c.rn.sag:%;c.rn.fold:°;c.rn.strain:%;c.rn.back:s;c.rn.left:%'"/>
        </xsl:call-template>
      </tr>
    </thead>
    <tbody>
      <xsl:for-each select="$r/order/item">
        <tr>
          <xsl:call-template name="count"><xsl:with-param name="x" select="prisms"/></xsl:call-template>
          <xsl:call-template name="count"><xsl:with-param name="x" select="restoring"/></xsl:call-template>
          <xsl:for-each select="sag_percent | fold_deg | strain_percent">
            <xsl:sort data-type="number"
                    select="string-length(substring-before('sag_percent fold_deg strain_percent ', concat(name(), ' ')))"/>
            <xsl:call-template name="cell">
              <xsl:with-param name="x" select="."/><xsl:with-param name="pattern">0.0</xsl:with-param>
            </xsl:call-template>
          </xsl:for-each>
          <xsl:call-template name="n"><xsl:with-param name="x" select="back"/></xsl:call-template>
          <xsl:call-template name="cell">
            <xsl:with-param name="x" select="left_percent"/><xsl:with-param name="pattern">0.0</xsl:with-param>
          </xsl:call-template>
        </tr>
      </xsl:for-each>
    </tbody>
  </table>
  <xsl:call-template name="figure"><xsl:with-param name="name">rain_order</xsl:with-param></xsl:call-template>
</xsl:template>

<xsl:template name="rain-run">
  <xsl:variable name="run" select="."/>
  <xsl:variable name="n" select="position()"/>
  <h2><xsl:call-template name="term">
    <xsl:with-param name="id" select="concat('rn.name.', translate(name, ' ,', '--'))"/>
    <xsl:with-param name="otherwise" select="name"/></xsl:call-template></h2>
  <xsl:if test="string(number(ring_frequency_Hz)) != 'NaN'">
    <p>
      <xsl:call-template name="say">
        <xsl:with-param name="id">rn.ring</xsl:with-param>
        <xsl:with-param name="a" select="format-number(ring_frequency_Hz, '0.00')"/>
        <xsl:with-param name="b" select="format-number(ring_decrement, '0.000')"/>
        <xsl:with-param name="c" select="format-number(decrement, '0.000')"/>
        <xsl:with-param name="d" select="format-number(frequency_Hz, '0.00')"/>
      </xsl:call-template>
    </p>
  </xsl:if>
  <xsl:for-each select="/report/figures/figure[substring(@name,
      string-length(@name) - string-length(concat('_', $n)) + 1) = concat('_', $n)][position() &lt;= 2]">
    <xsl:call-template name="figure">
      <xsl:with-param name="name" select="@name"/>
      <xsl:with-param name="id" select="concat('cap.', substring(@name, 1, string-length(@name) - string-length(concat('_', $n))))"/>
    </xsl:call-template>
  </xsl:for-each>
  <table class="data">
    <xsl:call-template name="caption">
      <xsl:with-param name="id">rn.budget</xsl:with-param>
      <xsl:with-param name="a"><xsl:call-template name="tiny">
        <xsl:with-param name="x" select="water_off"/></xsl:call-template></xsl:with-param>
      <xsl:with-param name="b"><xsl:call-template name="tiny">
        <xsl:with-param name="x" select="energy_off"/></xsl:call-template></xsl:with-param>
    </xsl:call-template>
    <thead><tr>
      <xsl:for-each select="budget/item[of = 'water']">
        <th class="r"><xsl:call-template name="say"><xsl:with-param name="id" select="concat('rn.water.', term)"/></xsl:call-template>
          <span class="u">mg</span></th>
      </xsl:for-each></tr></thead>
    <tbody><tr>
      <xsl:for-each select="budget/item[of = 'water']">
        <xsl:call-template name="n"><xsl:with-param name="x" select="value"/></xsl:call-template>
      </xsl:for-each></tr></tbody>
  </table>
  <table class="data">
    <thead><tr>
      <xsl:for-each select="budget/item[of = 'energy']">
        <th class="r"><xsl:call-template name="say"><xsl:with-param name="id" select="concat('rn.energy.', term)"/></xsl:call-template>
          <span class="u">µJ</span></th>
      </xsl:for-each></tr></thead>
    <tbody><tr>
      <xsl:for-each select="budget/item[of = 'energy']">
        <xsl:call-template name="n"><xsl:with-param name="x" select="value"/></xsl:call-template>
      </xsl:for-each></tr></tbody>
  </table>
  <xsl:for-each select="/report/figures/figure[substring(@name,
      string-length(@name) - string-length(concat('_', $n)) + 1) = concat('_', $n)][position() &gt; 2]">
    <xsl:call-template name="figure">
      <xsl:with-param name="name" select="@name"/>
      <xsl:with-param name="id" select="concat('cap.', substring(@name, 1, string-length(@name) - string-length(concat('_', $n))))"/>
    </xsl:call-template>
  </xsl:for-each>
</xsl:template>

<xsl:template match="item" mode="run">
  <xsl:value-of select="concat(count(preceding-sibling::item) + 1, '. ')"/>
  <xsl:call-template name="term">
    <xsl:with-param name="id" select="concat('rn.name.', translate(name, ' ,', '--'))"/><xsl:with-param name="otherwise" select="name"/>
  </xsl:call-template>
</xsl:template>

<!-- The key frames one after the other, for the screen alone; hidden until its script runs. -->
<xsl:template name="play">
  <section id="live" class="live" hidden="hidden">
    <xsl:call-template name="live-frames"><xsl:with-param name="switch" select="true()"/></xsl:call-template>
    <div class="stage"></div>
    <div class="cols">
      <div class="col">
        <table class="block" aria-live="polite">
          <xsl:call-template name="live-row"><xsl:with-param name="key">time</xsl:with-param>
            <xsl:with-param name="unit">s</xsl:with-param></xsl:call-template>
          <xsl:call-template name="live-row"><xsl:with-param name="key">event</xsl:with-param>
            <xsl:with-param name="id">lv.rn.event</xsl:with-param></xsl:call-template>
          <xsl:call-template name="live-row"><xsl:with-param name="key">leaf</xsl:with-param>
            <xsl:with-param name="id">lv.rn.leaf</xsl:with-param></xsl:call-template>
          <xsl:call-template name="live-row"><xsl:with-param name="key">drops</xsl:with-param>
            <xsl:with-param name="id">lv.rn.drops</xsl:with-param></xsl:call-template>
          <xsl:call-template name="live-row"><xsl:with-param name="key">held</xsl:with-param>
            <xsl:with-param name="id">lv.rn.held</xsl:with-param><xsl:with-param name="unit">mg</xsl:with-param></xsl:call-template>
          <xsl:call-template name="live-row"><xsl:with-param name="key">film</xsl:with-param>
            <xsl:with-param name="id">lv.rn.film</xsl:with-param><xsl:with-param name="unit">mg</xsl:with-param></xsl:call-template>
          <xsl:call-template name="live-row"><xsl:with-param name="key">fell</xsl:with-param>
            <xsl:with-param name="id">lv.rn.fell</xsl:with-param><xsl:with-param name="unit">mg</xsl:with-param></xsl:call-template>
          <xsl:call-template name="live-row"><xsl:with-param name="key">tip</xsl:with-param>
            <xsl:with-param name="id">lv.rn.tip</xsl:with-param><xsl:with-param name="unit">mm</xsl:with-param></xsl:call-template>
          <xsl:call-template name="live-row"><xsl:with-param name="key">moment</xsl:with-param>
            <xsl:with-param name="id">lv.rn.moment</xsl:with-param><xsl:with-param name="unit">mN m</xsl:with-param></xsl:call-template>
        </table>
      </div>
      <div class="col picture">
        <p><label><input type="checkbox" class="way" checked="checked"/><xsl:text> </xsl:text>
          <xsl:call-template name="say"><xsl:with-param name="id">lv.rn.way</xsl:with-param></xsl:call-template></label></p>
        <p class="note times" aria-live="polite"><xsl:attribute name="data-words">
          <xsl:call-template name="say"><xsl:with-param name="id">lv.rn.times</xsl:with-param></xsl:call-template>
        </xsl:attribute></p>
        <p class="note"><xsl:call-template name="say"><xsl:with-param name="id">lv.rn.note</xsl:with-param></xsl:call-template></p>
        <xsl:for-each select="$strings/s[starts-with(@id, 'lv.rn.e.')]">
          <span hidden="hidden" data-event="{substring-after(@id, 'lv.rn.e.')}"><xsl:value-of select="*[name() = $lang]"/></span>
        </xsl:for-each>
      </div>
    </div>
  </section>
</xsl:template>

<!-- "2.1e-16" as it is written by the program, or a plain 0. -->
<xsl:template name="tiny">
  <xsl:param name="x"/>
  <xsl:choose>
    <xsl:when test="$x = 0">0</xsl:when>
    <xsl:when test="$x &lt; 0.00000000000001">&lt; 1e-14</xsl:when>
    <xsl:when test="$x &lt; 0.000000000001">&lt; 1e-12</xsl:when>
    <xsl:when test="$x &lt; 0.0000000001">&lt; 1e-10</xsl:when>
    <xsl:when test="$x &lt; 0.000000001">&lt; 1e-9</xsl:when>
    <xsl:when test="$x &lt; 0.000001">&lt; 1e-6</xsl:when>
    <xsl:otherwise><xsl:call-template name="number"><xsl:with-param name="x" select="$x"/></xsl:call-template></xsl:otherwise>
  </xsl:choose>
</xsl:template>

<xsl:template name="rain-prisms">
  <xsl:call-template name="h2"><xsl:with-param name="id">rn.prisms.h</xsl:with-param></xsl:call-template>
  <table class="data">
    <xsl:call-template name="caption">
      <xsl:with-param name="id">rn.prisms</xsl:with-param>
      <xsl:with-param name="a"><xsl:call-template name="given">
        <xsl:with-param name="x" select="$r/restoring_N_m"/></xsl:call-template></xsl:with-param>
    </xsl:call-template>
    <thead><tr><xsl:call-template name="heads">
      <xsl:with-param name="of">c.rn.prisms:;c.rn.tip:%;c.rn.twist:%;c.rn.f1:%;c.rn.held:–;c.rn.quick:–</xsl:with-param>
    </xsl:call-template></tr></thead>
    <tbody>
      <xsl:for-each select="$r/prisms/item">
        <tr>
          <xsl:call-template name="count"><xsl:with-param name="x" select="prisms"/></xsl:call-template>
          <xsl:call-template name="n"><xsl:with-param name="x" select="tip_percent"/></xsl:call-template>
          <xsl:call-template name="n"><xsl:with-param name="x" select="twist_percent"/></xsl:call-template>
          <xsl:call-template name="n"><xsl:with-param name="x" select="frequency_percent"/></xsl:call-template>
          <xsl:call-template name="n"><xsl:with-param name="x" select="with_restoring"/></xsl:call-template>
          <xsl:call-template name="n"><xsl:with-param name="x" select="frequency_with_restoring"/></xsl:call-template>
        </tr>
      </xsl:for-each>
    </tbody>
  </table>
  <xsl:call-template name="figure"><xsl:with-param name="name">rain_prisms</xsl:with-param></xsl:call-template>
</xsl:template>

<xsl:template name="rain-speeds">
  <xsl:call-template name="h2"><xsl:with-param name="id">rn.speed.h</xsl:with-param></xsl:call-template>
  <table class="data">
    <xsl:call-template name="caption"><xsl:with-param name="id">rn.speeds</xsl:with-param></xsl:call-template>
    <thead><tr><xsl:call-template name="heads">
      <xsl:with-param name="of">c.rn.scene:;c.rn.leaves:;c.rn.vertices:;c.rn.facets:;
        c.rn.grid:;c.rn.drops:;c.rn.paper:1/s;c.rn.speed:1/s;c.rn.ratio:–</xsl:with-param>
    </xsl:call-template></tr></thead>
    <tbody>
      <xsl:for-each select="$r/speeds/item">
        <tr>
          <xsl:for-each select="scene | leaves | vertices | facets | grid | drops">
            <xsl:sort select="string-length(substring-before('scene leaves vertices facets grid drops ',
                concat(name(), ' ')))" data-type="number"/>
            <xsl:call-template name="count"><xsl:with-param name="x" select="."/></xsl:call-template>
          </xsl:for-each>
          <xsl:call-template name="n"><xsl:with-param name="x" select="paper"/></xsl:call-template>
          <xsl:call-template name="n"><xsl:with-param name="x" select="steps"/></xsl:call-template>
          <xsl:call-template name="n"><xsl:with-param name="x" select="steps div paper"/></xsl:call-template>
        </tr>
      </xsl:for-each>
    </tbody>
  </table>
</xsl:template>

<xsl:template match="/report" mode="body">
  <div class="summary">
    <xsl:for-each select="$r/runs/item">
      <p>
        <xsl:call-template name="say">
          <xsl:with-param name="id">rn.summary</xsl:with-param>
          <xsl:with-param name="a"><xsl:call-template name="term">
            <xsl:with-param name="id" select="concat('rn.name.', translate(name, ' ,', '--'))"/>
            <xsl:with-param name="otherwise" select="name"/></xsl:call-template></xsl:with-param>
          <xsl:with-param name="b" select="hits"/><xsl:with-param name="c" select="merged"/><xsl:with-param name="d" select="fell"/>
          <xsl:with-param name="e"><xsl:call-template name="number">
            <xsl:with-param name="x" select="frequency_Hz"/></xsl:call-template></xsl:with-param>
        </xsl:call-template>
      </p>
    </xsl:for-each>
  </div>
  <xsl:call-template name="not-looked"><xsl:with-param name="id">nl.rain</xsl:with-param></xsl:call-template>
  <xsl:if test="script"><xsl:call-template name="play"/></xsl:if>
  <xsl:call-template name="rain-runs"/>
  <xsl:call-template name="rain-leaf"/>
  <xsl:for-each select="$r/runs/item"><xsl:call-template name="rain-run"/></xsl:for-each>
  <xsl:call-template name="rain-prisms"/>
  <xsl:call-template name="rain-springs"/>
  <xsl:if test="$r/order/item"><xsl:call-template name="rain-order"/></xsl:if>
  <xsl:call-template name="figure"><xsl:with-param name="name">rain_falls</xsl:with-param></xsl:call-template>
  <xsl:if test="$r/clusters">
    <xsl:call-template name="figure">
      <xsl:with-param name="name">rain_clusters</xsl:with-param>
      <xsl:with-param name="a" select="$r/clusters/points"/><xsl:with-param name="b" select="$r/clusters/number"/>
    </xsl:call-template>
  </xsl:if>
  <xsl:if test="$r/speeds/item"><xsl:call-template name="rain-speeds"/></xsl:if>
  <xsl:call-template name="findings"/>
</xsl:template>
</xsl:stylesheet>
