// What a station's elevation comes from: points in the section across the shell, the two fitted lines, residuals.

const kSectionOnPaper = 178;  // px: 47 mm

function addStation() {
  const section = addSection("station", say("common.station"));
  if (!usable) return sayAbsent(section, whyAbsent(say("common.stations")));
  section.append(stationControls());
  const values = make("div", { id: "station-values" });
  section.append(values);
  const fill = () => values.replaceChildren(boxes(describeFit(link.chosen), "facts words"));
  document.addEventListener("station", fill);
  fill();
  if (sections === null) return sayAbsent(section, whyNoSections());
  const pair = make("div", { class: "pair" });
  section.append(make("h3", {}, say("section.section_across_the_shell")), make("p", { class: "quiet" },
    say("section.a_sample_of_the_scans")), pair);
  const whole = addChart(pair, { id: "section-chart", label: say("section.section_across_the_shell_at"), ratio: 0.8, least: 300, most: 460, onPaper: kSectionOnPaper,
    legend: [{ name: "shell", label: say("section.shell"), colour: "shell" }, { name: "foundation", label: say("section.foundation"), colour: "foundation" }],
    draw: (svg, width, height) => drawSection(svg, width, height, chosenSection(), false) });
  const close = addChart(pair, { id: "corner-chart", label: say("section.the_foundation_close_to_the"), ratio: 0.8, least: 300, most: 460, onPaper: kSectionOnPaper,
    legend: [{ name: "fit", label: say("section.the_same_heights_enlarged_shaded"), colour: "foundation" }],
    draw: (svg, width, height) => drawSection(svg, width, height, chosenSection(), true) });
  const residuals = addResiduals(section);
  document.addEventListener("station", () => [whole, close, residuals].forEach((chart) => drawChart(chart)));
}

const chosenSection = () => sections.stations[stationAt(link.chosen)];

function stationControls() {
  const number = make("input", { type: "number", id: "station-number", min: 0, max: stations.length - 1, value: stationAt(link.chosen) });
  const step = (label, text, by) => {
    const button = make("button", { type: "button", "aria-label": label }, text);
    button.addEventListener("click", () => link.choose(link.chosen + by * stepOfAzimuth()));
    return button;
  };
  number.addEventListener("change", () => {
    const i = Number(number.value);
    if (Number.isInteger(i) && i >= 0 && i < stations.length) link.choose(stations[i].azimuth_deg);
    else number.value = stationAt(link.chosen);
  });
  document.addEventListener("station", () => { number.value = stationAt(link.chosen); });
  return make("div", { class: "controls" }, make("label", { for: "station-number" }, say("common.station")),
    step(say("section.previous_station"), "\u2039", -1), number, step(say("section.next_station"), "\u203a", 1),
    goTo(say("section.worst_out_of_plane"), (s) => (known(s.u) ? Math.abs(s.u) : null)), goTo(say("section.highest"), (s) => s.z), goTo(say("section.lowest"), (s) => -s.z), nextFail());
}

/** A button that leads round the tank from one failing or undecided check to the next; none without any. */
function nextFail() {
  const places = [...checksWith("fail"), ...checksWith("undecided")].map((check) => check.azimuth_deg).filter(known);
  if (places.length === 0) return null;
  const button = make("button", { type: "button" }, say("station.next_fail"));
  const onwards = (azimuth) => (((azimuth - link.chosen) % 360) + 360) % 360 || 360;
  const apart = (azimuth) => (angleApart(azimuth, link.chosen) < stepOfAzimuth() / 2 ? 360 : onwards(azimuth));
  button.addEventListener("click", () => link.choose(stations[stationAt(places.reduce((best, p) => (apart(p) < apart(best) ? p : best)))].azimuth_deg));
  return button;
}

function goTo(label, value) {
  const button = make("button", { type: "button" }, label);
  button.addEventListener("click", () => link.choose(extremeStation(value).azimuth_deg));
  return button;
}

/** The points of a section in the short unit, and whether each is of the shell. */
function sectionPoints(section) {
  const scale = toShort(sections.step);
  return section.d.map((d, i) => ({ d: scale * d, z: scale * section.z[i], shell: section.z[i] > d }));
}

/** The height of the chosen station's datum in its section, which a narrow lip raises above the foundation's line. */
function datumIn(section) {
  const { z } = stations[stationAt(link.chosen)];
  return toShort(known(z) ? z - section.base : section.foundation || 0);
}

