<?xml version="1.0" encoding="UTF-8"?>
<!-- From <report><results/> (results.json of a calibration as elements) <css/> <figures/></report> to one page. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform" xmlns:svg="http://www.w3.org/2000/svg"
                exclude-result-prefixes="svg">
<xsl:output method="html" encoding="UTF-8" doctype-system="about:legacy-compat" indent="no"/>
<xsl:variable name="r" select="/report/results"/>
<xsl:variable name="f" select="$r/fit"/>

<!-- About four significant digits. -->
<xsl:template name="number">
  <xsl:param name="x"/>
  <xsl:variable name="a" select="$x * (1 - 2 * ($x &lt; 0))"/>
  <xsl:choose>
    <xsl:when test="string($x) = '' or string(number($x)) = 'NaN'">–</xsl:when>
    <xsl:when test="$a = 0">0</xsl:when>
    <xsl:when test="$a &gt;= 1000"><xsl:value-of select="format-number($x, '0')"/></xsl:when>
    <xsl:when test="$a &gt;= 100"><xsl:value-of select="format-number($x, '0.0')"/></xsl:when>
    <xsl:when test="$a &gt;= 10"><xsl:value-of select="format-number($x, '0.00')"/></xsl:when>
    <xsl:when test="$a &gt;= 1"><xsl:value-of select="format-number($x, '0.000')"/></xsl:when>
    <xsl:when test="$a &gt;= 0.01"><xsl:value-of select="format-number($x, '0.0000')"/></xsl:when>
    <xsl:otherwise><xsl:value-of select="format-number($x, '0.0000000')"/></xsl:otherwise>
  </xsl:choose>
</xsl:template>
<xsl:template name="range">
  <xsl:param name="low"/><xsl:param name="high"/>
  <xsl:choose>
    <xsl:when test="$low = '' and $high = ''">–</xsl:when>
    <xsl:when test="$low = ''">below <xsl:call-template name="number"><xsl:with-param name="x" select="$high"/></xsl:call-template></xsl:when>
    <xsl:when test="$high = ''">above <xsl:call-template name="number"><xsl:with-param name="x" select="$low"/></xsl:call-template></xsl:when>
    <xsl:otherwise>
      <xsl:call-template name="number"><xsl:with-param name="x" select="$low"/></xsl:call-template> to
      <xsl:call-template name="number"><xsl:with-param name="x" select="$high"/></xsl:call-template>
    </xsl:otherwise>
  </xsl:choose>
</xsl:template>
<xsl:template name="value">
  <xsl:call-template name="number"><xsl:with-param name="x" select="value"/></xsl:call-template>
  <xsl:if test="unit != ''"><xsl:text> </xsl:text><xsl:value-of select="unit"/></xsl:if>
</xsl:template>
<xsl:template name="figure">
  <xsl:param name="name"/><xsl:param name="caption"/>
  <figure>
    <xsl:variable name="g" select="/report/figures/figure[@name = $name]"/>
    <xsl:choose>
      <xsl:when test="$g/svg:svg"><xsl:copy-of select="$g/svg:svg"/></xsl:when>
      <xsl:otherwise><p class="note">This figure could not be drawn: <xsl:value-of select="$g/@missing"/></p></xsl:otherwise>
    </xsl:choose>
    <figcaption><xsl:value-of select="$caption"/></figcaption>
  </figure>
</xsl:template>

<xsl:template match="/">
<html lang="en">
<head><meta charset="utf-8"/><title><xsl:value-of select="$r/title"/></title><style><xsl:value-of select="/report/css" disable-output-escaping="yes"/></style></head>
<body>
<header>
  <h1><xsl:value-of select="$r/title"/></h1>
  <p class="sub">Calibration: what the measurements say about the tree</p>
