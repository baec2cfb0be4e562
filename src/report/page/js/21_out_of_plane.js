// What is left when the tilt is taken away: the shape that strains the shell.

function addOutOfPlane() {
  const section = addSection("out-of-plane", "Out of plane");
  if (!usable) return sayAbsent(section, whyAbsent("Out-of-plane settlement"));
  const found = datum.out_of_plane || null, fit = (found && found.u_fit_sigma) || [];
  const rows = stations.map((s, i) => ({ ...s, mm: known(s.u) ? 1e3 * s.u : null, half: known(s.sigma_z) ? 2e3 * s.sigma_z : null,
    fit: known(s.u_fit) ? 1e3 * s.u_fit : null, fitHalf: known(fit[i]) ? 2e3 * fit[i] : null }));
  const hasFit = rows.some((r) => known(r.fit)), sigmas = rows.some((r) => known(r.half));
  section.append(make("p", { class: "quiet" }, "Elevation less the fitted tilt."));
  const facts = [...outOfPlaneFacts(found), ...levelFacts()];
  if (facts.length > 0) section.append(boxes(facts));
  addChart(section, {
    id: "out-of-plane-chart", label: "Out-of-plane settlement against azimuth", ratio: 0.34, least: 280, most: 400,
    legend: [{ name: "u", label: `out-of-plane settlement${sigmas ? kBandWords : ""}`, colour: "datum" },
      ...(hasFit ? [{ name: "fit", label: "harmonic fit", colour: "fit", on: true }] : [])],
    draw: (svg, width, height, shown) => drawOutOfPlane(svg, width, height, shown, rows),
  });
  if (hasFit) addCurvature(section, found);
  else sayAbsent(section, whyNoFit());
  if (hasSection("harmonics") && datum.harmonics.length > 0) addHarmonics(section);
}

/** The largest settlement, the harmonic fit, its curvature and the classic rule's figure. */
function outOfPlaneFacts(found) {
  if (found === null) return [];
  const list = [], at = (azimuth) => `at ${degrees(azimuth, 1)}`;
  if (known(found.max_abs_u)) list.push(["Largest settlement", millimetres(found.max_abs_u), at(found.max_abs_u_azimuth_deg)]);
  if (known(found.max_curvature)) {
    list.push(["Harmonic fit", `waves 2 to ${found.order}`, `${millimetres(found.rms, 2)} left (RMS), adjusted R\u00b2 ${figure(found.adjusted_r2, 4)}`]);
    const sigma = known(found.sigma_curvature) ? `\u00b1 ${figure(2e6 * found.sigma_curvature, 1)} (2\u03c3), ` : "";
    const limit = known(found.curvature_limit) ? `, limit ${figure(1e6 * found.curvature_limit, 1)}` : "";
    list.push(["Largest curvature", curvature(found.max_curvature), `${sigma}${at(found.max_curvature_azimuth_deg)}${limit}`]);
  }
  const classic = found.second_differences, worst = classic && classic.worst;
  if (worst && known(worst.value)) {
    list.push(["Second difference S_i", millimetres(worst.value),
      `${at(worst.azimuth_deg)}; ${classic.points} points ${metres(classic.spacing, 2)} apart, ${plural(classic.starts, "start angle")}`]);
  }
  return list;
}

/** How level the foundation is: differences within a length and over the circumference. */
function levelFacts() {
  const names = { level_3m: "Level within 3 m", level_9m: "Level within 9 m", level_total: "Level all round, from the mean" };
  const level = datum.foundation || {};
  return Object.entries(names).filter(([key]) => level[key] && known(level[key].value)).map(([key, name]) => {
    const { value, sigma, azimuth_deg: azimuth } = level[key];
    return [name, millimetres(value), [plusMinus(sigma), known(azimuth) ? `at ${degrees(azimuth, 1)}` : ""].filter(Boolean).join(", ")];
  });
}

function drawOutOfPlane(svg, width, height, shown, rows) {
  const values = rows.flatMap((r) => (known(r.mm) ? [r.mm - (r.half || 0), r.mm + (r.half || 0)] : [r.fit]));
  const axes = azimuthAxes(svg, width, height, room(values), "Out-of-plane settlement [mm]");
  shadeGaps(svg, axes, height);
  drawLevel(svg, axes, 0, "zero");
  drawBand(svg, axes, rows, (r) => r.mm, (r) => r.half);
  drawLine(svg, axes, rows, (r) => r.mm, "datum");
  drawFew(svg, axes, rows, (r) => r.mm);
  if (shown.fit) drawLine(svg, axes, rows, (r) => r.fit, "fit");
  followPointer(svg, azimuthUnder(axes), (azimuth) => describeFit(azimuth));
  return azimuthMarks(svg, axes, height, (azimuth) => rows[stationAt(azimuth)].mm);
}

/** The station with its harmonic fit and curvature. */
function describeFit(azimuth) {
  const s = stations[stationAt(azimuth)], lines = describeStation(azimuth);
  if (known(s.u_fit)) lines.push(["Harmonic fit", millimetres(s.u_fit, 2)]);
  if (known(s.curvature)) lines.push(["Curvature", curvature(s.curvature)]);
  return lines;
}
