// The shell above the datum: its map unrolled, its roundness at heights, its plumbness.

function addShell() {
  const section = addSection("shell", "Shell");
  if (!usable) return sayAbsent(section, whyAbsent("Shell"));
  const shell = datum.shell || null;
  if (shell === null) {
    return sayAbsent(section, "Roundness, plumbness and the map of the shell: not in this result, because the scan shows too little of the shell above the datum.");
  }
  const rows = shellRows();
  if (rows.length > 0) addShellMap(section, rows);
  if (rows.length > 0) addRoundness(section, rows, shell.roundness || []);
  if ((shell.plumbness || []).length > 0) addPlumbness(section, shell);
  else section.append(make("p", { class: "absent" }, "Plumbness: none, because the shell is seen at one height only."));
}

/** The shell's points by height: [{height, points}], lowest first, deviations in mm. */
function shellRows() {
  const rows = new Map();
  for (const point of shellPoints) {
    const key = point.height.toFixed(3);
    if (!rows.has(key)) rows.set(key, { height: point.height, points: [] });
    rows.get(key).points.push({ ...point, mm: known(point.deviation) ? 1e3 * point.deviation : null });
  }
  return [...rows.values()].sort((a, b) => a.height - b.height);
}

/** What is known of the shell at an azimuth and height. */
function describeShell(row, azimuth) {
  const p = nearestRow(row.points, azimuth);
  if (p === null || angleApart(p.azimuth_deg, azimuth) > 2 * stepOfAzimuth()) return [["Not seen", `at ${degrees(azimuth, 1)}, ${metres(row.height, 2)} above the datum`]];
  return [["Shell", `at ${degrees(p.azimuth_deg, 1)}, ${metres(p.height, 2)} above the datum`],
    ["Off the circle", `${withUnit(p.mm, 1, "mm")} ${plusMinus(p.sigma)}`], ["Radius", metres(p.radius, 4)], ["Points", anyFigure(p.n)]];
}

function addRoundness(section, rows, rounds) {
  section.append(make("h3", {}, "Roundness at heights"));
  if (rounds.length === 0) section.append(make("p", { class: "absent" }, "Roundness: none, because the shell is not seen round enough of the tank at any height."));
  else section.append(roundnessTable(rounds));
  const colour = d3.scaleSequential([0, Math.max(1, rows.length - 1)], d3.interpolateViridis);
  const few = 7, every = Math.ceil(rows.length / few);
  addChart(section, {
    id: "roundness-chart", label: "Radial deviation of the shell against azimuth, at heights above the datum", ratio: 0.36, least: 280, most: 420,
    legend: rows.map((row, i) => ({ name: String(i), label: metres(row.height, 2), colour: colour(i), on: i % every === 0 })),
    draw: (svg, width, height, shown) => {
      const drawn = rows.filter((_, i) => shown[i]);
      const axes = azimuthAxes(svg, width, height, room([0, ...drawn.flatMap((row) => row.points.map((p) => p.mm))]), "Deviation from the circle, outwards positive [mm]");
      drawLevel(svg, axes, 0, "zero");
      rows.forEach((row, i) => {
        if (shown[i]) drawLine(svg, axes, withBreaks(row.points), (p) => p.mm, "height").style("stroke", colour(i));
      });
      followPointer(svg, azimuthUnder(axes), (azimuth) => [["Shell", `at ${degrees(azimuth, 1)}`], ...drawn.map((row) => {
        const p = nearestRow(row.points, azimuth);
        return [`${metres(row.height, 2)} up:`, p && angleApart(p.azimuth_deg, azimuth) < 2 * stepOfAzimuth() ? withUnit(p.mm, 1, "mm") : "not seen"];
      })]);
      return azimuthMarks(svg, axes, height, () => null);
    },
  });
}

/** Points with an unknown one wherever the next is further than two stations. */
function withBreaks(points) {
  const broken = [];
  points.forEach((p, i) => {
    if (i > 0 && p.azimuth_deg - points[i - 1].azimuth_deg > 2.5 * stepOfAzimuth()) broken.push({ azimuth_deg: p.azimuth_deg, mm: null });
    broken.push(p);
  });
  const open = points.length > 0 && points[0].azimuth_deg + 360 - points[points.length - 1].azimuth_deg > 2.5 * stepOfAzimuth();
  return open ? [{ azimuth_deg: 0, mm: null }, ...broken] : broken;
}

function roundnessTable(rounds) {
  return table(
    [["Height", "number"], ["Radius", "number"], ["Outwards", "number"], ["Inwards", "number"], ["Worst at", "number"], ["2\u03c3", "number"], ["Stations", "number"], ["Tolerance", "number"], ["Verdict"]],
    rounds.map((r) => [metres(r.height, 2), metres(r.radius, 4), millimetres(r.max_deviation), millimetres(r.min_deviation), degrees(r.azimuth_deg),
      known(r.sigma) ? millimetres(2 * r.sigma, 2) : kUnknown, anyFigure(r.n), millimetres(r.tolerance),
      make("td", { class: `verdict-word ${r.verdict}`, "data-head": "Verdict" }, words(r.verdict || ""))]),
    "Against the circle through each height; extremes of the shell smoothed along its arc.");
}

function addPlumbness(section, shell) {
  const rows = shell.plumbness.map((p) => ({ ...p, mm: known(p.offset) ? 1e3 * p.offset : null, half: known(p.sigma) ? 2e3 * p.sigma : null }));
  const nearest = (azimuth) => nearestRow(rows, azimuth);
  const lean = shell.lean ? ` The tank as a whole leans ${millimetres(shell.lean.offset)} over ${metres(shell.lean.height, 2)} towards ${degrees(shell.lean.direction_deg)}.` : "";
  section.append(make("h3", {}, "Plumbness"), make("p", {},
    `How far the top of what is seen stands outside of its foot; the most is ${millimetres(shell.plumbness_max)} at ${degrees(shell.plumbness_azimuth_deg, 1)}.${lean}`));
  addChart(section, {
    id: "plumbness-chart", label: "Plumbness of the shell against azimuth", ratio: 0.3, least: 250, most: 360,
    legend: [{ name: "offset", label: "offset of the top, \u00b1 2\u03c3 band", colour: "shell" }],
    draw: (svg, width, height) => {
      const axes = azimuthAxes(svg, width, height, room([0, ...rows.flatMap((r) => (known(r.mm) ? [r.mm - (r.half || 0), r.mm + (r.half || 0)] : []))]), "Offset of the top, outwards positive [mm]");
      drawLevel(svg, axes, 0, "zero");
      const broken = withBreaks(rows);
      drawBand(svg, axes, broken, (r) => r.mm, (r) => r.half);
      drawLine(svg, axes, broken, (r) => r.mm, "shell-line");
      followPointer(svg, azimuthUnder(axes), (azimuth) => {
        const r = nearest(azimuth);
        return [["Azimuth", degrees(r.azimuth_deg, 1)], ["Offset", `${withUnit(r.mm, 1, "mm")} over ${metres(r.height, 2)}`]];
      });
      return azimuthMarks(svg, axes, height, (azimuth) => nearest(azimuth).mm);
    },
  });
}
