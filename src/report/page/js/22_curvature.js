// The curvature of the harmonic fit against its limit, and the waves it is made of.

function addCurvature(section, found) {
  const limit = found ? found.curvature_limit : null, sigmas = (found && found.curvature_sigma) || [];
    const rows = stations.map((s, i) => ({ ...s, value: bend(s.curvature), half: bend(known(sigmas[i]) ? 2 * sigmas[i] : null) }));
  section.append(make("h3", {}, say("curvature.curvature_along_the_shell")));
  if (!known(limit)) {
    section.append(make("p", { class: "quiet" },
      typeset(say("curvature.no_limit_is_drawn_it"))));
  }
  addChart(section, {
    id: "curvature-chart", label: say("curvature.curvature_of_the_harmonic_fit"), ratio: 0.3, least: 260, most: 360,
    legend: [{ name: "curvature", label: say("curvature.curvature_of_the_fit", { k_band_words: kBandWords }), colour: "fit" },
      ...(known(limit) ? [{ name: "limit", label: say("curvature.limit"), colour: "fail", on: true }] : [])],
    draw: (svg, width, height, shown) => drawCurvature(svg, width, height, rows, shown.limit ? [-bend(limit), bend(limit)] : []),
  });
}

function drawCurvature(svg, width, height, rows, limits) {
  const values = rows.flatMap((r) => (known(r.value) ? [r.value - (r.half || 0), r.value + (r.half || 0)] : []));
  const axes = azimuthAxes(svg, width, height, room([...values, ...limits]), say("curvature.curvature", { unit: kBendUnit }));
  shadeGaps(svg, axes, height);
  drawLevel(svg, axes, 0, "zero");
  drawBand(svg, axes, rows, (r) => r.value, (r) => r.half);
  drawLine(svg, axes, rows, (r) => r.value, "fit");
  for (const end of limits) drawLevel(svg, axes, end, "limit", say("curvature.limit"));
  followPointer(svg, azimuthUnder(axes), describeFit);
  return azimuthMarks(svg, axes, height, (azimuth) => valueAlong(rows, azimuth));
}

function addHarmonics(section) {
  const rows = datum.harmonics.filter((h) => h.n >= 1 && known(h.amplitude));
  section.append(make("h3", {}, say("curvature.harmonics")));
  const worst = d3.max(rows, (h) => h.sigma), largest = d3.max(rows, (h) => h.amplitude);
  if (2 * worst > largest) return sayAbsent(section, say("harmonics.not_apart", { sigma: worst < 0.5 ? shortLength(2 * worst) : longLength(2 * worst, 1) }));
  section.append(make("p", { class: "quiet" }, say("curvature.amplitude_of_each_number_of")));
  addChart(section, { id: "harmonics-chart", label: say("curvature.amplitudes_of_the_harmonics"), ratio: 0.28, least: 220, most: 300, legend: [],
    draw: (svg, width, height) => drawHarmonics(svg, width, height, rows) });
}

function drawHarmonics(svg, width, height, rows) {
  const x = d3.scaleBand(rows.map((h) => h.n), [62, width - 14]).padding(0.35);
  const top = d3.max(rows, (h) => toShort(h.amplitude + 2 * (h.sigma || 0)));
  const y = d3.scaleLinear([0, top || 1], [height - 44, 26]).nice();
  drawAxes(svg, x, y, x.domain(), say("curvature.amplitude", { unit: kShortUnit }), say("curvature.waves_round_the_tank"));
  for (const h of rows) {
    const middle = x(h.n) + x.bandwidth() / 2;
    svg.append("rect").attr("class", "bar").attr("x", x(h.n)).attr("width", x.bandwidth())
      .attr("y", y(toShort(h.amplitude))).attr("height", y(0) - y(toShort(h.amplitude)))
      .append("title").text(say("curvature.highest_at", { n: say("count.wave", { count: h.n }), amplitude: shortLength(h.amplitude, 2), sigma: plusMinus(h.sigma, 2), phase_deg: degrees(h.phase_deg, 1) }));
    if (!known(h.sigma)) continue;
    svg.append("line").attr("class", "whisker").attr("x1", middle).attr("x2", middle)
      .attr("y1", y(toShort(h.amplitude + 2 * h.sigma))).attr("y2", y(toShort(Math.max(0, h.amplitude - 2 * h.sigma))));
  }
}