</header>
<div class="summary">
  <xsl:for-each select="$f/parameters/item[nuisance = 'false']">
    <p><b><xsl:value-of select="name"/></b>:
      <xsl:choose>
        <xsl:when test="bound != ''">no estimate: the fit ended on its <xsl:value-of select="bound"/> bound, <xsl:call-template name="value"/><xsl:if test="profile_low != '' or profile_high != ''">; 95 % limit <xsl:call-template name="range"><xsl:with-param name="low" select="profile_low"/><xsl:with-param name="high" select="profile_high"/></xsl:call-template> (profile likelihood)</xsl:if>.</xsl:when>
        <xsl:when test="(profile_low != '') != (profile_high != '')">no estimate: any value <xsl:call-template name="range"><xsl:with-param name="low" select="profile_low"/><xsl:with-param name="high" select="profile_high"/></xsl:call-template><xsl:text> </xsl:text><xsl:value-of select="unit"/> fits (95 %, profile likelihood).</xsl:when>
        <xsl:otherwise><xsl:call-template name="value"/>, 95 % interval <xsl:choose>
          <xsl:when test="profile_low != '' or profile_high != ''"><xsl:call-template name="range"><xsl:with-param name="low" select="profile_low"/><xsl:with-param name="high" select="profile_high"/></xsl:call-template> (profile likelihood)</xsl:when>
          <xsl:otherwise><xsl:call-template name="range"><xsl:with-param name="low" select="low"/><xsl:with-param name="high" select="high"/></xsl:call-template> (covariance)</xsl:otherwise>
        </xsl:choose>.</xsl:otherwise>
      </xsl:choose>
    </p>
  </xsl:for-each>
  <xsl:choose>
    <xsl:when test="$f/not_determined/item"><xsl:for-each select="$f/not_determined/item"><p><b>Not determined by the data:</b><xsl:text> </xsl:text><xsl:value-of select="text"/>.</p></xsl:for-each></xsl:when>
    <xsl:when test="$f/parameters/item[nuisance = 'false' and bound != '']"><p>The data determine the parameters that did not end on a bound.</p></xsl:when>
    <xsl:otherwise><p>The data determine every parameter that was free.</p></xsl:otherwise>
  </xsl:choose>
  <xsl:if test="$r/rival">
    <p>The same data with a <xsl:value-of select="$r/rival/text"/>:
      <xsl:for-each select="$r/rival/parameters/item[nuisance = 'false']"><xsl:if test="position() &gt; 1">, </xsl:if><xsl:value-of select="name"/><xsl:text> </xsl:text><xsl:call-template name="value"/><xsl:choose><xsl:when test="bound != ''"> (at its bound)</xsl:when><xsl:when test="low = ''"> (not determined)</xsl:when></xsl:choose></xsl:for-each>.
      <xsl:if test="$r/rival/aicc != '' and $r/rival/own_aicc != ''">
        AICc <xsl:call-template name="number"><xsl:with-param name="x" select="$r/rival/own_aicc"/></xsl:call-template> here, <xsl:call-template name="number"><xsl:with-param name="x" select="$r/rival/aicc"/></xsl:call-template> there:
        <xsl:variable name="gap" select="$r/rival/aicc - $r/rival/own_aicc"/>
        <xsl:choose><xsl:when test="$gap &gt; 2">the data prefer this fit.</xsl:when><xsl:when test="$gap &lt; -2">the data prefer the other.</xsl:when><xsl:otherwise>the data do not choose between them.</xsl:otherwise></xsl:choose>
      </xsl:if>
    </p>
  </xsl:if>
  <xsl:if test="$r/reference != ''"><p>For comparison: <xsl:value-of select="$r/reference"/></p></xsl:if>
</div>
<xsl:if test="$r/warnings/item">
  <h2>What to beware of</h2>
  <ul><xsl:for-each select="$r/warnings/item"><li><xsl:value-of select="text"/></li></xsl:for-each></ul>
</xsl:if>
<xsl:if test="$r/note != ''"><h2>The study</h2><p><xsl:value-of select="$r/note"/></p></xsl:if>
<xsl:if test="$r/source != ''"><p class="note">Source of the measurements: <xsl:value-of select="$r/source"/></p></xsl:if>

