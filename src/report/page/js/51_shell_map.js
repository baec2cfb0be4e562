// The shell unrolled: radial deviation as colour, height against azimuth.

const kMapOnPaper = 160;  // px: 42 mm
const kDeviationColours = ["#2166ac", "#92c5de", "#f2f2f2", "#f4a582", "#b2182b"];

function addShellMap(section, rows) {
  const all = rows.flatMap((row) => row.points.map((p) => p.value)).filter(known).map(Math.abs).sort(d3.ascending);
  const most = Math.max(toShort(0.001), d3.quantile(all, 0.98) || 0);
  const colour = d3.scaleLinear([-most, -most / 2, 0, most / 2, most], kDeviationColours).interpolate(d3.interpolateLab).clamp(true);
  const bands = heightBands(rows);
  section.append(make("h3", {}, say("shell_map.the_shell_unrolled")), make("p", { class: "quiet" },
    say("shell_map.radial_deviation_from_the_circle")));
  addChart(section, {
    id: "shell-map", label: say("shell_map.map_of_the_shells_radial"), ratio: rows.length < 4 ? 0.22 : 0.4, least: rows.length < 4 ? 200 : 300, most: 460, onPaper: kMapOnPaper,
    draw: (svg, width, height) => drawShellMap(svg, width, height, rows, bands, colour, most),
  });
}

/** [from, to] that each height stands for: half the way to its neighbours, in the long unit. */
function heightBands(rows) {
  const heights = rows.map((row) => toLong(row.height)), last = heights.length - 1;
  const gap = last > 0 ? Math.min(...d3.pairs(heights, (a, b) => b - a)) : toLong(0.2);
  return heights.map((h, i) => [i > 0 ? (heights[i - 1] + h) / 2 : Math.max(0, h - gap / 2), i < last ? (h + heights[i + 1]) / 2 : h + gap / 2]);
}

function drawShellMap(svg, width, height, rows, bands, colour, most) {
  const margin = { left: 62, right: 14, top: 46, bottom: 44 };
  const x = d3.scaleLinear([0, 360], [margin.left, width - margin.right]);
  const y = d3.scaleLinear([bands[0][0], bands[bands.length - 1][1]], [height - margin.bottom, margin.top]);
  const axes = { x, y, margin };
  drawAxes(svg, x, y, d3.range(0, 361, width < 480 ? 90 : 45), say("shell_map.height_above_the_datum", { unit: kLongUnit }), azimuthTitle());
  svg.append("rect").attr("class", "gap").attr("x", x(0)).attr("y", margin.top).attr("width", x(360) - x(0)).attr("height", y.range()[0] - margin.top);
  rows.forEach((row, i) => svg.append("image").attr("href", rowPicture(row, colour)).attr("preserveAspectRatio", "none")
    .style("image-rendering", "pixelated").attr("x", x(0)).attr("width", x(360) - x(0))
    .attr("y", y(bands[i][1])).attr("height", y(bands[i][0]) - y(bands[i][1])));
  drawDeviationKey(svg, width, colour, most);
  drawReferenceMarks(svg, axes, height);
  followMap(svg, axes, rows, bands);
  return azimuthMarks(svg, axes, height, () => null);
}

/** One height as a strip of pixels, a station each; stations lie in the middle of theirs. */
function rowPicture(row, colour) {
  const count = stations.length, canvas = make("canvas", { width: 2 * count, height: 1 }), paint = canvas.getContext("2d");
  for (const p of row.points) {
    if (!known(p.value)) continue;
    const left = Math.round((p.azimuth_deg / 360) * count) * 2 - 1;
    paint.fillStyle = colour(p.value);
    paint.fillRect(left, 0, 2, 1);
    if (left < 0) paint.fillRect(2 * count - 1, 0, 1, 1);
  }
  return canvas.toDataURL("image/png");
}

function drawDeviationKey(svg, width, colour, most) {
  const wide = Math.min(160, width / 3), left = width - wide - 70;
  d3.range(40).forEach((i) => svg.append("rect").attr("x", left + (i * wide) / 40).attr("y", 24).attr("width", wide / 40 + 0.5).attr("height", 10)
    .style("fill", colour(most * ((2 * i) / 39 - 1))));
  svg.append("text").attr("x", left - 6).attr("y", 33).attr("text-anchor", "end").text(`\u2212${inShort(most)}`);
  svg.append("text").attr("x", left + wide + 6).attr("y", 33).text(`+${inShort(most)}`);
}

/** The tip of the cell under the pointer. */
function followMap(svg, axes, rows, bands) {
  const node = svg.node();
  let row = rows[0];
  node.addEventListener("pointermove", (event) => {
    const box = node.getBoundingClientRect(), up = axes.y.invert(((event.clientY - box.top) * node.viewBox.baseVal.height) / box.height);
    const i = bands.findIndex(([from, to]) => up >= from && up < to);
    row = rows[i < 0 ? 0 : i];
  });
  followPointer(svg, azimuthUnder(axes), (azimuth) => describeShell(row, azimuth));
}
