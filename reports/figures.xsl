<?xml version="1.0" encoding="UTF-8"?>
<!-- From the results to plots/run.gp: what the figure scripts need to know about one run. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform">
<xsl:import href="words.xsl"/>
<xsl:output method="text" encoding="UTF-8"/>

<!-- 'text' for gnuplot: a quote inside is doubled, line ends become spaces -->
<xsl:template name="quote">
  <xsl:param name="text"/>
  <xsl:text>'</xsl:text><xsl:call-template name="double"><xsl:with-param name="text" select="normalize-space($text)"/></xsl:call-template><xsl:text>'</xsl:text>
</xsl:template>
<xsl:template name="double">
  <xsl:param name="text"/>
  <xsl:variable name="mark">'</xsl:variable>
  <xsl:choose>
    <xsl:when test="contains($text, $mark)">
      <xsl:value-of select="concat(substring-before($text, $mark), $mark, $mark)"/>
      <xsl:call-template name="double"><xsl:with-param name="text" select="substring-after($text, $mark)"/></xsl:call-template>
    </xsl:when>
    <xsl:otherwise><xsl:value-of select="$text"/></xsl:otherwise>
  </xsl:choose>
</xsl:template>
<xsl:template name="number-or-nan">
  <xsl:param name="x"/>
  <xsl:choose><xsl:when test="not($x) or $x = ''">NaN</xsl:when><xsl:otherwise><xsl:value-of select="$x"/></xsl:otherwise></xsl:choose>
</xsl:template>
<xsl:template name="label">
  <xsl:param name="name"/><xsl:param name="a"/>
  <xsl:value-of select="concat('L_', $name, ' = ')"/>
  <xsl:call-template name="quote"><xsl:with-param name="text"><xsl:call-template name="say">
    <xsl:with-param name="id" select="concat('fig.', $name)"/><xsl:with-param name="a" select="$a"/>
  </xsl:call-template></xsl:with-param></xsl:call-template>
  <xsl:text>&#10;</xsl:text>
</xsl:template>
<!-- array NAME[n] = [...]: the rows are made by the mode of that name -->
<xsl:template name="comma"><xsl:if test="position() != last()">, </xsl:if></xsl:template>

