// The shell above the datum: its map unrolled, its roundness at heights, its plumbness.

function addShell() {
  const section = addSection("shell", "Shell");
  if (!usable) return sayAbsent(section, whyAbsent("Shell"));
  const shell = datum.shell || null;
  if (shell === null) return sayAbsent(section, whyNoShell());
  const rows = shellRows();
  if (hasRoundness()) {
    addShellMap(section, rows);
    addRoundness(section, rows, shell.roundness || []);
  } else {
    sayAbsent(section, kNoRoundness);
  }
  if (hasPlumbness()) addPlumbness(section, shell);
  else sayAbsent(section, kNoPlumbness);
}

/** The shell's points by height: [{height, points}], lowest first, deviations in mm; heights without a circle left out. */
function shellRows() {
  const rows = new Map();
  for (const point of shellPoints) {
    const key = point.height.toFixed(3);
    if (!rows.has(key)) rows.set(key, { height: point.height, points: [] });
    rows.get(key).points.push({ ...point, mm: known(point.deviation) ? 1e3 * point.deviation : null });
  }
  return [...rows.values()].filter((row) => row.points.some((p) => known(p.mm))).sort((a, b) => a.height - b.height);
}

/** What is known of the shell at an azimuth and height. */
function describeShell(row, azimuth) {
  const p = nearestRow(row.points, azimuth);
  if (p === null || angleApart(p.azimuth_deg, azimuth) > 2 * stepOfAzimuth()) return [["Not seen", `at ${degrees(azimuth, 1)}, ${metres(row.height, 2)} above the datum`]];
  return [["Shell", `at ${degrees(p.azimuth_deg, 1)}, ${metres(p.height, 2)} above the datum`],
    ["Off the circle", `${withUnit(p.mm, 1, "mm")} ${plusMinus(p.sigma)}`], ["Radius", metres(p.radius, 4)], ["Points", anyFigure(p.n)]];
}

const kHeightColours = ["#2f7fd0", "#9a5fd0", "#d04f80", "#d9730d"];  // lowest to highest; read on white and on black

function addRoundness(section, rows, rounds) {
  section.append(make("h3", {}, "Roundness at heights"));
  section.append(roundnessTable(rounds));
  const colour = d3.scaleSequential([0, Math.max(1, rows.length - 1)], d3.interpolateRgbBasis(kHeightColours));
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
      make("td", { class: `verdict-word ${r.verdict}`, "data-head": "Verdict" }, make("span", {}, words(r.verdict || "")))]),
    "Against the circle through each height; extremes of the shell smoothed along its arc.");
}
