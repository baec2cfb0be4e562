// What is left when the tilt is taken away: the shape that strains the shell.

function addOutOfPlane() {
  const section = addSection("out-of-plane", say("common.out_of_plane"));
  if (!usable) return sayAbsent(section, whyAbsent(say("out_of_plane.out_of_plane_settlement")));
  const found = datum.out_of_plane || null, fit = (found && found.u_fit_sigma) || [];
  const rows = stations.map((s, i) => ({ ...s, value: toShort(s.u), half: toShort(twice(s.sigma_z)),
    fit: toShort(s.u_fit), fitHalf: toShort(twice(fit[i])) }));
  const hasFit = rows.some((r) => known(r.fit)), sigmas = rows.some((r) => known(r.half));
  section.append(make("p", { class: "quiet" }, say("out_of_plane.elevation_less_the_fitted_tilt")));
  const facts = [...outOfPlaneFacts(found), ...levelFacts()];
  if (facts.length > 0) section.append(boxes(facts));
  if (isRaised(found)) section.append(make("p", { class: "quiet" }, say("out_of_plane.raised")));
  addChart(section, {
    id: "out-of-plane-chart", label: say("out_of_plane.out_of_plane_settlement_against"), ratio: 0.34, least: 280, most: 400,
    legend: [{ name: "u", label: say("out_of_plane.out_of_plane_settlement_2", { k_band_words: sigmas ? kBandWords : "" }), colour: "datum" },
      ...(hasFit ? [{ name: "fit", label: say("out_of_plane.harmonic_fit"), colour: "fit", on: true }] : [])],
    draw: (svg, width, height, shown) => drawOutOfPlane(svg, width, height, shown, rows),
  });
  if (!hasFit) sayAbsent(section, whyNoFit());
  addPaperPair(section, (part) => hasFit && addCurvature(part, found),
    (part) => hasSection("harmonics") && datum.harmonics.length > 0 && addHarmonics(part));
}

const fineFigure = (metres) => shortFigure(metres, 2);
const fineLength = (metres) => shortLength(metres, 2);

/** The interval of a magnitude as that of a signed figure. */
const signedEnds = (interval, sign) => (interval && sign < 0 ? [-interval[1], -interval[0]] : interval);

/** "95 %: 8.1 to 32.0 mm" of a maximum, whose interval reaches further up than down; empty of none. */
function between95(interval, low, high) {
  return interval && interval.every(known) ? say("checks.interval", { low: low(interval[0]), high: high(interval[1]) }) : "";
}

/** Whether one of its largest figures lies above its own interval. */
function isRaised(found) {
  const levels = (datum.checks || []).filter((c) => c.name.startsWith("foundation level"));
  const all = [[found && found.max_abs_u, ((found && found.max_abs_u_95) || [])[1]], ...levels.map((c) => [c.value, c.high95])];
  return all.some(([value, high]) => known(value) && known(high) && value > high);
}

