// The scanner's setups on the plan: where they stood, which stations each sees, how far each was off the others.

const setupColour = (i) => d3.interpolateRainbow(((i * 0.618034) + 0.08) % 1);

function addSetups() {
  const setups = usable ? datum.setups || [] : [];
  if (setups.length < 2) return;
  const section = addSection("setups", say("setups.setups"));
  section.append(make("p", {}, setupsSentence(setups)));
  addChart(section, {
    id: "setups-chart", label: say("setups.plan_of_the_scanners_setups"), ratio: 0.8, least: 330, most: 640,
    legend: setups.map((s, i) => ({ name: String(i), label: s.name, colour: setupColour(i), on: setups.length <= 24 })),
    remark: planConvention(),
    draw: (svg, width, height, shown) => drawSetups(svg, width, height, setups, shown),
  });
  section.append(setupsTable(setups));
}

function setupsSentence(setups) {
  const a = datum.agreement || {};
  const from = { overlaps: say("setups.estimated_from_the_overlaps"), given: say("summary.as_given"), assumed: say("setups.assumed_since_the_overlaps_do") };
  const off = known(a.rms_before)
    ? say("setups.where_two_of_the_setups", { setups: setups.length, rms_before: shortLength(a.rms_before), rms_after: shortLength(a.rms_after, 2) })
    : say("setups.none_of_the_setups_sees", { setups: setups.length });
  return say("setups.before_that_a_setups_height", { off, sigma_height: shortLength(a.sigma_height), height_from: from[a.height_from] || "", sigma_tilt_arcsec: figure(a.sigma_tilt_arcsec, 1) })
    + say("setups.and_its_place_to_what", { tilt_from: from[a.tilt_from] || "", sigma_plan: shortLength(a.sigma_plan), plan_from: from[a.plan_from] || "" });
}

function setupsTable(setups) {
  const sign = (value, digits, unit) => (known(value) && value > 0 ? "+" : "") + withUnit(value, digits, unit);
  const arcseconds = (value) => sign(known(value) ? (value * 180 * 3600) / Math.PI : null, 1, "\u2033");
  const moved = (value) => (known(value) && value > 0 ? "+" : "") + shortLength(value);
  return table(
    [[say("setups.setup")], [say("common.stations"), "number"], [say("setups.up"), "number"], ["1\u03c3", "number"], [say("setups.tilt_x"), "number"], [say("setups.tilt_y"), "number"], ["x", "number"], ["y", "number"], [say("setups.off_before"), "number"], [say("setups.after"), "number"], [say("common.verdict")]],
    setups.map((s) => [s.name, anyFigure(s.stations), moved(s.dz), shortLength(s.sigma_dz), arcseconds(s.tilt_x), arcseconds(s.tilt_y), moved(s.dx), moved(s.dy),
      shortLength(s.rms_before), shortLength(s.rms_after, 2), words(s.verdict || "")]),
    say("setups.what_each_setup_was_moved"));
}

function drawSetups(svg, width, height, setups, shown) {
  const middle = [width / 2, height / 2], centre = datum.tank.center, outmost = d3.max(setups, (s) => (s.origin ? Math.hypot(s.origin[0] - centre[0], s.origin[1] - centre[1]) : 0));
  const scale = (0.5 * Math.min(width, height) - 30) / Math.max(1.35 * datum.tank.radius, Math.min(outmost, 3 * datum.tank.radius));
  const at = (x, y) => [middle[0] + scale * x, middle[1] - scale * y];
  const place = (azimuth, radius) => {
    const turn = (directionOf(azimuth) * Math.PI) / 180;
    return at(radius * Math.cos(turn), radius * Math.sin(turn));
  };
  svg.append("circle").attr("class", "ring").attr("cx", middle[0]).attr("cy", middle[1]).attr("r", scale * datum.tank.radius);
  const step = stepOfAzimuth(), width_of_band = Math.min(7, (0.3 * scale * datum.tank.radius) / setups.length);
  setups.forEach((s, i) => {
    if (!shown[i]) return;
    const radius = datum.tank.radius - ((i + 1.5) * (width_of_band + 1)) / scale;
    for (const [from, to] of s.sees_deg || []) {
      const reach = from === 0 && to === 360 ? 360 : ((to - from + 360) % 360) + step;
      const arc = d3.range(0, reach + 1e-9, Math.max(step, 1)).map((turn) => place(from + turn - step / 2, radius));
      svg.append("path").attr("d", d3.line()(arc)).style("fill", "none").style("stroke", setupColour(i)).style("stroke-width", width_of_band);
    }
    if (s.origin) drawSetup(svg, at(s.origin[0] - centre[0], s.origin[1] - centre[1]), s, setupColour(i));
  });
  return null;
}

function drawSetup(svg, [x, y], setup, colour) {
  const bad = setup.verdict === "bad";
  svg.append("circle").attr("cx", x).attr("cy", y).attr("r", bad ? 8 : 6).style("fill", bad ? "none" : colour).style("stroke", colour).style("stroke-width", bad ? 4 : 1);
  svg.append("text").attr("x", x).attr("y", y - 11).attr("text-anchor", "middle").text(bad ? say("setups.bad", { name: setup.name }) : setup.name);
}