/** Where a section's axes end: all of it true to scale, or the band that was fitted with its heights enlarged. */
function sectionScales(width, height, section, points, close) {
  const left = 62, right = width - 14, low = height - 44, high = 26;
  if (close) {
    const to = 1.25 * toShort(sections.band[1]), middle = toShort(section.foundation || 0);
    const near = points.filter((p) => !p.shell && p.d > 0 && p.d < toShort(sections.band[1])).map((p) => Math.abs(p.z - middle));
    const half = Math.max(toShort(0.003), 1.3 * Math.abs(datumIn(section) - middle), 1.3 * (d3.quantile(near.sort(d3.ascending), 0.95) || 0), toShort(6 * (section.noise || 0)));
    return { x: d3.scaleLinear([-0.12 * to, to], [left, right]), y: d3.scaleLinear([middle - half, middle + half], [low, high]) };
  }
  const dMost = d3.max(points, (p) => p.d) || toShort(0.5), zMost = d3.max(points, (p) => p.z) || toShort(0.5), zLeast = d3.min(points, (p) => p.z) || toShort(-0.05);
  const dLeast = Math.min(toShort(-0.06), d3.min(points, (p) => p.d) || 0);
  const perPixel = Math.max((dMost - dLeast) / (right - left), (zMost - zLeast) / (low - high)) * 1.05;
  const bottom = zLeast - 0.03 * perPixel * (low - high);
  return { x: d3.scaleLinear([dLeast, dLeast + perPixel * (right - left)], [left, right]),
    y: d3.scaleLinear([bottom, bottom + perPixel * (low - high)], [low, high]) };
}

function drawSection(svg, width, height, section, close) {
  const points = sectionPoints(section), { x, y } = sectionScales(width, height, section, points, close);
  const inside = sections.side === "inside" ? say("section.into_the_tank") : say("section.outwards");
  const [left, right] = x.range(), [low, high] = y.range(), clip = `clip-${close ? "corner" : "section"}`;
  svg.append("clipPath").attr("id", clip).append("rect").attr("x", left).attr("y", high).attr("width", right - left).attr("height", low - high);
  if (close && known(section.foundation)) {
    svg.append("rect").attr("class", "gap").attr("x", x(toShort(sections.band[0]))).attr("y", high)
      .attr("width", x(toShort(sections.band[1])) - x(toShort(sections.band[0]))).attr("height", low - high);
  }
  drawAxes(svg, x, y, null, say("section.height_about", { base: longLength(section.base, 4), unit: kShortUnit }), say("section.distance_from_the_shell", { inside, unit: kShortUnit }));
  const plot = svg.append("g").attr("clip-path", `url(#${clip})`);
  plot.selectAll("circle").data(points).enter().append("circle").attr("class", (p) => (p.shell ? "shell-point" : "foundation-point"))
    .attr("r", close ? 3 : 2.2).attr("cx", (p) => x(p.d)).attr("cy", (p) => y(p.z));
  const foot = toShort(section.foundation || 0);
  const segment = (name, x1, y1, x2, y2) => plot.append("line").attr("class", `line ${name}`)
    .attr("x1", x(x1)).attr("y1", y(y1)).attr("x2", x(x2)).attr("y2", y(y2));
  if (known(section.lean)) segment("shell-line", 0, foot, section.lean * (y.domain()[1] - foot), y.domain()[1]);
  if (known(section.slope)) segment("foundation-line", 0, foot, x.domain()[1], foot + section.slope * x.domain()[1]);
  const s = stations[stationAt(link.chosen)];
  if (known(section.slope) && known(s.sigma_z)) {
    const level = datumIn(section), error = toShort(twice(s.sigma_z));
    plot.append("line").attr("class", "whisker").attr("x1", x(0)).attr("x2", x(0)).attr("y1", y(level - error)).attr("y2", y(level + error));
    plot.append("circle").attr("class", "chosen").attr("r", 4.5).attr("cx", x(0)).attr("cy", y(level));
  }
  if (!known(section.slope)) svg.append("text").attr("class", "gap-label").attr("x", (left + right) / 2).attr("y", high + 16)
    .attr("text-anchor", "middle").text(say("section.no_foundation_line_was_accepted"));
  sectionTips(svg, x, y, points);
}

/** The nearest point's figures under the pointer. */
function sectionTips(svg, x, y, points) {
  const node = svg.node();
  node.addEventListener("pointermove", (event) => {
    const box = node.getBoundingClientRect(), px = event.clientX - box.left, py = event.clientY - box.top;
    const apart = (p) => Math.hypot(x(p.d) - px, y(p.z) - py);
    const nearest = points.reduce((best, p) => (best === null || apart(p) < apart(best) ? p : best), null);
    if (nearest === null || apart(nearest) > 30) return tip.hide();
    tip.show(event, [[nearest.shell ? say("section.point_of_the_shells_side") : say("section.point_of_the_foundations_side"), ""],
      [say("section.distance_from_the_shell_2"), inShort(nearest.d, 1)], [say("common.height"), inShort(nearest.z, 1)]]);
  });
  node.addEventListener("pointerleave", () => tip.hide());
}
