<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- What went in: every value with range, standing and source; tree models and wind; the list of sources. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform">

<!-- every source named by an input, once; its number is its place in this list -->
<xsl:key name="source" match="/report/results/trees/item/species//*[not(used = 'false')]/source[. != '']" use="."/>
<xsl:variable name="sources" select="$trees/species//*[not(used = 'false')]/source[. != ''][generate-id() =
  generate-id(key('source', .)[1])]"/>

<xsl:template name="cite">
  <xsl:param name="source"/>
  <xsl:if test="$source != ''">
    <xsl:for-each select="$sources">
      <xsl:if test=". = $source"><a href="#source{position()}">[<xsl:value-of select="position()"/>]</a></xsl:if>
    </xsl:for-each>
  </xsl:if>
</xsl:template>

<xsl:template name="standing">
  <xsl:variable name="status">
    <xsl:choose>
      <xsl:when test="given = 'false'">default</xsl:when><xsl:otherwise><xsl:value-of select="status"/></xsl:otherwise>
    </xsl:choose>
  </xsl:variable>
  <td>
    <xsl:if test="$status != 'measured' and $status != 'handbook'"><xsl:attribute name="class">doubt</xsl:attribute></xsl:if>
    <xsl:call-template name="say"><xsl:with-param name="id" select="concat('status.', $status)"/></xsl:call-template>
  </td>
  <td class="r"><xsl:call-template name="cite"><xsl:with-param name="source" select="source"/></xsl:call-template></td>
</xsl:template>

<xsl:template name="part">
  <xsl:param name="level"/>
  <xsl:call-template name="term">
    <xsl:with-param name="id" select="concat('level.', $level)"/><xsl:with-param name="otherwise" select="$level"/>
  </xsl:call-template>
</xsl:template>

<xsl:template name="scaled">
  <xsl:param name="x"/><xsl:param name="factor"/>
  <xsl:choose>
    <xsl:when test="$x = ''">–</xsl:when>
    <!-- a default worked out by the program has more digits than it is good for -->
    <xsl:when test="given = 'false'">
      <xsl:call-template name="number"><xsl:with-param name="x" select="$x * $factor"/></xsl:call-template>
    </xsl:when>
    <xsl:otherwise>
      <xsl:call-template name="given"><xsl:with-param name="x" select="$x * $factor"/></xsl:call-template>
    </xsl:otherwise>
  </xsl:choose>
</xsl:template>

<xsl:template name="value-note">
  <xsl:if test="note != ''">
    <span class="why"><xsl:call-template name="fine"><xsl:with-param name="text" select="note"/></xsl:call-template></span>
  </xsl:if>
</xsl:template>

<!-- A row of one value. What is not given and has no default but a law is said in words. -->
<xsl:template match="item" mode="value">
  <!-- results written before there was a key have the old name in `quantity` alone -->
  <xsl:variable name="id" select="key | quantity[not(../key)]"/>
  <xsl:variable name="factor">
    <xsl:for-each select="$strings"><xsl:value-of select="key('string', $id)/@factor"/></xsl:for-each>
  </xsl:variable>
  <xsl:variable name="unit">
    <xsl:for-each select="$strings"><xsl:value-of select="key('string', $id)/@unit"/></xsl:for-each>
  </xsl:variable>
  <tr>
    <td>
      <xsl:if test="position() = 1">
        <xsl:call-template name="part"><xsl:with-param name="level" select="level"/></xsl:call-template>
      </xsl:if>
    </td>
    <td>
      <xsl:call-template name="term">
        <xsl:with-param name="id" select="$id"/><xsl:with-param name="otherwise" select="$id"/>
      </xsl:call-template>
      <xsl:call-template name="value-note"/>
    </td>
    <xsl:choose>
      <xsl:when test="value = ''">
        <td class="weak" colspan="3">
          <xsl:call-template name="say">
            <xsl:with-param name="id">
              <xsl:choose>
                <xsl:when test="$id = 'drag_coefficient'">in.reynolds</xsl:when><xsl:otherwise>in.none</xsl:otherwise>
              </xsl:choose>
            </xsl:with-param>
          </xsl:call-template>
        </td>
        <td></td><td></td>
      </xsl:when>
      <xsl:otherwise>
        <td class="r">
          <xsl:call-template name="scaled">
            <xsl:with-param name="x" select="value"/><xsl:with-param name="factor" select="$factor"/>
          </xsl:call-template>
        </td>
        <td class="r">
          <xsl:if test="low != '' and high != '' and low != high"><xsl:call-template name="scaled">
            <xsl:with-param name="x" select="low"/><xsl:with-param name="factor" select="$factor"/>
            </xsl:call-template> … <xsl:call-template name="scaled"><xsl:with-param name="x" select="high"/>
            <xsl:with-param name="factor" select="$factor"/></xsl:call-template></xsl:if>
        </td>
        <td class="unit"><xsl:value-of select="$unit"/></td>
        <xsl:call-template name="standing"/>
      </xsl:otherwise>
    </xsl:choose>
  </tr>
