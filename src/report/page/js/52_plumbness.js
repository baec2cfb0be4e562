// How far the top of the shell stands outside of its foot.

function addPlumbness(section, shell) {
  const top = d3.max(shell.plumbness, (p) => p.height);
  const rows = shell.plumbness.map((p) => ({ ...p, value: toShort(p.offset), half: toShort(twice(p.sigma)),
    lower: p.height < top - 1e-6 }));
  const tolerance = plumbnessTolerance();
  const lean = shell.lean ? say("plumbness.the_tank_as_a_whole", { offset: shortLength(shell.lean.offset), height: longLength(shell.lean.height, 2), direction_deg: degrees(shell.lean.direction_deg) }) : "";
  section.append(make("h3", {}, say("plumbness.plumbness")), make("p", { class: "quiet" },
    say("plumbness.how_far_the_top_of", { plumbness_max: signed(shortLength(mostOf(shell)), mostOf(shell)), plumbness_azimuth_deg: degrees(shell.plumbness_azimuth_deg, 1), lean })));
  addChart(section, {
    id: "plumbness-chart", label: say("plumbness.plumbness_of_the_shell_against"), ratio: 0.3, least: 250, most: 360,
    legend: [...toleranceLegend(tolerance, rows.map((r) => r.value)), { name: "offset", label: say("plumbness.offset_over_of_height", { top: longLength(top, 2), k_band_words: kBandWords }), colour: "shell" },
      ...(rows.some((r) => r.lower) ? [{ name: "lower", label: say("plumbness.over_less_where_the_shell"), colour: "tilt", on: true }] : [])],
    draw: (svg, width, height, shown) => drawPlumbness(svg, width, height, rows, shown, tolerance),
  });
}

/** The offset that is furthest from the foot, inwards negative. */
function mostOf(shell) {
  const there = shell.plumbness.find((p) => Math.abs(p.azimuth_deg - shell.plumbness_azimuth_deg) < 1e-6 && Math.abs(Math.abs(p.offset) - shell.plumbness_max) < 1e-9);
  return there ? there.offset : shell.plumbness_max;
}

/** The tightest limit of the checks of plumbness, in the page's unit. */
function plumbnessTolerance() {
  const limits = (datum.checks || []).filter((check) => check.name.startsWith("plumbness") && known(check.limit)).map((check) => check.limit);
  return toShort(d3.min(limits));
}

function drawPlumbness(svg, width, height, rows, shown, tolerance) {
  const drawn = rows.filter((r) => !r.lower || shown.lower);
  const values = drawn.flatMap((r) => (known(r.value) ? [r.value - (r.half || 0), r.value + (r.half || 0)] : []));
  const axes = azimuthAxes(svg, width, height, room([0, ...values, ...toleranceEnds(shown, tolerance)]), say("plumbness.offset_of_the_top_outwards", { unit: kShortUnit }));
  drawLevel(svg, axes, 0, "zero");
  drawTolerance(svg, axes, shown, tolerance);
  const broken = withBreaks(rows.filter((r) => !r.lower));
  drawBand(svg, axes, broken, (r) => r.value, (r) => r.half);
  drawLine(svg, axes, broken, (r) => r.value, "shell-line");
  svg.append("g").selectAll("circle").data(drawn.filter((r) => r.lower && known(r.value))).enter().append("circle").attr("class", "lower")
    .attr("r", 2.5).attr("cx", (r) => axes.x(r.azimuth_deg)).attr("cy", (r) => axes.y(r.value));
  followPointer(svg, azimuthUnder(axes), (azimuth) => {
    const r = nearestRow(rows, azimuth);
    return [[say("common.azimuth"), degrees(r.azimuth_deg, 1)], [say("plumbness.offset"), say("plumbness.over", { value: inShort(r.value, 1), height: longLength(r.height, 2) })]];
  });
  return azimuthMarks(svg, axes, height, (azimuth) => {
    const r = nearestRow(rows, azimuth);
    return angleApart(r.azimuth_deg, azimuth) < 2 * stepOfAzimuth() ? r.value : null;
  });
}
