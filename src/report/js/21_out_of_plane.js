// What is left when the tilt is taken away: the shape that strains the shell.

function addOutOfPlane() {
  const section = addSection("out-of-plane", "Out of plane");
  if (!usable) return sayAbsent(section, whyAbsent("Out-of-plane settlement"));
  const found = datum.out_of_plane || null;
  const fit = (found && found.u_fit_sigma) || [];
  const rows = stations.map((s, i) => ({ ...s, mm: known(s.u) ? 1e3 * s.u : null, half: known(s.sigma_z) ? 2e3 * s.sigma_z : null,
    fit: known(s.u_fit) ? 1e3 * s.u_fit : null, fitHalf: known(fit[i]) ? 2e3 * fit[i] : null }));
  const hasFit = rows.some((r) => known(r.fit));
  section.append(make("p", { class: "quiet" }, "Elevation less the fitted tilt."));
  if (found) section.append(outOfPlaneFacts(found));
  addChart(section, {
    id: "out-of-plane-chart", label: "Out-of-plane settlement against azimuth", ratio: 0.34, least: 280, most: 400,
    legend: [{ name: "u", label: "out-of-plane settlement, \u00b1 2\u03c3 band", colour: "datum" },
      ...(hasFit ? [{ name: "fit", label: "harmonic fit", colour: "fit", on: true }] : [])],
    draw: (svg, width, height, shown) => drawOutOfPlane(svg, width, height, shown, rows),
  });
  if (!hasFit) sayAbsent(section, found && found.message ? `Harmonic fit and curvature: none, because ${found.message}.` : whyAbsent("Harmonic fit and curvature"));
  else addCurvature(section, found);
  if (hasSection("harmonics") && datum.harmonics.length > 0) addHarmonics(section);
  if (hasSection("foundation")) addFoundationLevel(section, datum.foundation);
}

/** How level the foundation is: differences within a length and over the circumference. */
function addFoundationLevel(section, foundation) {
  const names = { level_3m: "Within 3 m", level_9m: "Within 9 m", level_total: "From the mean, all round" };
  const facts = Object.entries(names).filter(([key]) => foundation[key] && known(foundation[key].value));
  if (facts.length === 0) return;
  section.append(make("h3", {}, "Level of the foundation"), make("dl", { class: "facts" }, facts.map(([key, name]) => {
    const { value, sigma, azimuth_deg: azimuth } = foundation[key];
    const more = [plusMinus(sigma), known(azimuth) ? `at ${degrees(azimuth, 1)}` : ""].filter(Boolean).join(", ");
    return make("div", {}, make("dt", {}, name), make("dd", {}, millimetres(value), make("small", {}, more)));
  })));
}

function outOfPlaneFacts(found) {
  if (!known(found.max_abs_u)) return make("p", {}, found.message || "");
  const limit = known(found.curvature_limit) ? `, limit ${anyFigure(found.curvature_limit)} 1/m` : "";
  const curvature = known(found.max_curvature) ? `; largest curvature ${anyFigure(found.max_curvature)} 1/m at ${degrees(found.max_curvature_azimuth_deg, 1)}${limit}` : "";
  const classic = found.second_differences, worst = classic && classic.worst;
  const second = worst && known(worst.value) ? ` Classic second difference, ${classic.points} points ${metres(classic.spacing, 2)} apart, ${classic.starts} starts: `
    + `at most ${millimetres(worst.value)} at ${degrees(worst.azimuth_deg, 1)}.` : "";
  return make("p", {}, `Harmonics to ${anyFigure(found.order)}: largest ${millimetres(found.max_abs_u)} at ${degrees(found.max_abs_u_azimuth_deg, 1)}, `
    + `RMS of what is left ${millimetres(found.rms, 2)}, adjusted R\u00b2 ${figure(found.adjusted_r2, 3)}${curvature}.${second}`);
}

function drawOutOfPlane(svg, width, height, shown, rows) {
  const values = rows.flatMap((r) => (known(r.mm) ? [r.mm - (r.half || 0), r.mm + (r.half || 0)] : [r.fit]));
  const axes = azimuthAxes(svg, width, height, room(values), "Out-of-plane settlement [mm]");
  shadeGaps(svg, axes, height);
  drawLevel(svg, axes, 0, "zero");
  drawBand(svg, axes, rows, (r) => r.mm, (r) => r.half);
  drawLine(svg, axes, rows, (r) => r.mm, "datum");
  if (shown.fit) drawLine(svg, axes, rows, (r) => r.fit, "fit");
  followPointer(svg, azimuthUnder(axes), (azimuth) => describeFit(azimuth));
  return azimuthMarks(svg, axes, height, (azimuth) => rows[stationAt(azimuth)].mm);
}