<h2>Estimates</h2>
<table class="data">
  <caption>Intervals hold 95 %. A dash: not asked for, not determined, or the fit ended on a bound.</caption>
  <thead><tr><th>parameter</th><th>unit</th><th class="r">estimate</th><th class="r">by covariance</th><th class="r">by profile</th>
    <xsl:if test="$f/resampled &gt; 19"><th class="r">by bootstrap</th></xsl:if><th class="r">bounds</th></tr></thead>
  <tbody>
  <xsl:for-each select="$f/parameters/item">
    <tr><td><xsl:value-of select="name"/></td><td><xsl:value-of select="unit"/></td>
      <td class="r"><xsl:call-template name="number"><xsl:with-param name="x" select="value"/></xsl:call-template></td>
      <td class="r"><xsl:call-template name="range"><xsl:with-param name="low" select="low"/><xsl:with-param name="high" select="high"/></xsl:call-template></td>
      <td class="r"><xsl:call-template name="range"><xsl:with-param name="low" select="profile_low"/><xsl:with-param name="high" select="profile_high"/></xsl:call-template></td>
      <xsl:if test="$f/resampled &gt; 19"><td class="r"><xsl:call-template name="range"><xsl:with-param name="low" select="bootstrap_low"/><xsl:with-param name="high" select="bootstrap_high"/></xsl:call-template></td></xsl:if>
      <td class="r"><xsl:if test="nuisance = 'false'"><xsl:call-template name="range"><xsl:with-param name="low" select="bound_low"/><xsl:with-param name="high" select="bound_high"/></xsl:call-template></xsl:if><xsl:if test="bound != ''"> <b> on its <xsl:value-of select="bound"/> bound</b></xsl:if></td></tr>
  </xsl:for-each>
  </tbody>
</table>
<xsl:if test="count($f/parameters/item[nuisance = 'false']) &gt; 1">
  <table class="data">
    <caption>Correlation of the estimates</caption>
    <thead><tr><th></th><xsl:for-each select="$f/parameters/item[nuisance = 'false']"><th class="r"><xsl:value-of select="name"/></th></xsl:for-each></tr></thead>
    <tbody>
    <xsl:for-each select="$f/parameters/item[nuisance = 'false']">
      <xsl:variable name="row" select="position()"/>
      <tr><td><xsl:value-of select="name"/></td>
        <xsl:for-each select="correlation/item"><td class="r"><xsl:if test="position() &lt;= $row"><xsl:value-of select="format-number(., '0.00')"/></xsl:if></td></xsl:for-each></tr>
    </xsl:for-each>
    </tbody>
  </table>
</xsl:if>
<table class="data">
  <caption>Sensors. Sigma: standard uncertainty of a reading, as given or (e) estimated from the scatter. Neighbours: correlation of neighbouring residuals; it widens the intervals.
    Reduced chi-square <xsl:call-template name="number"><xsl:with-param name="x" select="$f/reduced_chi_square"/></xsl:call-template> with <xsl:value-of select="$f/freedom"/> degrees of freedom<xsl:if test="$f/sigma_estimated = 'true'"> (1 by construction where sigmas are estimated)</xsl:if>.</caption>
  <thead><tr><th>tree</th><th>test</th><th>sensor</th><th>kind</th><th class="r">height<span class="u">m</span></th><th class="r">readings</th><th class="r">sigma</th><th class="r">rms residual</th><th>unit</th><th class="r">neighbours</th></tr></thead>
  <tbody>
  <xsl:for-each select="$f/sensors/item">
    <tr><td><xsl:value-of select="tree"/></td><td><xsl:value-of select="test"/></td><td><xsl:value-of select="sensor"/></td><td><xsl:value-of select="kind"/></td>
      <td class="r"><xsl:if test="height != ''"><xsl:call-template name="number"><xsl:with-param name="x" select="height"/></xsl:call-template></xsl:if></td>
      <td class="r"><xsl:value-of select="readings"/></td>
      <td class="r"><xsl:call-template name="number"><xsl:with-param name="x" select="sigma"/></xsl:call-template><xsl:if test="estimated = 'true'"> (e)</xsl:if></td>
      <td class="r"><xsl:call-template name="number"><xsl:with-param name="x" select="rms"/></xsl:call-template></td><td><xsl:value-of select="unit"/></td>
      <td class="r"><xsl:value-of select="format-number(correlation, '0.00')"/></td></tr>
  </xsl:for-each>
  </tbody>
