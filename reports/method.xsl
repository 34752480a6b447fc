<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- Method and limits, warnings, provenance. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform">

<xsl:template name="solver-title">
  <xsl:call-template name="term">
    <xsl:with-param name="id" select="concat('solver.', name)"/><xsl:with-param name="otherwise" select="title"/>
  </xsl:call-template>
  <xsl:value-of select="concat(' (', name, ')')"/>
</xsl:template>

<xsl:template name="stripped">
  <xsl:param name="text"/>
  <xsl:choose>
    <xsl:when test="substring($text, string-length($text)) = '.'">
      <xsl:value-of select="substring($text, 1, string-length($text) - 1)"/>
    </xsl:when>
    <xsl:otherwise><xsl:value-of select="$text"/></xsl:otherwise>
  </xsl:choose>
</xsl:template>

<!-- source and range of one row of methods; the sentences end in one full stop whatever the row ends in -->
<xsl:template name="source-and-range">
  <xsl:if test="source != ''">
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
      <xsl:with-param name="id">m.source</xsl:with-param>
      <xsl:with-param name="a">
        <xsl:call-template name="stripped"><xsl:with-param name="text" select="source"/></xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
  </xsl:if>
  <xsl:if test="validity != ''">
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
      <xsl:with-param name="id">m.validity</xsl:with-param>
      <xsl:with-param name="a">
        <xsl:call-template name="stripped"><xsl:with-param name="text"><xsl:call-template name="term">
          <xsl:with-param name="id" select="concat('valid.', name(), '.', name)"/><xsl:with-param name="otherwise" select="validity"/>
        </xsl:call-template></xsl:with-param></xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
  </xsl:if>
</xsl:template>

<xsl:template name="note">
  <xsl:param name="id"/><xsl:param name="text"/>
  <dt><xsl:call-template name="say"><xsl:with-param name="id" select="$id"/></xsl:call-template></dt>
  <dd><xsl:copy-of select="$text"/></dd>
</xsl:template>

<xsl:template name="method">
  <dl>
    <xsl:call-template name="note">
      <xsl:with-param name="id">m.solver</xsl:with-param>
      <xsl:with-param name="text">
        <xsl:for-each select="$trees[1]/method/solver">
          <b><xsl:call-template name="solver-title"/></b>
          <xsl:call-template name="say"><xsl:with-param name="id">dot</xsl:with-param></xsl:call-template>
          <xsl:call-template name="source-and-range"/>
        </xsl:for-each>
        <xsl:for-each select="$trees/winds/item/imbalance/value[. != '']">
          <xsl:sort select="." data-type="number" order="descending"/>
          <xsl:if test="position() = 1">
            <xsl:value-of select="$gap"/>
            <xsl:call-template name="say">
              <xsl:with-param name="id">m.balance</xsl:with-param>
              <xsl:with-param name="a">
                <xsl:call-template name="tiny"><xsl:with-param name="x" select="."/></xsl:call-template>
              </xsl:with-param>
            </xsl:call-template>
          </xsl:if>
        </xsl:for-each>
      </xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="note">
      <xsl:with-param name="id">m.profile</xsl:with-param>
      <xsl:with-param name="text">
        <xsl:for-each select="$trees[1]/method/wind_profile">
          <b><xsl:call-template name="term">
            <xsl:with-param name="id" select="concat('m.profile.', name)"/><xsl:with-param name="otherwise" select="name"/>
          </xsl:call-template></b>
          <xsl:call-template name="say"><xsl:with-param name="id">dot</xsl:with-param></xsl:call-template>
          <xsl:call-template name="source-and-range"/>
        </xsl:for-each>
      </xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="note">
      <xsl:with-param name="id">m.peak</xsl:with-param>
      <xsl:with-param name="text"><xsl:call-template name="peak-method"/></xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="note">
      <xsl:with-param name="id">m.crown</xsl:with-param>
      <xsl:with-param name="text">
        <!-- a tree with neither leaves nor a crown's area has no crown that a law could bend -->
        <xsl:variable name="crowned" select="$trees[model/leaf_area/value &gt; 0 or model/frontal_area/value &gt; 0]"/>
        <xsl:if test="not($crowned)">
          <xsl:call-template name="say"><xsl:with-param name="id">m.crown.none</xsl:with-param></xsl:call-template>
        </xsl:if>
        <xsl:for-each select="$crowned[not(method/streamlining/name =
          preceding-sibling::item[model/leaf_area/value &gt; 0 or model/frontal_area/value &gt; 0]/method/streamlining/name)]
          /method/streamlining">
          <xsl:if test="position() &gt; 1"><br/></xsl:if>
          <b>
            <xsl:call-template name="term">
              <xsl:with-param name="id" select="concat('streamlining.', name)"/><xsl:with-param name="otherwise" select="name"/>
            </xsl:call-template>
          </b>
          <xsl:call-template name="say"><xsl:with-param name="id">dot</xsl:with-param></xsl:call-template>
          <xsl:call-template name="source-and-range"/>
        </xsl:for-each>
      </xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="note">
      <xsl:with-param name="id">m.axis</xsl:with-param>
      <xsl:with-param name="text">
        <xsl:call-template name="say"><xsl:with-param name="id">m.axis.text</xsl:with-param></xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="note">
      <xsl:with-param name="id">m.break</xsl:with-param>
      <xsl:with-param name="text">
        <xsl:call-template name="say"><xsl:with-param name="id">m.break.text</xsl:with-param></xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="note">
      <xsl:with-param name="id">m.words</xsl:with-param>
      <xsl:with-param name="text">
        <xsl:call-template name="say"><xsl:with-param name="id">m.words.text</xsl:with-param></xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
  </dl>
