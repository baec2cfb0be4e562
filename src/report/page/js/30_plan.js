// The tank from above, its settlement drawn outwards and inwards of the ring.

const plan = { exaggeration: 1 };
const kAzimuthGap = 18;  // px: from the ring's ticks to their azimuths
const kPlanOnPaper = 265;  // px: 70 mm
const kSmallRing = 95;  // px: in a smaller one there is no room for words
const kNarrow = 520;  // px: below it the colours' key stands under the plan

function addPlan() {
  const section = addSection("plan", say("plan.plan"));
  if (!usable) return sayAbsent(section, whyAbsent(say("plan.plan")));
  const largest = d3.max(stations, (s) => (known(s.z) ? Math.abs(s.z - datum.datum.mean) : 0)) || 1e-3;
  const strongest = (0.32 * datum.tank.radius) / largest;
  const slider = make("input", { type: "range", id: "exaggeration", min: 0, max: 100, step: 1, value: 90 });
  const shown = make("output", { for: "exaggeration" });
  const set = () => {
    plan.exaggeration = strongest * 10 ** ((Number(slider.value) - 100) / 50);
    shown.textContent = `\u00d7 ${Number(plan.exaggeration.toPrecision(2))}`;
  };
  set();
  section.append(make("p", { class: "quiet" }, say("plan.seen_from_above_the_curve"), make("span", { class: "screen-only" }, say("plan.click_it_for_a_station")), "."),
    make("div", { class: "controls" }, make("label", { for: "exaggeration" }, say("plan.exaggeration_of_the_settlement")), slider, shown));
  const chart = addChart(section, {
    id: "plan-chart", label: say("plan.plan_of_the_tank_with"), ratio: (width) => (width < kNarrow ? 1.34 : 0.78), least: 330, most: 640,
    legend: [{ name: "ring", label: say("plan.datum"), colour: "datum" },
      ...(datum.tilt ? [{ name: "tilt", label: `${say("plan.tilt_pointing_up")}: ${tiltText()}`, colour: "fit", on: true }] : []),
      ...(datum.antipodal && known(datum.antipodal.max_h) ? [{ name: "diameter", label: `${say("plan.worst_diameter")}: ${shortLength(datum.antipodal.max_h)}`, colour: "reference", on: true }] : [])],
    remark: planConvention(), onPaper: kPlanOnPaper, draw: drawPlan,
  });
  slider.addEventListener("input", () => {
    set();
    drawChart(chart);
  });
}

function drawPlan(svg, width, height, shown) {
  const middle = [width / 2, Math.min(width, height) / 2 + (width < kNarrow ? 10 : 0)], most = Math.min(width, height);
  const ring = Math.min(0.33 * most, (0.5 * most - kAzimuthGap - 14) / 1.36);  // with room for the azimuths

  const place = (azimuth, radius) => {
    const turn = (directionOf(azimuth) * Math.PI) / 180;
    return [middle[0] + radius * Math.cos(turn), middle[1] - radius * Math.sin(turn)];
  };
  const offset = (s) => ring * (1 + (plan.exaggeration * (s.z - datum.datum.mean)) / datum.tank.radius);
  drawPlanFrame(svg, middle, ring, place);
  const colour = heightColours();
  const close = closed(stations);
  const band = d3.line().defined((s) => known(s.z)).x((s) => place(s.azimuth_deg, offset(s))[0]).y((s) => place(s.azimuth_deg, offset(s))[1]);
  svg.append("path").attr("class", "line datum").attr("d", band(close));
  svg.append("g").selectAll("circle").data(stations.filter((s) => known(s.z))).enter().append("circle").attr("r", 3)
    .attr("cx", (s) => place(s.azimuth_deg, offset(s))[0]).attr("cy", (s) => place(s.azimuth_deg, offset(s))[1])
    .style("fill", (s) => colour(s.z - datum.datum.mean));
  if (shown.tilt) drawTiltArrow(svg, place, ring);
  if (shown.diameter) drawDiameter(svg, place, ring);
  drawColourKey(svg, height, colour);
  drawPlanMarks(svg, place, ring);
  drawNorth(svg, width);
  drawPlanScale(svg, width, height, ring);
  const step = stepOfAzimuth();
  followPointer(svg, (px, py) => {
    const dx = px - middle[0], dy = middle[1] - py;
    if (Math.hypot(dx, dy) < 0.4 * ring) return null;
    const turn = (Math.atan2(dy, dx) * 180) / Math.PI, options = datum.options.stations;
    const azimuth = options.clockwise ? options.zero_azimuth_deg - turn : turn - options.zero_azimuth_deg;
    return (((Math.round(azimuth / step) * step) % 360) + 360) % 360;
  }, describeStation);
  return planMarks(svg, place, ring, offset);
}

/** How azimuths are counted on a plan. */
function planConvention() {
  const convention = azimuthConvention();
  return convention === null ? azimuthAsCounted() : say("azimuth.plan", convention);
}