/** The station with its harmonic fit and curvature. */
function describeFit(azimuth) {
  const s = stations[stationAt(azimuth)], lines = describeStation(azimuth);
  if (known(s.u_fit)) lines.push(["Harmonic fit", millimetres(s.u_fit, 2)]);
  if (known(s.curvature)) lines.push(["Curvature", `${anyFigure(s.curvature)} 1/m`]);
  return lines;
}

function addCurvature(section, found) {
  const limit = found ? found.curvature_limit : null, sigmas = (found && found.curvature_sigma) || [];
  const rows = stations.map((s, i) => ({ ...s, half: known(sigmas[i]) ? 2 * sigmas[i] : null }));
  section.append(make("h3", {}, "Curvature along the shell"));
  if (!known(limit)) section.append(make("p", { class: "quiet" }, "No limit is drawn: it needs the shell\u2019s height, yield strength and modulus (--height, --yield-mpa, --modulus-mpa)."));
  addChart(section, {
    id: "curvature-chart", label: "Curvature of the harmonic fit against azimuth, with its limit", ratio: 0.3, least: 260, most: 360,
    legend: [{ name: "curvature", label: "curvature of the fit, \u00b1 2\u03c3 band", colour: "fit" },
      ...(known(limit) ? [{ name: "limit", label: "limit", colour: "fail", on: true }] : [])],
    draw: (svg, width, height, shown) => {
      const ends = shown.limit ? [-1e6 * limit, 1e6 * limit] : [];
      const values = rows.flatMap((r) => (known(r.curvature) ? [1e6 * (r.curvature - (r.half || 0)), 1e6 * (r.curvature + (r.half || 0))] : []));
      const axes = azimuthAxes(svg, width, height, room([...values, ...ends]), "Curvature [10\u207b\u2076 1/m]");
      shadeGaps(svg, axes, height);
      drawLevel(svg, axes, 0, "zero");
      drawBand(svg, axes, rows, (r) => (known(r.curvature) ? 1e6 * r.curvature : null), (r) => (known(r.half) ? 1e6 * r.half : null));
      drawLine(svg, axes, rows, (r) => (known(r.curvature) ? 1e6 * r.curvature : null), "fit");
      if (shown.limit) for (const end of ends) drawLevel(svg, axes, end, "limit", "limit");
      followPointer(svg, azimuthUnder(axes), describeFit);
      return azimuthMarks(svg, axes, height, (azimuth) => {
        const c = rows[stationAt(azimuth)].curvature;
        return known(c) ? 1e6 * c : null;
      });
    },
  });
}

function addHarmonics(section) {
  const rows = datum.harmonics.filter((h) => h.n >= 1 && known(h.amplitude));
  section.append(make("h3", {}, "Harmonics"),
    make("p", { class: "quiet" }, "Amplitude of each number of waves round the tank; 1 is the tilt. Whiskers are \u00b1 2\u03c3."));
  addChart(section, {
    id: "harmonics-chart", label: "Amplitudes of the harmonics", ratio: 0.28, least: 220, most: 300, legend: [],
    draw: (svg, width, height) => {
      const x = d3.scaleBand(rows.map((h) => h.n), [62, width - 14]).padding(0.35);
      const top = d3.max(rows, (h) => 1e3 * (h.amplitude + 2 * (h.sigma || 0)));
      const y = d3.scaleLinear([0, top || 1], [height - 44, 26]).nice();
      drawAxes(svg, x, y, x.domain(), "Amplitude [mm]", "Waves round the tank");
      for (const h of rows) {
        const middle = x(h.n) + x.bandwidth() / 2;
        svg.append("rect").attr("class", "bar").attr("x", x(h.n)).attr("width", x.bandwidth())
          .attr("y", y(1e3 * h.amplitude)).attr("height", y(0) - y(1e3 * h.amplitude))
          .append("title").text(`${h.n} waves: ${millimetres(h.amplitude, 2)} ${plusMinus(h.sigma, 2)}, highest at ${degrees(h.phase_deg, 1)}`);
        if (known(h.sigma)) {
          svg.append("line").attr("class", "whisker").attr("x1", middle).attr("x2", middle)
            .attr("y1", y(1e3 * (h.amplitude + 2 * h.sigma))).attr("y2", y(1e3 * Math.max(0, h.amplitude - 2 * h.sigma)));
        }
      }
    },
  });
}