</xsl:template>

<xsl:template match="item" mode="wall">
  <tr>
    <td></td>
    <td>
      <xsl:call-template name="say"><xsl:with-param name="id">in.wall</xsl:with-param></xsl:call-template>
      <xsl:call-template name="value-note"/>
    </td>
    <td colspan="3">
      <xsl:for-each select="share/item"><xsl:variable name="p" select="position()"/>
      <xsl:if test="$p &gt; 1">; </xsl:if><xsl:call-template name="given"><xsl:with-param name="x" select="."/>
        </xsl:call-template> (<xsl:call-template name="given"><xsl:with-param name="x" select="100 * ../../at/item[$p]"/>
        </xsl:call-template> %)</xsl:for-each>
    </td>
    <xsl:call-template name="standing"/>
  </tr>
</xsl:template>

<xsl:template match="streamlining" mode="value">
  <tr>
    <td></td>
    <td><xsl:call-template name="say"><xsl:with-param name="id">in.streamlining</xsl:with-param></xsl:call-template></td>
    <td colspan="4">
      <xsl:variable name="law">
        <xsl:call-template name="term">
          <xsl:with-param name="id" select="concat('streamlining.', law)"/><xsl:with-param name="otherwise" select="law"/>
        </xsl:call-template>
      </xsl:variable>
      <xsl:choose>
        <xsl:when test="number(reference_speed/value) = number(reference_speed/value)">
          <xsl:call-template name="say">
            <xsl:with-param name="id">in.streamlining.from</xsl:with-param><xsl:with-param name="a" select="$law"/>
            <xsl:with-param name="b">
              <xsl:call-template name="given"><xsl:with-param name="x" select="reference_speed/value"/></xsl:call-template>
            </xsl:with-param>
          </xsl:call-template>
        </xsl:when>
        <xsl:otherwise><xsl:value-of select="$law"/></xsl:otherwise>
      </xsl:choose>
      <xsl:for-each select="table_share/item"><xsl:variable name="p" select="position()"/><xsl:choose>
        <xsl:when test="$p &gt; 1">; </xsl:when><xsl:otherwise>: </xsl:otherwise></xsl:choose>
        <xsl:call-template name="given"><xsl:with-param name="x" select="."/>
          </xsl:call-template> (<xsl:call-template name="given"><xsl:with-param name="x"
          select="../../table_speed_m_s/item[$p]"/></xsl:call-template> m/s)</xsl:for-each>
    </td>
    <td class="r"><xsl:call-template name="cite"><xsl:with-param name="source" select="source"/></xsl:call-template></td>
  </tr>
</xsl:template>

<xsl:template name="species-table">
  <table class="data inputs">
    <xsl:call-template name="table-caption">
      <xsl:with-param name="n" select="position() + 2 + count($trees[1]/directions[number])"/>
      <xsl:with-param name="text">
        <xsl:call-template name="say">
          <xsl:with-param name="id">in.species</xsl:with-param>
          <xsl:with-param name="a"><xsl:call-template name="name"/></xsl:with-param>
        </xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
    <thead>
      <tr>
        <th><xsl:call-template name="say"><xsl:with-param name="id">in.part</xsl:with-param></xsl:call-template></th>
        <th><xsl:call-template name="say"><xsl:with-param name="id">in.quantity</xsl:with-param></xsl:call-template></th>
        <th class="r"><xsl:call-template name="say"><xsl:with-param name="id">in.value</xsl:with-param></xsl:call-template></th>
        <th class="r"><xsl:call-template name="say"><xsl:with-param name="id">in.range</xsl:with-param></xsl:call-template></th>
        <th><xsl:call-template name="say"><xsl:with-param name="id">in.unit</xsl:with-param></xsl:call-template></th>
        <th><xsl:call-template name="say"><xsl:with-param name="id">in.status</xsl:with-param></xsl:call-template></th>
        <th class="r" style="white-space: nowrap">
          <xsl:call-template name="say"><xsl:with-param name="id">in.source</xsl:with-param></xsl:call-template>
        </th>
      </tr>
    </thead>
    <xsl:variable name="species" select="species"/>
    <xsl:for-each select="$species/values/item[used = 'true'][not(level = preceding-sibling::item[used = 'true']/level)]">
      <xsl:variable name="level" select="level"/>
      <tbody>
        <xsl:apply-templates select="$species/values/item[used = 'true' and level = $level]" mode="value"/>
        <xsl:apply-templates select="$species/walls/item[used = 'true' and level = $level]" mode="wall"/>
        <xsl:if test="$level = 'crown'"><xsl:apply-templates select="$species/streamlining" mode="value"/></xsl:if>
      </tbody>
    </xsl:for-each>
  </table>
  <xsl:if test="species/note != ''">
    <p class="note">
      <xsl:call-template name="say">
        <xsl:with-param name="id">in.species.note</xsl:with-param><xsl:with-param name="a" select="species/note"/>
      </xsl:call-template>
    </p>
  </xsl:if>