/** The ring at the mean elevation, azimuths every 30 degrees, the zero mark and the frame's axes. */
function drawPlanFrame(svg, middle, ring, place) {
  svg.append("circle").attr("class", "ring").attr("cx", middle[0]).attr("cy", middle[1]).attr("r", ring);
  for (let azimuth = 0; azimuth < 360; azimuth += 30) {
    const [x1, y1] = place(azimuth, 1.36 * ring), [x2, y2] = place(azimuth, azimuth === 0 ? 1.26 * ring : 1.33 * ring);
    svg.append("line").attr("class", "zero").attr("x1", x1).attr("y1", y1).attr("x2", x2).attr("y2", y2)
      .style("stroke-width", azimuth === 0 ? 3 : 1);
    const [x, y] = place(azimuth, 1.36 * ring + kAzimuthGap);
    svg.append("text").attr("x", x).attr("y", y + 4).attr("text-anchor", "middle").attr("class", "axis-title").text(`${azimuth}\u00b0`);
  }
  if (datum === null) return;
  const corner = [26, 56], long = 22;
  const axis = svg.append("g").attr("class", "axis");
  axis.append("line").attr("x1", corner[0]).attr("y1", corner[1]).attr("x2", corner[0] + long).attr("y2", corner[1]);
  axis.append("line").attr("x1", corner[0]).attr("y1", corner[1]).attr("x2", corner[0]).attr("y2", corner[1] - long);
  svg.append("text").attr("x", corner[0] + long + 4).attr("y", corner[1] + 4).text("x");
  svg.append("text").attr("x", corner[0] - 4).attr("y", corner[1] - long - 5).text("y");
}

/** Colour of a height above the mean [m]. */
function heightColours() {
  const most = d3.max(stations, (s) => (known(s.z) ? Math.abs(s.z - datum.datum.mean) : 0)) || 1e-3;
  const scale = d3.scaleLinear([-most, 0, most], ["#2166ac", "#9aa0a6", "#b2182b"]).interpolate(d3.interpolateLab);
  scale.most = most;
  return scale;
}

function drawColourKey(svg, height, colour) {
  const tall = 90, left = 14, top = height - tall - 24;
  d3.range(30).forEach((i) => svg.append("rect").attr("x", left).attr("y", top + (i * tall) / 30).attr("width", 12)
    .attr("height", tall / 30 + 0.5).style("fill", colour(colour.most * (1 - (2 * i) / 29))));
  [[top + 8, colour.most], [top + tall / 2 + 4, 0], [top + tall, -colour.most]].forEach(([y, value]) => (
    svg.append("text").attr("x", left + 18).attr("y", y).text(value === 0 ? say("plan.mean") : `${value > 0 ? "+" : "\u2212"}${shortLength(Math.abs(value))}`)));
}

const tiltText = () => `${figure(datum.tilt.angle_arcsec, 0)}\u2033`;

/** 1 where the worst diameter's high end lies further round than the tilt's, else -1: labels keep off the other line. */
function diameterBeyondTilt() {
  if (!datum.tilt || !datum.antipodal || !known(datum.antipodal.azimuth_deg)) return 1;
  return ((datum.antipodal.azimuth_deg - datum.tilt.direction_deg + 540) % 360) - 180 < 0 ? -1 : 1;
}

/** Text beside a line through the centre, on the side of growing (1) or falling (-1) azimuths. */
function labelBeside(svg, place, azimuth, radius, side, text) {
  if (radius < 0.4 * kSmallRing) return;
  const [x, y] = place(azimuth, radius), [x2, y2] = place(azimuth + side, radius), step = Math.hypot(x2 - x, y2 - y);
  const across = (x2 - x) / step, down = (y2 - y) / step, anchor = across > 0.35 ? "start" : across < -0.35 ? "end" : "middle";
  svg.append("text").attr("class", "plan-label").attr("x", x + 9 * across).attr("y", y + 9 * down + 4).attr("text-anchor", anchor).text(text);
}

function drawTiltArrow(svg, place, ring) {
  drawArrow(svg, place, ring, datum.tilt.direction_deg, say("plan.tilt", { value: tiltText() }), -diameterBeyondTilt());
}

/** An arrow through the centre towards the side that is, or went, up. */
function drawArrow(svg, place, ring, up, label, beside = -1) {
  const [x1, y1] = place(up + 180, 0.5 * ring), [x2, y2] = place(up, 0.6 * ring);
  svg.append("line").attr("class", "arrow").attr("x1", x1).attr("y1", y1).attr("x2", x2).attr("y2", y2);
  const turn = Math.atan2(y2 - y1, x2 - x1), wing = (side) => [x2 - 12 * Math.cos(turn + side), y2 - 12 * Math.sin(turn + side)];
  svg.append("path").attr("class", "arrow-head").attr("d", d3.line()([[x2, y2], wing(0.4), wing(-0.4)]));
  labelBeside(svg, place, up, 0.42 * ring, beside, label);
}

function drawDiameter(svg, place, ring) {
  const high = datum.antipodal.azimuth_deg, [x1, y1] = place(high, ring), [x2, y2] = place(high + 180, ring);
  svg.append("line").attr("class", "diameter").attr("x1", x1).attr("y1", y1).attr("x2", x2).attr("y2", y2);
  labelBeside(svg, place, high + 180, 0.5 * ring, diameterBeyondTilt(), shortLength(datum.antipodal.max_h));
}

function planMarks(svg, place, ring, offset) {
  const mark = (name) => {
    const line = svg.append("line").attr("class", name), dot = svg.append("circle").attr("class", name).attr("r", 5.5);
    return (azimuth) => {
      const s = azimuth === null ? null : stations[stationAt(azimuth)];
      line.attr("visibility", s ? null : "hidden");
      dot.attr("visibility", s && known(s.z) ? null : "hidden");
      if (!s) return;
      const [x1, y1] = place(s.azimuth_deg, 0.86 * ring), [x2, y2] = place(s.azimuth_deg, 1.3 * ring);
      line.attr("x1", x1).attr("y1", y1).attr("x2", x2).attr("y2", y2);
      if (known(s.z)) dot.attr("cx", place(s.azimuth_deg, offset(s))[0]).attr("cy", place(s.azimuth_deg, offset(s))[1]);
    };
  };
  const chosen = mark("chosen"), hovered = mark("hovered");
  return (choice, hover) => {
    chosen(choice);
    hovered(hover);
  };
}
