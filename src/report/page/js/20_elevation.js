// Elevation of the datum against azimuth.

const kBandWords = say("elevation.2_band");

function addElevation() {
  const section = addSection("elevation", say("common.elevation"));
  if (!usable) return sayAbsent(section, whyAbsent(say("common.elevation")));
  const above = (z) => (known(z) ? toShort(z - datum.datum.mean) : null);
  const rows = stations.map((s) => ({ ...s, value: above(s.z), half: toShort(twice(s.sigma_z)),
    plane: above(s.z_tilt), paper: above(s.z_paper) }));
  section.append(make("p", { class: "quiet" },
    say("elevation.above_the_mean_elevation", { mean: longLength(datum.datum.mean, 4) }), make("span", { class: "screen-only" }, say("elevation.arrow_keys_step_from_station"))));
  const own = d3.extent(rows.map((r) => r.value).filter(known)), papers = d3.extent(rows.map((r) => r.paper).filter(known));
  const wide = 3 * Math.max(1, own[1] - own[0]);
  const near = papers[0] === undefined || (papers[1] <= own[1] + wide && papers[0] >= own[0] - wide);
  const name = levelled ? say("elevation.points_levelled") : say("plan.datum"), sigmas = rows.some((r) => known(r.half));
  const off = near ? "" : say("elevation.to", { papers: figure(papers[0], 0), papers_2: figure(papers[1], 0), unit: kShortUnit });
  addChart(section, {
    id: "elevation-chart", label: say("elevation.elevation_of_the_datum_against"), ratio: 0.4, least: 300, most: 460,
    legend: [{ name: "z", label: `${name}${sigmas ? kBandWords : ""}${datum.datum.interpolated > 0 ? say("elevation.rings_interpolated") : ""}`, colour: "datum" },
      { name: "tilt", label: say("elevation.fitted_tilt"), colour: "tilt", on: true },
      ...(papers[0] === undefined ? [] : [{ name: "paper", label: say("elevation.papers_curve", { off }), colour: "reference", on: false }])],
    draw: (svg, width, height, shown) => drawElevation(svg, width, height, shown, rows),
  });
  addSurveyPoints(section);
}

function drawElevation(svg, width, height, shown, rows) {
  const values = rows.flatMap((r) => [known(r.value) ? r.value - (r.half || 0) : null, known(r.value) ? r.value + (r.half || 0) : null,
    shown.tilt ? r.plane : null, shown.paper ? r.paper : null]);
  const axes = azimuthAxes(svg, width, height, room(values), say("elevation.elevation_above_the_mean", { unit: kShortUnit }));
  shadeGaps(svg, axes, height);
  drawBand(svg, axes, rows, (r) => r.value, (r) => r.half);
  if (shown.paper) drawLine(svg, axes, rows, (r) => r.paper, "reference");
  if (shown.tilt) drawLine(svg, axes, rows, (r) => r.plane, "tilt");
  drawLine(svg, axes, rows, (r) => r.value, "datum");
  drawFew(svg, axes, rows, (r) => r.value);
  const bridged = svg.append("g");
  rows.filter((r) => r.flag === "interpolated" && known(r.value)).forEach((r) => bridged.append("circle")
    .attr("class", "interpolated").attr("r", 2.5).attr("cx", axes.x(r.azimuth_deg)).attr("cy", axes.y(r.value)));
  followPointer(svg, azimuthUnder(axes), describeStation);
  return azimuthMarks(svg, axes, height, (azimuth) => valueAlong(rows, azimuth));
}
