// The curvature of the harmonic fit against its limit, and the waves it is made of.

function addCurvature(section, found) {
  const limit = found ? found.curvature_limit : null, sigmas = (found && found.curvature_sigma) || [];
  const micro = (value) => (known(value) ? 1e6 * value : null);
  const rows = stations.map((s, i) => ({ ...s, micro: micro(s.curvature), half: micro(known(sigmas[i]) ? 2 * sigmas[i] : null) }));
  section.append(make("h3", {}, "Curvature along the shell"));
  if (!known(limit)) {
    section.append(make("p", { class: "quiet" },
      typeset("No limit is drawn: it needs the shell\u2019s height, yield strength and modulus (options height, yield_mpa, modulus_mpa).")));
  }
  addChart(section, {
    id: "curvature-chart", label: "Curvature of the harmonic fit against azimuth, with its limit", ratio: 0.3, least: 260, most: 360,
    legend: [{ name: "curvature", label: `curvature of the fit${kBandWords}`, colour: "fit" },
      ...(known(limit) ? [{ name: "limit", label: "limit", colour: "fail", on: true }] : [])],
    draw: (svg, width, height, shown) => drawCurvature(svg, width, height, rows, shown.limit ? [-1e6 * limit, 1e6 * limit] : []),
  });
}

function drawCurvature(svg, width, height, rows, limits) {
  const values = rows.flatMap((r) => (known(r.micro) ? [r.micro - (r.half || 0), r.micro + (r.half || 0)] : []));
  const axes = azimuthAxes(svg, width, height, room([...values, ...limits]), "Curvature [10\u207b\u2076 1/m]");
  shadeGaps(svg, axes, height);
  drawLevel(svg, axes, 0, "zero");
  drawBand(svg, axes, rows, (r) => r.micro, (r) => r.half);
  drawLine(svg, axes, rows, (r) => r.micro, "fit");
  for (const end of limits) drawLevel(svg, axes, end, "limit", "limit");
  followPointer(svg, azimuthUnder(axes), describeFit);
  return azimuthMarks(svg, axes, height, (azimuth) => rows[stationAt(azimuth)].micro);
}

function addHarmonics(section) {
  const rows = datum.harmonics.filter((h) => h.n >= 1 && known(h.amplitude));
  section.append(make("h3", {}, "Harmonics"));
  const worst = d3.max(rows, (h) => h.sigma);
  if (worst > datum.datum.range) {
    return sayAbsent(section, `Amplitudes: not drawn, because what was seen of the datum does not determine them; their standard errors reach ${metres(worst, 1)}.`);
  }
  section.append(make("p", { class: "quiet" }, "Amplitude of each number of waves round the tank; 1 is the tilt. Whiskers are \u00b1 2\u03c3."));
  addChart(section, { id: "harmonics-chart", label: "Amplitudes of the harmonics", ratio: 0.28, least: 220, most: 300, legend: [],
    draw: (svg, width, height) => drawHarmonics(svg, width, height, rows) });
}

function drawHarmonics(svg, width, height, rows) {
  const x = d3.scaleBand(rows.map((h) => h.n), [62, width - 14]).padding(0.35);
  const top = d3.max(rows, (h) => 1e3 * (h.amplitude + 2 * (h.sigma || 0)));
  const y = d3.scaleLinear([0, top || 1], [height - 44, 26]).nice();
  drawAxes(svg, x, y, x.domain(), "Amplitude [mm]", "Waves round the tank");
  for (const h of rows) {
    const middle = x(h.n) + x.bandwidth() / 2;
    svg.append("rect").attr("class", "bar").attr("x", x(h.n)).attr("width", x.bandwidth())
      .attr("y", y(1e3 * h.amplitude)).attr("height", y(0) - y(1e3 * h.amplitude))
      .append("title").text(`${plural(h.n, "wave")}: ${millimetres(h.amplitude, 2)} ${plusMinus(h.sigma, 2)}, highest at ${degrees(h.phase_deg, 1)}`);
    if (!known(h.sigma)) continue;
    svg.append("line").attr("class", "whisker").attr("x1", middle).attr("x2", middle)
      .attr("y1", y(1e3 * (h.amplitude + 2 * h.sigma))).attr("y2", y(1e3 * Math.max(0, h.amplitude - 2 * h.sigma)));
  }
}
