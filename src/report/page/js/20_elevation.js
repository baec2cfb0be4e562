// Elevation of the datum against azimuth.

const kBandWords = ", \u00b1 2\u03c3 band";

function addElevation() {
  const section = addSection("elevation", "Elevation");
  if (!usable) return sayAbsent(section, whyAbsent("Elevation"));
  const above = (z) => (known(z) ? 1e3 * (z - datum.datum.mean) : null);
  const rows = stations.map((s) => ({ ...s, mm: above(s.z), half: known(s.sigma_z) ? 2e3 * s.sigma_z : null,
    plane: above(s.z_tilt), paper: above(s.z_paper) }));
  section.append(make("p", { class: "quiet" },
    `Above the mean elevation ${metres(datum.datum.mean, 4)}. Arrow keys step from station to station in every chart.`));
  const own = d3.extent(rows.map((r) => r.mm).filter(known)), papers = d3.extent(rows.map((r) => r.paper).filter(known));
  const wide = 3 * Math.max(1, own[1] - own[0]);
  const near = papers[0] === undefined || (papers[1] <= own[1] + wide && papers[0] >= own[0] - wide);
  const name = levelled ? "points levelled" : "datum", sigmas = rows.some((r) => known(r.half));
  const off = near ? "" : ` (${figure(papers[0], 0)} to ${figure(papers[1], 0)} mm)`;
  addChart(section, {
    id: "elevation-chart", label: "Elevation of the datum against azimuth, with its uncertainty", ratio: 0.4, least: 300, most: 460,
    legend: [{ name: "z", label: `${name}${sigmas ? kBandWords : ""}${datum.datum.interpolated > 0 ? "; rings: interpolated" : ""}`, colour: "datum" },
      { name: "tilt", label: "fitted tilt", colour: "tilt", on: true },
      ...(papers[0] === undefined ? [] : [{ name: "paper", label: `paper\u2019s curve${off}`, colour: "reference", on: near && datum.options.method !== "paper" }])],
    draw: (svg, width, height, shown) => drawElevation(svg, width, height, shown, rows),
  });
}

function drawElevation(svg, width, height, shown, rows) {
  const values = rows.flatMap((r) => [known(r.mm) ? r.mm - (r.half || 0) : null, known(r.mm) ? r.mm + (r.half || 0) : null,
    shown.tilt ? r.plane : null, shown.paper ? r.paper : null]);
  const axes = azimuthAxes(svg, width, height, room(values), "Elevation above the mean [mm]");
  shadeGaps(svg, axes, height);
  drawBand(svg, axes, rows, (r) => r.mm, (r) => r.half);
  if (shown.paper) drawLine(svg, axes, rows, (r) => r.paper, "reference");
  if (shown.tilt) drawLine(svg, axes, rows, (r) => r.plane, "tilt");
  drawLine(svg, axes, rows, (r) => r.mm, "datum");
  drawFew(svg, axes, rows, (r) => r.mm);
  const bridged = svg.append("g");
  rows.filter((r) => r.flag === "interpolated" && known(r.mm)).forEach((r) => bridged.append("circle")
    .attr("class", "interpolated").attr("r", 2.5).attr("cx", axes.x(r.azimuth_deg)).attr("cy", axes.y(r.mm)));
  followPointer(svg, azimuthUnder(axes), describeStation);
  return azimuthMarks(svg, axes, height, (azimuth) => rows[stationAt(azimuth)].mm);
}