</xsl:template>

<xsl:template name="metres"><xsl:param name="x"/><xsl:call-template name="given"><xsl:with-param name="x" select="$x"/>
  </xsl:call-template> m</xsl:template>

<xsl:template match="model">
  <table class="block">
    <xsl:call-template name="block-row">
      <xsl:with-param name="id">in.model</xsl:with-param>
      <xsl:with-param name="text">
        <b><xsl:value-of select="name"/></b><xsl:if test="note != ''">
          <xsl:call-template name="say"><xsl:with-param name="id">dot</xsl:with-param></xsl:call-template>
          <xsl:value-of select="$gap"/>
          <xsl:call-template name="fine"><xsl:with-param name="text" select="note"/></xsl:call-template>
        </xsl:if>
      </xsl:with-param>
    </xsl:call-template>
    <xsl:if test="source != ''">
      <xsl:call-template name="block-row">
        <xsl:with-param name="id">in.model.source</xsl:with-param><xsl:with-param name="text" select="string(source)"/>
      </xsl:call-template>
    </xsl:if>
    <xsl:call-template name="block-row">
      <xsl:with-param name="id">in.height</xsl:with-param>
      <xsl:with-param name="text">
        <!-- of the tree with its branches; that of the stem, from which it grew, may be another -->
        <xsl:variable name="tree" select="../height/value"/>
        <xsl:variable name="apart" select="$tree &gt; 1.01 * height/value or $tree &lt; 0.99 * height/value"/>
        <xsl:call-template name="metres">
          <xsl:with-param name="x" select="$tree | height/value[not($tree)]"/>
        </xsl:call-template>
        <xsl:if test="$apart">
          <xsl:call-template name="say"><xsl:with-param name="id">in.height.stem</xsl:with-param>
            <xsl:with-param name="a">
              <xsl:call-template name="metres"><xsl:with-param name="x" select="height/value"/></xsl:call-template>
            </xsl:with-param>
          </xsl:call-template>
        </xsl:if>
      </xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="block-row">
      <xsl:with-param name="id">in.diameter</xsl:with-param>
      <xsl:with-param name="text">
        <xsl:choose>
          <xsl:when test="base_radius/value = ''">
            <xsl:call-template name="say"><xsl:with-param name="id">in.diameter.species</xsl:with-param></xsl:call-template>
          </xsl:when>
          <xsl:otherwise><xsl:call-template name="given"><xsl:with-param name="x" select="2000 * base_radius/value"/>
            </xsl:call-template> mm</xsl:otherwise>
        </xsl:choose>
      </xsl:with-param>
    </xsl:call-template>
    <xsl:if test="taper">
      <xsl:call-template name="block-row">
        <xsl:with-param name="id">in.taper</xsl:with-param>
        <xsl:with-param name="text">
          <xsl:call-template name="say">
            <xsl:with-param name="id" select="concat('taper.', taper)"/>
            <xsl:with-param name="a">
              <xsl:if test="tip_share">
                <xsl:call-template name="given"><xsl:with-param name="x" select="100 * tip_share/value"/></xsl:call-template>
              </xsl:if>
            </xsl:with-param>
            <xsl:with-param name="b">
              <xsl:if test="taper_power">
                <xsl:call-template name="given"><xsl:with-param name="x" select="taper_power/value"/></xsl:call-template>
              </xsl:if>
            </xsl:with-param>
          </xsl:call-template>
        </xsl:with-param>
      </xsl:call-template>
    </xsl:if>
    <xsl:if test="levels &gt; 1">
      <xsl:call-template name="block-row">
        <xsl:with-param name="id">in.branches</xsl:with-param>
        <xsl:with-param name="text">
          <xsl:call-template name="say">
            <xsl:with-param name="id" select="concat('generator.', generator)"/><xsl:with-param name="a" select="levels"/>
            <xsl:with-param name="b" select="seed"/>
          </xsl:call-template>
        </xsl:with-param>
      </xsl:call-template>
    </xsl:if>
    <xsl:if test="lean/value &gt; 0">
      <xsl:call-template name="block-row">
        <xsl:with-param name="id">in.lean</xsl:with-param>
        <xsl:with-param name="text"><xsl:call-template name="fixed"><xsl:with-param name="x" select="$degrees * lean/value"/>
          </xsl:call-template>°</xsl:with-param>
      </xsl:call-template>
    </xsl:if>
    <xsl:call-template name="block-row">
      <xsl:with-param name="id">in.segments<xsl:if test="levels &gt; 1">.tree</xsl:if></xsl:with-param>
     <xsl:with-param name="text" select="string((../segments[../model/levels &gt; 1] |
        segments[not(../levels &gt; 1 and ../../segments)])[1])"/>
    </xsl:call-template>
    <xsl:call-template name="block-row">
      <xsl:with-param name="id">in.crown</xsl:with-param>
      <xsl:with-param name="text">
        <xsl:choose>
          <xsl:when test="outline_height/value &gt; 0">
            <xsl:call-template name="say">
              <xsl:with-param name="id">in.crown.outline</xsl:with-param>
              <xsl:with-param name="a">
                <xsl:call-template name="given"><xsl:with-param name="x" select="frontal_area/value"/></xsl:call-template>
              </xsl:with-param>
              <xsl:with-param name="b">
                <xsl:call-template name="given"><xsl:with-param name="x" select="outline_centre/value"/></xsl:call-template>
              </xsl:with-param>
              <xsl:with-param name="c">
                <xsl:call-template name="given"><xsl:with-param name="x" select="outline_breadth/value"/></xsl:call-template>
              </xsl:with-param>
              <xsl:with-param name="d">
                <xsl:call-template name="given"><xsl:with-param name="x" select="outline_height/value"/></xsl:call-template>
              </xsl:with-param>
            </xsl:call-template>
          </xsl:when>
          <xsl:when test="frontal_area/value &gt; 0">
            <xsl:call-template name="say">
              <xsl:with-param name="id">in.crown.area</xsl:with-param>
              <xsl:with-param name="a">
                <xsl:call-template name="given"><xsl:with-param name="x" select="frontal_area/value"/></xsl:call-template>
              </xsl:with-param>
            </xsl:call-template>
          </xsl:when>
          <xsl:when test="not(leaf_area/value &gt; 0)">
            <xsl:call-template name="say"><xsl:with-param name="id">in.crown.none</xsl:with-param></xsl:call-template>
          </xsl:when>
          <xsl:when test="crown_base/value = ''">
            <xsl:call-template name="say">
              <xsl:with-param name="id">in.crown.branched</xsl:with-param>
              <xsl:with-param name="a">
                <xsl:call-template name="given"><xsl:with-param name="x" select="leaf_area/value"/></xsl:call-template>
              </xsl:with-param>
            </xsl:call-template>
          </xsl:when>
          <xsl:otherwise>
            <xsl:call-template name="say">
              <xsl:with-param name="id">in.crown.text</xsl:with-param>
              <xsl:with-param name="a">
                <xsl:call-template name="given"><xsl:with-param name="x" select="crown_base/value"/></xsl:call-template>
              </xsl:with-param>
              <xsl:with-param name="b">
                <xsl:call-template name="given"><xsl:with-param name="x" select="crown_top/value"/></xsl:call-template>
              </xsl:with-param>
              <xsl:with-param name="c">
                <xsl:call-template name="given"><xsl:with-param name="x" select="leaf_area/value"/></xsl:call-template>
              </xsl:with-param>
            </xsl:call-template>
          </xsl:otherwise>
        </xsl:choose>
      </xsl:with-param>
    </xsl:call-template>
  </table>