</table>
<xsl:if test="$r/sways/item">
  <table class="data">
    <caption>Free sway: a damped cosine fitted to each record; the frequency is the undamped one</caption>
    <thead><tr><th>test</th><th class="r">frequency<span class="u">Hz</span></th><th class="r">± 95 %</th><th class="r">damping ratio<span class="u">%</span></th><th class="r">± 95 %</th><th class="r">variance explained<span class="u">%</span></th></tr></thead>
    <tbody><xsl:for-each select="$r/sways/item">
      <tr><td><xsl:value-of select="test"/></td><td class="r"><xsl:value-of select="format-number(frequency, '0.0000')"/></td><td class="r"><xsl:value-of select="format-number(1.96 * frequency_sd, '0.0000')"/></td>
        <td class="r"><xsl:value-of select="format-number(damping, '0.00')"/></td><td class="r"><xsl:value-of select="format-number(1.96 * damping_sd, '0.00')"/></td><td class="r"><xsl:value-of select="format-number(explained, '0.0')"/></td></tr>
    </xsl:for-each></tbody>
  </table>
</xsl:if>

<h2>Measured and predicted</h2>
<xsl:call-template name="figure"><xsl:with-param name="name">fit_readings</xsl:with-param><xsl:with-param name="caption">Circles: readings with their sigma as it took part. Line: the fitted tree, with the 95 % band of its prediction. At most eight sensors are drawn.</xsl:with-param></xsl:call-template>
<xsl:call-template name="figure"><xsl:with-param name="name">fit_residuals</xsl:with-param><xsl:with-param name="caption">Above: measured minus predicted over sigma; 95 % lie in the shade if the model and the sigmas are right. Below: how far an estimate would move, in its standard deviations, if the reading were left out.</xsl:with-param></xsl:call-template>
<h2>How sharply the data tell</h2>
<xsl:call-template name="figure"><xsl:with-param name="name">fit_profiles</xsl:with-param><xsl:with-param name="caption">Misfit as a parameter is held at a value and the others are fitted again; the interval of 95 % is where the curve is below the dashed line. Dotted: what the covariance says; where both agree, its interval is right. A flat side: the data leave that side open.</xsl:with-param></xsl:call-template>
<xsl:if test="$r/records &gt; 0">
<h2>The records</h2>
<xsl:call-template name="figure"><xsl:with-param name="name">fit_records</xsl:with-param><xsl:with-param name="caption">The records as read; marked rows took part: the first loading between the shares of the largest force that the study names, or the part of a sway record to which the curve was fitted.</xsl:with-param></xsl:call-template>
</xsl:if>

<h2>How it was done</h2>
<p>The tree is the same geometrically exact beam model that computes wind loads; a rope that runs to an anchor follows the strap as the tree bends. Readings are counted from rest unless the study says otherwise; reach and rise are places, counted from the stem's base. The misfit is the sum of squared residuals over sigma<xsl:if test="$r/loss != 'none'"> under the robust loss '<xsl:value-of select="$r/loss"/>'</xsl:if><xsl:if test="$r/priors = 'true'">, with the ranges of the species table as normal priors</xsl:if>, minimised within bounds by Levenberg and Marquardt's method with the engine's own sensitivities. Intervals of moduli, stiffnesses and factors are those of their logarithms. Where neighbouring residuals repeat each other, or scatter more than their sigmas say, intervals are widened.<xsl:if test="$f/starts &gt; 0"> Of <xsl:value-of select="$f/starts"/> starting points <xsl:value-of select="$f/starts_same"/> led to this fit.</xsl:if></p>
<table class="block">
  <tr><th>trees</th><td><xsl:for-each select="$r/trees/item"><xsl:if test="position() &gt; 1">; </xsl:if><xsl:value-of select="name"/> (<xsl:value-of select="species"/>, <xsl:call-template name="number"><xsl:with-param name="x" select="height"/></xsl:call-template> m, <xsl:value-of select="segments"/> segments)</xsl:for-each></td></tr>
  <tr><th>command</th><td><xsl:value-of select="$r/command"/></td></tr>
  <tr><th>program, date</th><td class="program">windfirm <xsl:value-of select="$r/version"/>, <xsl:value-of select="$r/date"/></td></tr>
  <xsl:for-each select="$r/files/item"><tr><th><xsl:value-of select="role"/></th><td><xsl:value-of select="path"/><br/><span class="note">sha256 <xsl:value-of select="sha256"/></span></td></tr></xsl:for-each>
</table>
</body>
</html>
</xsl:template>
</xsl:stylesheet>