/** The largest settlement, the harmonic fit, its curvature and the classic rule's figure. */
function outOfPlaneFacts(found) {
  if (found === null) return [];
  const place = nearestRow(stations.filter((s) => known(s.u)), found.max_abs_u_azimuth_deg), down = place && place.u < 0 ? -1 : 1;
  const list = [], at = (azimuth) => say("movement.rest.where", { azimuth: degrees(azimuth, 1) });
  if (known(found.max_abs_u)) list.push([say("out_of_plane.largest_departure"), signed(fineLength(down * found.max_abs_u), down * found.max_abs_u), [between95(signedEnds(found.max_abs_u_95, down), fineFigure, fineLength), at(found.max_abs_u_azimuth_deg)].filter(Boolean).join(", ")]);
  if (known(found.max_curvature)) {
    list.push([say("out_of_plane.harmonic_fit_2"), say("out_of_plane.waves_2_to", { order: found.order }), say("out_of_plane.left_rms_adjusted_r", { rms: shortLength(found.rms, 2), adjusted_r2: figure(found.adjusted_r2, 4) })]);
    const interval = between95(found.max_curvature_95, (value) => figure(bend(value), 1), (value) => figure(bend(value), 1));
    const limit = known(found.curvature_limit) ? say("out_of_plane.limit", { curvature_limit: figure(bend(found.curvature_limit), 1) }) : "";
    list.push([say("out_of_plane.largest_curvature"), curvature(found.max_curvature), `${[interval, at(found.max_curvature_azimuth_deg)].filter(Boolean).join(", ")}${limit}`]);
  }
  if (found.top_ovality) {
    const { value, low95, high95, azimuth_deg: azimuth } = found.top_ovality;
    const between = between95([low95, high95], fineFigure, fineLength);
    list.push([say("out_of_plane.ovality_of_the_shells_top"), fineLength(value), say("out_of_plane.a_floating_roofs_rim_seal", { between: between ? `${between}, ` : "", azimuth: at(azimuth) })]);
  }
  // its spacing is rounded before it is put in feet, as in the note of its check
  const classic = found.second_differences, worst = classic && classic.worst;
  if (worst && known(worst.value)) {
    list.push([say("out_of_plane.second_difference_s_i"), shortLength(worst.value),
      say("out_of_plane.points_apart", { azimuth_deg: at(worst.azimuth_deg), points: classic.points, spacing: longLength(Number(classic.spacing.toFixed(2)), 2), starts: say("count.start_angle", { count: classic.starts }) })]);
  }
  return list;
}

/** How level the foundation is: differences within a length and over the circumference. */
function levelFacts() {
  const [near, far] = kLongUnit === "m" ? ["3 m", "9 m"] : ["10 ft", "30 ft"];  // as the codes have them
  const names = { level_3m: say("out_of_plane.level_within", { near }), level_9m: say("out_of_plane.level_within_2", { far }), level_total: say("out_of_plane.level_all_round_from_the") };
  const level = datum.foundation || {};
  return Object.entries(names).filter(([key]) => level[key] && known(level[key].value)).map(([key, name]) => {
    const { value, sigma, azimuth_deg: azimuth } = level[key];
    const check = (datum.checks || []).find((c) => c.name.startsWith("foundation level") && c.value === value);
    return [name, shortLength(value), [check ? intervalOf(check) : plusMinus(sigma), known(azimuth) ? say("movement.rest.where", { azimuth: degrees(azimuth, 1) }) : ""].filter(Boolean).join(", ")];
  });
}

function drawOutOfPlane(svg, width, height, shown, rows) {
  const values = rows.flatMap((r) => (known(r.value) ? [r.value - (r.half || 0), r.value + (r.half || 0)] : [r.fit]));
  const axes = azimuthAxes(svg, width, height, room(values), say("out_of_plane.out_of_plane_settlement_3", { unit: kShortUnit }));
  shadeGaps(svg, axes, height);
  drawLevel(svg, axes, 0, "zero");
  drawBand(svg, axes, rows, (r) => r.value, (r) => r.half);
  drawLine(svg, axes, rows, (r) => r.value, "datum");
  drawFew(svg, axes, rows, (r) => r.value);
  if (shown.fit) drawLine(svg, axes, rows, (r) => r.fit, "fit");
  followPointer(svg, azimuthUnder(axes), (azimuth) => describeFit(azimuth));
  return azimuthMarks(svg, axes, height, (azimuth) => valueAlong(rows, azimuth));
}

/** The station with its harmonic fit and curvature. */
function describeFit(azimuth) {
  const s = stations[stationAt(azimuth)], lines = describeStation(azimuth);
  if (known(s.u_fit)) lines.push([say("out_of_plane.harmonic_fit_2"), shortLength(s.u_fit, 2)]);
  if (known(s.curvature)) lines.push([say("out_of_plane.curvature"), curvature(s.curvature)]);
  return lines;
}