</xsl:template>

<xsl:template match="scenario">
  <table class="block">
    <xsl:call-template name="block-row">
      <xsl:with-param name="id">in.profile</xsl:with-param>
      <xsl:with-param name="text">
        <xsl:call-template name="say">
          <xsl:with-param name="id" select="concat('profile.', profile)"/>
          <xsl:with-param name="a">
            <xsl:choose>
              <xsl:when test="profile = 'log' or profile = 'canopy'">
                <xsl:call-template name="given"><xsl:with-param name="x" select="roughness/value"/></xsl:call-template>
              </xsl:when>
              <xsl:when test="profile = 'terrain'"><xsl:value-of select="terrain"/></xsl:when>
              <xsl:otherwise>
                <xsl:call-template name="given"><xsl:with-param name="x" select="exponent/value"/></xsl:call-template>
              </xsl:otherwise>
            </xsl:choose>
          </xsl:with-param>
          <xsl:with-param name="b">
            <xsl:call-template name="given"><xsl:with-param name="x" select="displacement/value"/></xsl:call-template>
          </xsl:with-param>
          <xsl:with-param name="c">
            <xsl:call-template name="number"><xsl:with-param name="x" select="canopy_height/value"/></xsl:call-template>
          </xsl:with-param>
          <xsl:with-param name="d">
            <xsl:call-template name="number"><xsl:with-param name="x" select="attenuation/value"/></xsl:call-template>
          </xsl:with-param>
          <xsl:with-param name="e">
            <xsl:call-template name="given"><xsl:with-param name="x" select="profile_low/value"/></xsl:call-template>
          </xsl:with-param>
          <xsl:with-param name="f">
            <xsl:call-template name="given"><xsl:with-param name="x" select="profile_high/value"/></xsl:call-template>
          </xsl:with-param>
        </xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="block-row">
      <xsl:with-param name="id">in.reference</xsl:with-param>
      <xsl:with-param name="text">
        <xsl:call-template name="metres">
          <xsl:with-param name="x" select="(wind_height | self::*[not(wind_height)]/reference_height)/value"/>
        </xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="block-row">
      <xsl:with-param name="id">in.azimuth</xsl:with-param>
      <xsl:with-param name="text">
        <xsl:call-template name="say">
          <xsl:with-param name="id">in.azimuth.text</xsl:with-param>
          <xsl:with-param name="a">
            <xsl:call-template name="fixed">
              <xsl:with-param name="x" select="$degrees * azimuth/value"/><xsl:with-param name="pattern">0.#</xsl:with-param>
            </xsl:call-template>
          </xsl:with-param>
        </xsl:call-template>
      </xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="block-row">
      <xsl:with-param name="id">in.air</xsl:with-param>
      <xsl:with-param name="text"><xsl:call-template name="fixed"><xsl:with-param name="x" select="air_density/value"/>
        <xsl:with-param name="pattern">0.000</xsl:with-param></xsl:call-template> kg/m³, <xsl:call-template name="say">
      <xsl:with-param name="id"><xsl:choose><xsl:when test="air_density_from = 'given'">in.air.given</xsl:when>
        <xsl:otherwise>in.air.from</xsl:otherwise></xsl:choose></xsl:with-param>
      <xsl:with-param name="a"><xsl:call-template name="fixed"><xsl:with-param name="x" select="temperature/value - 273.15"/>
        <xsl:with-param name="pattern">0.#</xsl:with-param></xsl:call-template></xsl:with-param>
      <xsl:with-param name="b"><xsl:call-template name="given"><xsl:with-param name="x" select="altitude/value"/>
        </xsl:call-template></xsl:with-param></xsl:call-template></xsl:with-param>
    </xsl:call-template>
    <xsl:call-template name="block-row">
      <xsl:with-param name="id">in.gravity</xsl:with-param>
      <xsl:with-param name="text"><xsl:call-template name="given"><xsl:with-param name="x" select="gravity/value"/>
        </xsl:call-template> m/s²</xsl:with-param>
    </xsl:call-template>
  </table>
</xsl:template>

<!-- trees usually share one model and one scenario: each is shown once -->
<xsl:template name="inputs">
  <p class="note">
    <xsl:call-template name="say">
      <xsl:with-param name="id">in.legend</xsl:with-param><xsl:with-param name="a" select="7"/>
    </xsl:call-template>
  </p>
  <xsl:for-each select="$trees"><xsl:call-template name="species-table"/></xsl:for-each>
  <h3><xsl:call-template name="say"><xsl:with-param name="id">in.trees</xsl:with-param></xsl:call-template></h3>
  <xsl:apply-templates select="$trees[not(model/key = preceding-sibling::item/model/key)]/model"/>
  <xsl:apply-templates select="$trees[1]/scenario"/>
</xsl:template>

<xsl:template name="sources">
  <ol class="sources">
    <xsl:for-each select="$sources"><li id="source{position()}"><xsl:value-of select="."/></li></xsl:for-each>
  </ol>
</xsl:template>
</xsl:stylesheet>
