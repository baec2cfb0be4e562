// What the charts against azimuth have in common: axes, shaded gaps, broken lines, marks.

/** {way, from} by which azimuths are counted; null where the page does not know. */
function azimuthConvention() {
  if (datum === null) return null;
  const { clockwise, zero_azimuth_deg: zero } = datum.options.stations;
  if (levelled && !clockwise && zero === 0) return null;
  return { way: say(clockwise ? "azimuth.clockwise" : "azimuth.counter_clockwise"),
    from: zero === 0 ? "+x" : say("azimuth.degrees_from_x", { angle: degrees(zero, 1) }) };
}

/** Of a levelling whose options do not say it, and of several surveys. */
const azimuthAsCounted = () => say(datum === null ? "azimuth.as_surveyed" : "azimuth.as_table");

function azimuthTitle() {
  const convention = azimuthConvention();
  return convention === null ? azimuthAsCounted() : say("azimuth.axis", convention);
}

/** Scales and axes of a chart against azimuth [deg]; `domain` of y in its unit. */
function azimuthAxes(svg, width, height, domain, title, bottom = azimuthTitle()) {
  const margin = { left: 62, right: 14, top: 26, bottom: 44 };
  const x = d3.scaleLinear([0, 360], [margin.left, width - margin.right]);
  const y = d3.scaleLinear(domain, [height - margin.bottom, margin.top]).nice();
  const every = width < 480 ? 90 : width < 800 ? 45 : 30;
  drawAxes(svg, x, y, d3.range(0, 361, every), title, bottom);
  drawReferenceMarks(svg, { x, y, margin }, height);
  return { x, y, margin };
}

/** Axes with titles; ticks of x given, or as many as fit. */
function drawAxes(svg, x, y, ticks, title, bottom) {
  const [left, right] = x.range(), [low, high] = y.range();
  const across = d3.axisLeft(y).ticks(Math.max(3, (low - high) / 45)).tickSize(left - right);
  svg.append("g").attr("class", "grid").attr("transform", `translate(${left},0)`).call(across)
    .selectAll("text").remove();
  svg.append("g").attr("class", "axis").attr("transform", `translate(0,${low})`)
    .call(ticks ? d3.axisBottom(x).tickValues(ticks) : d3.axisBottom(x).ticks(Math.max(3, (right - left) / 80)));
  svg.append("g").attr("class", "axis").attr("transform", `translate(${left},0)`)
    .call(d3.axisLeft(y).ticks(Math.max(3, (low - high) / 45)).tickSizeOuter(0));
  if (title) fitText(svg.append("text").attr("class", "axis-title").attr("x", 4).attr("y", 14).text(title), right - 4);
  fitText(svg.append("text").attr("class", "axis-title").attr("x", right).attr("y", low + 36).attr("text-anchor", "end").text(bottom), right - 4);
}

/** Letters as much smaller as a text needs to be at most so wide [px]. */
function fitText(text, most) {
  const wide = text.node().getComputedTextLength();
  if (wide > most) text.style("font-size", `${(12 * most) / wide}px`);
}

/** Stretches of stations without a datum, shaded and named. */
function shadeGaps(svg, axes, height) {
  const half = stepOfAzimuth() / 2, top = axes.margin.top, tall = height - axes.margin.bottom - top;
  for (const [first, last] of missingStretches()) {
    const from = Math.max(0, stations[first].azimuth_deg - half), to = Math.min(360, stations[last].azimuth_deg + half);
    svg.append("rect").attr("class", "gap").attr("x", axes.x(from)).attr("y", top)
      .attr("width", axes.x(to) - axes.x(from)).attr("height", tall);
    if (axes.x(to) - axes.x(from) > 44) {
      svg.append("text").attr("class", "gap-label").attr("x", axes.x((from + to) / 2)).attr("y", top + 14)
        .attr("text-anchor", "middle").text(say("common.not_seen"));
    }
  }
}

/** [first, last] of each run of missing stations, by index. */
function missingStretches() {
  const runs = [];
  stations.forEach((s, i) => {
    if (s.flag !== "missing") return;
    const open = runs.length > 0 && runs[runs.length - 1][1] === i - 1;
    if (open) runs[runs.length - 1][1] = i;
    else runs.push([i, i]);
  });
  return runs;
}