<xsl:template match="/report">
  <xsl:variable name="n" select="count($trees)"/>
  <xsl:variable name="far">
    <xsl:for-each select="$trees/winds/item/speed/value | $trees/critical/speed/value[. != '']">
      <xsl:sort data-type="number" order="descending"/>
      <xsl:if test="position() = 1"><xsl:value-of select="."/></xsl:if>
    </xsl:for-each>
  </xsl:variable>
  <xsl:variable name="end">
    <xsl:for-each select="$trees/sweep_speed_high/value[. != '']">
      <xsl:sort data-type="number" order="descending"/>
      <xsl:if test="position() = 1"><xsl:value-of select="."/></xsl:if>
    </xsl:for-each>
  </xsl:variable>
  <xsl:variable name="wide" select="5 * ceiling(1.08 * $far div 5)"/>
  <xsl:text># What the figure scripts need to know about this run; written by windfirm. Edit and redraw as you like:&#10;</xsl:text>
  <xsl:text>#   gnuplot -c reports/plots/tip.gp FOLDER tip.pdf&#10;</xsl:text>
  <xsl:value-of select="concat('trees = ', $n, '&#10;array NAME[', $n, '] = [')"/>
  <xsl:for-each select="$trees"><xsl:call-template name="quote"><xsl:with-param name="text"><xsl:call-template name="name"/></xsl:with-param></xsl:call-template><xsl:call-template name="comma"/></xsl:for-each>
  <xsl:value-of select="concat(']&#10;# height [m], direction of the wind [rad], segments, wind speed of breakage [m/s]&#10;array HEIGHT_M[', $n, '] = [')"/>
  <xsl:for-each select="$trees"><xsl:value-of select="height/value"/><xsl:call-template name="comma"/></xsl:for-each>
  <xsl:value-of select="concat(']&#10;array AZIMUTH[', $n, '] = [')"/>
  <xsl:for-each select="$trees"><xsl:value-of select="scenario/azimuth/value"/><xsl:call-template name="comma"/></xsl:for-each>
  <xsl:value-of select="concat(']&#10;array ROWS[', $n, '] = [')"/>
  <xsl:for-each select="$trees"><xsl:value-of select="segments"/><xsl:call-template name="comma"/></xsl:for-each>
  <xsl:value-of select="concat(']&#10;array CRITICAL[', $n, '] = [')"/>
  <xsl:for-each select="$trees"><xsl:call-template name="number-or-nan"><xsl:with-param name="x" select="critical[within_limits = 'true']/speed/value"/></xsl:call-template><xsl:call-template name="comma"/></xsl:for-each>
  <xsl:text>]&#10;# wind speeds drawn [m/s]; for each tree those that have an answer, by number; trees with a known strength&#10;</xsl:text>
  <xsl:variable name="drawn" select="$trees[1]/winds/item[contains($shown, concat(' ', count(preceding-sibling::item) + 1, ' '))]"/>
  <xsl:value-of select="concat('array WIND[', count($drawn), '] = [')"/>
  <xsl:for-each select="$drawn"><xsl:value-of select="speed/value"/><xsl:call-template name="comma"/></xsl:for-each>
  <xsl:value-of select="concat(']&#10;array SOLVED[', $n, '] = [')"/>
  <xsl:for-each select="$trees">
    <xsl:text>"</xsl:text>
    <xsl:for-each select="winds/item[contains($shown, concat(' ', count(preceding-sibling::item) + 1, ' '))]">
      <xsl:if test="status = 'ok'"><xsl:value-of select="concat(position(), ' ')"/></xsl:if>
    </xsl:for-each>
    <xsl:text>"</xsl:text><xsl:call-template name="comma"/>
  </xsl:for-each>
  <xsl:text>]&#10;STRONG = "</xsl:text>
  <xsl:for-each select="$trees"><xsl:if test="winds/item[least_safety/value != '']"><xsl:value-of select="concat(position(), ' ')"/></xsl:if></xsl:for-each>
  <xsl:text>"&#10;SPEED_MAX = </xsl:text>
  <xsl:choose><xsl:when test="$end != '' and $end &lt; $wide"><xsl:value-of select="$end"/></xsl:when><xsl:otherwise><xsl:value-of select="$wide"/></xsl:otherwise></xsl:choose>
  <xsl:text>&#10;# words&#10;</xsl:text>
  <xsl:variable name="reference"><xsl:call-template name="given"><xsl:with-param name="x" select="$trees[1]/scenario/reference_height/value"/></xsl:call-template></xsl:variable>
  <xsl:call-template name="label"><xsl:with-param name="name">ALONG</xsl:with-param></xsl:call-template>
  <xsl:call-template name="label"><xsl:with-param name="name">HEIGHT</xsl:with-param></xsl:call-template>
  <xsl:call-template name="label"><xsl:with-param name="name">STILL</xsl:with-param></xsl:call-template>
  <xsl:call-template name="label"><xsl:with-param name="name">SPEED</xsl:with-param></xsl:call-template>
  <xsl:call-template name="label"><xsl:with-param name="name">WIND</xsl:with-param><xsl:with-param name="a" select="$reference"/></xsl:call-template>
  <xsl:call-template name="label"><xsl:with-param name="name">TIP_DEFLECTION</xsl:with-param></xsl:call-template>
  <xsl:call-template name="label"><xsl:with-param name="name">TIP_ANGLE</xsl:with-param></xsl:call-template>
  <xsl:call-template name="label"><xsl:with-param name="name">MOMENT</xsl:with-param></xsl:call-template>
  <xsl:call-template name="label"><xsl:with-param name="name">STRESS</xsl:with-param></xsl:call-template>
  <xsl:call-template name="label"><xsl:with-param name="name">SAFETY</xsl:with-param></xsl:call-template>
  <xsl:call-template name="label"><xsl:with-param name="name">BREAKS</xsl:with-param></xsl:call-template>
  <xsl:if test="$trees[1]/directions/number">
    <xsl:call-template name="label"><xsl:with-param name="name">AROUND_MOMENT</xsl:with-param><xsl:with-param name="a"><xsl:call-template name="given"><xsl:with-param name="x" select="$trees[1]/winds/item[last()]/speed/value"/></xsl:call-template></xsl:with-param></xsl:call-template>
    <xsl:call-template name="label"><xsl:with-param name="name">AROUND_CRITICAL</xsl:with-param></xsl:call-template>
    <xsl:call-template name="label"><xsl:with-param name="name">AROUND_FIRST</xsl:with-param></xsl:call-template>
    <xsl:call-template name="label"><xsl:with-param name="name">AROUND_STEM</xsl:with-param></xsl:call-template>
    <xsl:call-template name="label"><xsl:with-param name="name">NORTH</xsl:with-param></xsl:call-template>
    <xsl:call-template name="label"><xsl:with-param name="name">SOUTH</xsl:with-param></xsl:call-template>
    <xsl:call-template name="label"><xsl:with-param name="name">EAST</xsl:with-param></xsl:call-template>
    <xsl:call-template name="label"><xsl:with-param name="name">WEST</xsl:with-param></xsl:call-template>
  </xsl:if>
</xsl:template>
</xsl:stylesheet>
