// The shell above the datum: its map unrolled, its roundness at heights, its plumbness.

function addShell() {
  const section = addSection("shell", say("common.shell"));
  if (!usable) return sayAbsent(section, whyAbsent(say("common.shell")));
  const shell = datum.shell || null;
  if (shell === null) return sayAbsent(section, whyNoShell());
  const rows = shellRows();
  if (hasRoundness()) {
    addShellMap(section, rows);
  } else {
    sayAbsent(section, kNoRoundness);
  }
  if (hasRoundness()) section.append(make("h3", {}, say("shell.roundness_at_heights")), roundnessTable(shell.roundness || []));
  addPaperPair(section, (part) => hasRoundness() && addRoundness(part, rows, shell.roundness || []),
    (part) => hasPlumbness() && addPlumbness(part, shell));
  if (!hasPlumbness()) sayAbsent(section, kNoPlumbness);
}

/** The shell's points by height: [{height, points}], lowest first, deviations in the short unit; heights without a circle left out. */
function shellRows() {
  const rows = new Map();
  for (const point of shellPoints) {
    const key = point.height.toFixed(3);
    if (!rows.has(key)) rows.set(key, { height: point.height, points: [] });
    rows.get(key).points.push({ ...point, value: toShort(point.deviation) });
  }
  return [...rows.values()].filter((row) => row.points.some((p) => known(p.value))).sort((a, b) => a.height - b.height);
}

/** What is known of the shell at an azimuth and height. */
function describeShell(row, azimuth) {
  const p = nearestRow(row.points, azimuth);
  if (p === null || angleApart(p.azimuth_deg, azimuth) > 2 * stepOfAzimuth()) return [[say("shell.not_seen"), say("shell.at_above_the_datum", { azimuth: degrees(azimuth, 1), height: longLength(row.height, 2) })]];
  return [[say("common.shell"), say("shell.at_above_the_datum_2", { azimuth_deg: degrees(p.azimuth_deg, 1), height: longLength(p.height, 2) })],
    [say("shell.off_the_circle"), `${inShort(p.value, 1)} ${plusMinus(p.sigma)}`], [say("common.radius"), longLength(p.radius, 4)], [say("common.points"), anyFigure(p.n)]];
}

const kHeightColours = ["#2f7fd0", "#9a5fd0", "#d04f80", "#d9730d"];  // lowest to highest; read on white and on black

/** An entry of a legend for a tolerance in the page's unit; off where it lies so far out that it would flatten the chart. */
function toleranceLegend(tolerance, values) {
  if (!known(tolerance)) return [];
  const reach = d3.max(values.filter(known), Math.abs) || 0;
  return [{ name: "tolerance", label: say("shell.tolerance", { value: inShort(tolerance) }), colour: "fail", on: tolerance < 4 * reach }];
}

const toleranceEnds = (shown, tolerance) => (shown.tolerance ? [-tolerance, tolerance] : []);

/** What lies beyond a tolerance, shaded, with its ends. */
function drawTolerance(svg, axes, shown, tolerance) {
  if (!shown.tolerance) return;
  const [left, right] = axes.x.range(), [low, high] = axes.y.range();
  for (const [end, edge] of [[tolerance, high], [-tolerance, low]]) {
    const at = axes.y(end);
    svg.append("rect").attr("class", "beyond").attr("x", left).attr("width", right - left).attr("y", Math.min(at, edge)).attr("height", Math.abs(at - edge));
    drawLevel(svg, axes, end, "limit");
  }
}

function addRoundness(section, rows, rounds) {
  const tolerance = toShort(d3.min(rounds.map((r) => r.tolerance).filter(known)));
  const colour = d3.scaleSequential([0, Math.max(1, rows.length - 1)], d3.interpolateRgbBasis(kHeightColours));
  const few = 7, every = Math.ceil(rows.length / few);
  addChart(section, {
    id: "roundness-chart", label: say("shell.radial_deviation_of_the_shell"), ratio: 0.36, least: 280, most: 420,
    legend: [...rows.map((row, i) => ({ name: String(i), label: longLength(row.height, 2), colour: colour(i), on: i % every === 0 })),
      ...toleranceLegend(tolerance, rows.flatMap((row) => row.points.map((p) => p.value)))],
    draw: (svg, width, height, shown) => {
      const drawn = rows.filter((_, i) => shown[i]);
      const axes = azimuthAxes(svg, width, height, room([0, ...drawn.flatMap((row) => row.points.map((p) => p.value)), ...toleranceEnds(shown, tolerance)]), say("shell.deviation_from_the_circle_outwards", { unit: kShortUnit }));
      drawLevel(svg, axes, 0, "zero");
      drawTolerance(svg, axes, shown, tolerance);
      rows.forEach((row, i) => {
        if (shown[i]) drawLine(svg, axes, withBreaks(row.points), (p) => p.value, "height").style("stroke", colour(i));
      });
      followPointer(svg, azimuthUnder(axes), (azimuth) => [[say("common.shell"), say("movement.rest.where", { azimuth: degrees(azimuth, 1) })], ...drawn.map((row) => {
        const p = nearestRow(row.points, azimuth);
        return [say("shell.up", { height: longLength(row.height, 2) }), p && angleApart(p.azimuth_deg, azimuth) < 2 * stepOfAzimuth() ? inShort(p.value, 1) : say("common.not_seen")];
      })]);
      return azimuthMarks(svg, axes, height, () => null);
    },
  });
}

/** Points with an unknown one wherever the next is further than two stations. */
function withBreaks(points) {
  const broken = [];
  points.forEach((p, i) => {
    if (i > 0 && p.azimuth_deg - points[i - 1].azimuth_deg > 2.5 * stepOfAzimuth()) broken.push({ azimuth_deg: p.azimuth_deg, value: null });
    broken.push(p);
  });
  const open = points.length > 0 && points[0].azimuth_deg + 360 - points[points.length - 1].azimuth_deg > 2.5 * stepOfAzimuth();
  return open ? [{ azimuth_deg: 0, value: null }, ...broken] : broken;
}

const kHeightsOnPaper = 8;

/** A table of more heights than paper has room for leaves out every other one that passes. */
/** Said where the tolerances are of tanks of another service: then they judge nothing. */
function forComparison() {
  const rule = (datum.checks || []).find((check) => check.name.startsWith("radius ") && check.role === "for comparison");
  const clause = rule && rule.note.split("; ").find((part) => part.startsWith("for comparison"));
  return clause ? sentence(translated(clause)) : "";
}

function roundnessTable(rounds) {
  const between = (r, i) => rounds.length > kHeightsOnPaper && i % 2 === 1 && r.verdict !== "fail" && r.verdict !== "undecided";
  return table(
    [[say("common.height"), "number"], [say("common.radius"), "number"], [say("shell.outwards"), "number"], [say("shell.inwards"), "number"], [say("shell.worst_at"), "number"], ["2\u03c3", "number"], [say("common.stations"), "number"], [say("shell.tolerance_2"), "number"], [say("common.verdict")]],
    rounds.map((r, i) => [longLength(r.height, 2), longLength(r.radius, 4), shortLength(r.max_deviation), shortLength(r.min_deviation), degrees(r.azimuth_deg),
      known(r.sigma) ? shortLength(2 * r.sigma, 2) : kUnknown, anyFigure(r.n), shortLength(r.tolerance),
      make("td", { class: `verdict-word ${r.verdict}${between(r, i) ? " between" : ""}`, "data-head": say("common.verdict") }, make("span", {}, words(r.verdict || "")))]),
    [say("shell.against_the_circle_through_each"), forComparison()].filter(Boolean).join(" "));
}