</xsl:template>

<!-- 3e-12 as 3 × 10⁻¹²: the power of ten is counted down -->
<xsl:template name="tiny">
  <xsl:param name="x"/><xsl:param name="power" select="0"/>
  <xsl:choose>
    <xsl:when test="$x = 0">0</xsl:when>
    <xsl:when test="$x &gt;= 0.95 or $power &gt; 30">
      <xsl:value-of select="round($x)"/>
      <xsl:if test="$power &gt; 0">
        <xsl:text>&#160;×&#160;10⁻</xsl:text><xsl:value-of select="translate($power, '0123456789', '⁰¹²³⁴⁵⁶⁷⁸⁹')"/>
      </xsl:if>
    </xsl:when>
    <xsl:otherwise>
      <xsl:call-template name="tiny">
        <xsl:with-param name="x" select="$x * 10"/><xsl:with-param name="power" select="$power + 1"/>
      </xsl:call-template>
    </xsl:otherwise>
  </xsl:choose>
</xsl:template>

<xsl:template name="warnings">
  <xsl:choose>
    <xsl:when test="not($warned)">
      <p><xsl:call-template name="say"><xsl:with-param name="id">w.none</xsl:with-param></xsl:call-template></p>
    </xsl:when>
    <xsl:otherwise>
      <table class="data">
        <thead>
          <tr>
            <th><xsl:call-template name="say"><xsl:with-param name="id">w.kind</xsl:with-param></xsl:call-template></th>
            <th><xsl:call-template name="say"><xsl:with-param name="id">w.what</xsl:with-param></xsl:call-template></th>
          </tr>
        </thead>
        <tbody class="long">
          <xsl:for-each select="$warned">
            <tr>
              <td style="width: 34mm">
                <xsl:call-template name="term">
                  <xsl:with-param name="id" select="concat('warn.', code)"/><xsl:with-param name="otherwise" select="code"/>
                </xsl:call-template>
              </td>
              <td><xsl:call-template name="warning"/></td>
            </tr>
          </xsl:for-each>
        </tbody>
      </table>
    </xsl:otherwise>
  </xsl:choose>
</xsl:template>

