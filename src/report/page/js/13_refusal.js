// A scan without a datum: the reason, a picture of what was looked at, and what to try.

/** The points seen in lengths of the page: from the circle's centre and its foot, or without one in the scan's frame. */
function sightedPoints() {
  const from = sighting.from.map((c, i) => (known(i < 2 ? sighting.radius : sighting.foot) ? 0 : c));
  const at = (steps, i) => steps.map((step) => toLong(from[i] + step * sighting.step));
  const [x, y, z] = [sighting.x, sighting.y, sighting.z].map(at);
  return x.map((east, i) => ({ x: east, y: y[i], z: z[i] }));
}

function addRefusal() {
  const section = addSection("summary", say("refusal.heading"));
  section.append(verdictBox(), ...refusalTests());
  if (sighting !== null) addSighting(section);
  const advice = datum.advice || [];
  section.append(make("h3", {}, say("refusal.try")), advice.length === 0 ? make("p", {}, say("refusal.no_advice"))
    : make("ol", { class: "advice" }, advice.map((line) => make("li", {}, typeset(translated(line))))));
  if (kSpoken !== kLanguages.en) section.append(make("p", { class: "quiet" }, say("missing.in_english")));
}

/** What fails of the tests of whether it is a tank. */
function refusalTests() {
  const failing = (datum.tests || []).filter((test) => test.finding);
  if (failing.length < 2) return [];
  return [make("h3", {}, say("refusal.tests")), make("ul", {}, failing.map((test) => make("li", {}, typeset(sentence(translated(test.finding))))))];
}

function addSighting(section) {
  const points = sightedPoints(), tried = known(sighting.radius), radius = toLong(sighting.radius);
  const pair = make("div", { class: "pair" });
  section.append(make("h3", {}, say("refusal.looked_at")),
    make("p", { class: "quiet" }, say(tried ? "refusal.sample" : "refusal.sample_no_circle", { count: points.length })), pair);
  const legend = [{ name: "points", label: say("refusal.points"), colour: "shell" }];
  if (tried) legend.push({ name: "circle", label: say("refusal.circle", { radius: longLength(sighting.radius, 2) }), colour: "fail" });
  addChart(pair, { id: "sighting-plan", label: say("refusal.plan"), ratio: 0.9, least: 280, most: 460, legend,
    draw: (svg, width, height) => drawSightedPlan(svg, width, height, points, radius) });
  addChart(pair, { id: "sighting-section", label: say("refusal.section"), ratio: 0.9, least: 280, most: 460,
    legend: known(sighting.foot) ? [{ name: "foot", label: say("refusal.foot"), colour: "foundation" }] : [],
    draw: (svg, width, height) => drawSightedSection(svg, width, height, points, radius) });
}

/** Axes of one scale for both ways, that hold all points and the circle. */
function equalScales(width, height, points, radius) {
  const reach = known(radius) ? [-radius, radius] : [];
  const [x0, x1] = d3.extent([...points.map((p) => p.x), ...reach]), [y0, y1] = d3.extent([...points.map((p) => p.y), ...reach]);
  const left = 62, right = width - 14, low = height - 44, high = 26;
  const half = 0.53 * Math.max((x1 - x0) / (right - left), (y1 - y0) / (low - high), 1e-9);
  const around = (a, b, pixels) => [(a + b) / 2 - half * pixels, (a + b) / 2 + half * pixels];
  return { x: d3.scaleLinear(around(x0, x1, right - left), [left, right]), y: d3.scaleLinear(around(y0, y1, low - high), [low, high]), perUnit: 0.5 / half };
}

function drawSightedPoints(svg, points, x, y) {
  const square = points.map((p) => `M${x(p).toFixed(1)},${y(p).toFixed(1)}h1.6v1.6h-1.6z`);
  svg.append("path").attr("class", "sighted").attr("d", square.join(""));
}

function drawSightedPlan(svg, width, height, points, radius) {
  const { x, y, perUnit } = equalScales(width, height, points, radius);
  const key = known(radius) ? "refusal.from_centre" : "refusal.of_frame";
  drawAxes(svg, x, y, null, say(key, { axis: "y", unit: kLongUnit }), say(key, { axis: "x", unit: kLongUnit }));
  drawSightedPoints(svg, points, (p) => x(p.x), (p) => y(p.y));
  if (known(radius)) svg.append("circle").attr("class", "limit").attr("cx", x(0)).attr("cy", y(0)).attr("r", perUnit * radius);
}

function drawSightedSection(svg, width, height, points, radius) {
  const across = known(radius) ? (p) => Math.hypot(p.x, p.y) - radius : (p) => p.x;
  const [d0, d1] = d3.extent(points.map(across)), [z0, z1] = d3.extent([...(known(sighting.foot) ? [0] : []), ...points.map((p) => p.z)]);
  const x = d3.scaleLinear(room([d0, d1], 0.03), [62, width - 14]), y = d3.scaleLinear(room([z0, z1], 0.05), [height - 44, 26]);
  drawAxes(svg, x, y, null, say(known(sighting.foot) ? "refusal.height" : "refusal.height_from", { unit: kLongUnit }),
    known(radius) ? say("refusal.distance", { unit: kLongUnit }) : say("refusal.of_frame", { axis: "x", unit: kLongUnit }));
  drawSightedPoints(svg, points, (p) => x(across(p)), (p) => y(p.z));
  const rule = (name, x1, y1, x2, y2) => svg.append("line").attr("class", name).attr("x1", x1).attr("y1", y1).attr("x2", x2).attr("y2", y2);
  if (known(radius)) rule("limit", x(0), 26, x(0), height - 44);
  if (known(sighting.foot)) rule("line foundation-line", 62, y(0), width - 14, y(0));
}
