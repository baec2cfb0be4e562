// How far the top of the shell stands outside of its foot.

function addPlumbness(section, shell) {
  const top = d3.max(shell.plumbness, (p) => p.height);
  const rows = shell.plumbness.map((p) => ({ ...p, mm: known(p.offset) ? 1e3 * p.offset : null, half: known(p.sigma) ? 2e3 * p.sigma : null,
    lower: p.height < top - 1e-6 }));
  const lean = shell.lean ? ` The tank as a whole leans ${millimetres(shell.lean.offset)} over ${metres(shell.lean.height, 2)} towards ${degrees(shell.lean.direction_deg)}.` : "";
  section.append(make("h3", {}, "Plumbness"), make("p", {},
    `How far the top of what is seen stands outside of its foot; the most is ${millimetres(shell.plumbness_max)} at ${degrees(shell.plumbness_azimuth_deg, 1)}.${lean}`));
  addChart(section, {
    id: "plumbness-chart", label: "Plumbness of the shell against azimuth", ratio: 0.3, least: 250, most: 360,
    legend: [{ name: "offset", label: `offset over ${metres(top, 2)} of height${kBandWords}`, colour: "shell" },
      ...(rows.some((r) => r.lower) ? [{ name: "lower", label: "over less, where the shell is seen less high", colour: "tilt", on: true }] : [])],
    draw: (svg, width, height, shown) => drawPlumbness(svg, width, height, rows, shown.lower),
  });
}

function drawPlumbness(svg, width, height, rows, lower) {
  const drawn = rows.filter((r) => !r.lower || lower);
  const values = drawn.flatMap((r) => (known(r.mm) ? [r.mm - (r.half || 0), r.mm + (r.half || 0)] : []));
  const axes = azimuthAxes(svg, width, height, room([0, ...values]), "Offset of the top, outwards positive [mm]");
  drawLevel(svg, axes, 0, "zero");
  const broken = withBreaks(rows.filter((r) => !r.lower));
  drawBand(svg, axes, broken, (r) => r.mm, (r) => r.half);
  drawLine(svg, axes, broken, (r) => r.mm, "shell-line");
  svg.append("g").selectAll("circle").data(drawn.filter((r) => r.lower && known(r.mm))).enter().append("circle").attr("class", "lower")
    .attr("r", 2.5).attr("cx", (r) => axes.x(r.azimuth_deg)).attr("cy", (r) => axes.y(r.mm));
  followPointer(svg, azimuthUnder(axes), (azimuth) => {
    const r = nearestRow(rows, azimuth);
    return [["Azimuth", degrees(r.azimuth_deg, 1)], ["Offset", `${withUnit(r.mm, 1, "mm")} over ${metres(r.height, 2)}`]];
  });
  return azimuthMarks(svg, axes, height, (azimuth) => {
    const r = nearestRow(rows, azimuth);
    return angleApart(r.azimuth_deg, azimuth) < 2 * stepOfAzimuth() ? r.mm : null;
  });
}