<!-- From the mean wind to the peak load: the method, and at the highest wind what it was computed from. -->
<xsl:template name="peak-method">
  <xsl:for-each select="$trees[1]/method/peak_method">
    <b>
      <xsl:call-template name="term">
        <xsl:with-param name="id" select="concat('peak.', name)"/><xsl:with-param name="otherwise" select="title"/>
      </xsl:call-template>
    </b>
    <xsl:call-template name="say"><xsl:with-param name="id">dot</xsl:with-param></xsl:call-template>
    <xsl:call-template name="source-and-range"/>
  </xsl:for-each>
  <xsl:for-each select="$trees[winds/item[last()]/peak/sway_frequency/value != '']">
    <br/>
    <xsl:variable name="p" select="winds/item[last()]/peak"/>
    <xsl:call-template name="say">
      <xsl:with-param name="id">m.peak.numbers</xsl:with-param>
      <xsl:with-param name="a"><xsl:call-template name="name"/></xsl:with-param>
      <xsl:with-param name="b">
        <xsl:call-template name="given"><xsl:with-param name="x" select="winds/item[last()]/speed/value"/></xsl:call-template>
      </xsl:with-param>
      <xsl:with-param name="c" select="format-number($p/load_factor_gusts/value, '0.00')"/>
      <xsl:with-param name="d">
        <xsl:call-template name="number"><xsl:with-param name="x" select="$p/sway_frequency/value"/></xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
    <xsl:value-of select="$gap"/>
    <xsl:call-template name="say">
      <xsl:with-param name="id">m.peak.more</xsl:with-param>
      <xsl:with-param name="a" select="format-number($p/damping_total/value, '0.000')"/>
      <xsl:with-param name="b" select="format-number($p/turbulence/value, '0.000')"/>
      <xsl:with-param name="c" select="format-number($p/background/value, '0.000')"/>
      <xsl:with-param name="d" select="format-number($p/resonance/value, '0.000')"/>
    </xsl:call-template>
    <xsl:if test="$p/load_factor_branches/value != ''">
      <xsl:value-of select="$gap"/>
      <xsl:call-template name="say">
        <xsl:with-param name="id">m.peak.branches</xsl:with-param>
        <xsl:with-param name="a" select="format-number($p/load_factor_branches/value, '0.00')"/>
      </xsl:call-template>
    </xsl:if>
  </xsl:for-each>
</xsl:template>

<xsl:template name="provenance">
  <table class="block">
    <xsl:call-template name="block-row">
      <xsl:with-param name="id">tb.program</xsl:with-param>
      <xsl:with-param name="text" select="concat($r/provenance/program, ' ', $r/provenance/version)"/>
    </xsl:call-template>
    <xsl:call-template name="block-row">
      <xsl:with-param name="id">tb.date</xsl:with-param><xsl:with-param name="text" select="string($r/provenance/date)"/>
    </xsl:call-template>
    <xsl:call-template name="block-row">
      <xsl:with-param name="id">p.seed</xsl:with-param>
      <xsl:with-param name="text">
        <xsl:choose>
          <xsl:when test="$r/provenance/seed != ''"><xsl:value-of select="$r/provenance/seed"/></xsl:when>
          <xsl:when test="$trees/interval/seed != ''"><xsl:value-of select="$trees/interval/seed"/></xsl:when>
          <xsl:when test="$trees/model/seed != ''">
            <xsl:call-template name="say">
              <xsl:with-param name="id">p.seed.model</xsl:with-param>
              <xsl:with-param name="a" select="$trees[model/seed != ''][1]/model/seed"/>
            </xsl:call-template>
          </xsl:when>
          <xsl:otherwise>
            <xsl:call-template name="say"><xsl:with-param name="id">p.seed.none</xsl:with-param></xsl:call-template>
          </xsl:otherwise>
        </xsl:choose>
      </xsl:with-param>
    </xsl:call-template>
  </table>
  <table class="data whole">
    <thead>
      <tr>
        <th><xsl:call-template name="say"><xsl:with-param name="id">p.role</xsl:with-param></xsl:call-template></th>
        <th><xsl:call-template name="say"><xsl:with-param name="id">p.file</xsl:with-param></xsl:call-template></th>
        <th><xsl:call-template name="say"><xsl:with-param name="id">p.hash</xsl:with-param></xsl:call-template></th>
      </tr>
    </thead>
    <tbody>
      <xsl:for-each select="$r/provenance/files/item">
        <tr>
          <td>
            <xsl:call-template name="term">
              <xsl:with-param name="id" select="concat('role.', role)"/><xsl:with-param name="otherwise" select="role"/>
            </xsl:call-template>
          </td>
          <td><code><xsl:call-template name="base-name"><xsl:with-param name="path" select="path"/></xsl:call-template></code></td>
          <td class="hash"><xsl:value-of select="sha256"/></td>
        </tr>
      </xsl:for-each>
    </tbody>
  </table>
  <p class="note"><xsl:call-template name="say"><xsl:with-param name="id">p.tables</xsl:with-param></xsl:call-template></p>
</xsl:template>
</xsl:stylesheet>
