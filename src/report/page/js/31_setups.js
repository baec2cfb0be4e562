// The scanner's setups on the plan: where they stood, which stations each sees, how far each was off the others.

const setupColour = (i) => d3.interpolateRainbow(((i * 0.618034) + 0.08) % 1);

function addSetups() {
  const setups = usable ? datum.setups || [] : [];
  if (setups.length < 2) return;
  const section = addSection("setups", "Setups");
  section.append(make("p", {}, setupsSentence(setups)));
  addChart(section, {
    id: "setups-chart", label: "Plan of the scanner's setups and of the stations that each sees", ratio: 0.8, least: 330, most: 640,
    legend: setups.map((s, i) => ({ name: String(i), label: s.name, colour: setupColour(i), on: setups.length <= 24 })),
    draw: (svg, width, height, shown) => drawSetups(svg, width, height, setups, shown),
  });
  section.append(setupsTable(setups));
}

function setupsSentence(setups) {
  const a = datum.agreement || {};
  const from = { overlaps: "estimated from the overlaps", given: "as given", assumed: "assumed, since the overlaps do not tell" };
  const off = known(a.rms_before)
    ? `Where two of the ${setups.length} setups see the same foundation they differed by ${millimetres(a.rms_before)} (RMS), and by ${millimetres(a.rms_after, 2)} after the adjustment. `
    : `None of the ${setups.length} setups sees what another sees: they could not be compared. `;
  return `${off}Before that a setup's height was taken to be known to ${millimetres(a.sigma_height)} (${from[a.height_from] || ""}), its tilt to ${figure(a.sigma_tilt_arcsec, 1)}\u2033 `
    + `(${from[a.tilt_from] || ""}) and its place to ${millimetres(a.sigma_plan)} (${from[a.plan_from] || ""}). What all setups share no overlap shows: it stays in the stations\u2019 sigma.`;
}

function setupsTable(setups) {
  const sign = (value, digits, unit) => (known(value) && value > 0 ? "+" : "") + withUnit(value, digits, unit);
  const arcseconds = (value) => sign(known(value) ? (value * 180 * 3600) / Math.PI : null, 1, "\u2033");
  const moved = (value) => sign(known(value) ? 1e3 * value : null, 1, "mm");
  return table(
    [["Setup"], ["Stations", "number"], ["Up", "number"], ["1\u03c3", "number"], ["Tilt x", "number"], ["Tilt y", "number"], ["x", "number"], ["y", "number"], ["Off before", "number"], ["After", "number"], ["Verdict"]],
    setups.map((s) => [s.name, anyFigure(s.stations), moved(s.dz), millimetres(s.sigma_dz), arcseconds(s.tilt_x), arcseconds(s.tilt_y), moved(s.dx), moved(s.dy),
      millimetres(s.rms_before), millimetres(s.rms_after, 2), words(s.verdict || "")]),
    "What each setup was moved by, and its foundation against the other setups\u2019 before and after.");
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
  svg.append("text").attr("x", x).attr("y", y - 11).attr("text-anchor", "middle").text(bad ? `${setup.name}: bad` : setup.name);
}