/** The rows with the first again at 360 degrees, so that a curve closes. */
function closed(rows) {
  return rows.length === 0 ? rows : [...rows, { ...rows[0], azimuth_deg: rows[0].azimuth_deg + 360 }];
}

/** A line of value(row) over azimuth, broken where it is unknown. */
function drawLine(svg, axes, rows, value, name) {
  const path = d3.line().defined((r) => known(value(r))).x((r) => axes.x(r.azimuth_deg)).y((r) => axes.y(value(r)));
  return svg.append("path").attr("class", `line ${name}`).attr("d", path(closed(rows)));
}

const kFew = 72;  // stations or fewer are each seen

/** The rows with a value where those are few, for a line from one to the next; else all, for a line with gaps. */
function fewOrAll(rows, value) {
  const seen = rows.filter((r) => known(value(r)));
  return seen.length > kFew ? rows : seen;
}

/** Dots on few stations: a line alone hides how far apart they are. */
function drawFew(svg, axes, rows, value) {
  if (rows.length > kFew) return;
  svg.append("g").selectAll("circle").data(rows.filter((r) => known(value(r)))).enter().append("circle").attr("class", "station")
    .attr("r", 3).attr("cx", (r) => axes.x(r.azimuth_deg)).attr("cy", (r) => axes.y(value(r)));
}

/** The band value(row) +- half(row). */
function drawBand(svg, axes, rows, value, half) {
  const area = d3.area().defined((r) => known(value(r)) && known(half(r))).x((r) => axes.x(r.azimuth_deg))
    .y0((r) => axes.y(value(r) - half(r))).y1((r) => axes.y(value(r) + half(r)));
  svg.append("path").attr("class", "band").attr("d", area(closed(rows)));
}

function drawLevel(svg, axes, value, name, label) {
  const [left, right] = axes.x.range();
  svg.append("line").attr("class", name).attr("x1", left).attr("x2", right).attr("y1", axes.y(value)).attr("y2", axes.y(value));
  if (label) svg.append("text").attr("x", right - 4).attr("y", axes.y(value) - 5).attr("text-anchor", "end").text(label);
}

/** The value on the line from station to station at an azimuth; the nearest station's where its neighbour's is unknown. */
function valueAlong(rows, azimuth) {
  const i = stationAt(azimuth), here = rows[i], ahead = ((azimuth - here.azimuth_deg + 540) % 360) - 180;
  const next = rows[(i + (ahead < 0 ? rows.length - 1 : 1)) % rows.length], apart = angleApart(next.azimuth_deg, here.azimuth_deg);
  if (!known(here.value) || !known(next.value) || apart === 0) return here.value;
  return here.value + (Math.abs(ahead) / apart) * (next.value - here.value);
}

/** Vertical marks and a dot on value(azimuth) for the chosen and the hovered azimuth. */
function azimuthMarks(svg, axes, height, value) {
  const place = (name) => {
    const bar = svg.append("line").attr("class", name).attr("y1", axes.margin.top).attr("y2", height - axes.margin.bottom);
    const dot = svg.append("circle").attr("class", name).attr("r", 4.5);
    return (azimuth) => {
      bar.attr("visibility", azimuth === null ? "hidden" : null);
      const at = azimuth === null ? null : value(azimuth);
      dot.attr("visibility", known(at) ? null : "hidden");
      if (azimuth !== null) bar.attr("x1", axes.x(azimuth)).attr("x2", axes.x(azimuth));
      if (known(at)) dot.attr("cx", axes.x(azimuth)).attr("cy", axes.y(at));
    };
  };
  const chosen = place("chosen"), hovered = place("hovered");
  return (choice, hover) => {
    chosen(choice);
    hovered(hover);
  };
}

/** The azimuth under the pointer, on a station; null beside the axes. */
function azimuthUnder(axes) {
  return (px) => {
    const azimuth = axes.x.invert(px);
    if (azimuth < -1 || azimuth > 361) return null;
    const step = stepOfAzimuth();
    return (Math.round(azimuth / step) * step + 360) % 360;
  };
}

/** Lower and upper end of values with some room. */
function room(values, share = 0.08) {
  const [low, high] = d3.extent(values.filter(known));
  if (low === undefined) return [-1, 1];
  const add = Math.max(share * (high - low), 1e-9 + 0.02 * Math.abs(high - low), high === low ? 1 : 0);
  return [low - add, high + add];
}
