// How far the points lie from the lines: of all stations, and of the chosen one.

/** Distances of a section's points from their line, in the short unit: the foundation's in its band, the shell's above the corner. */
function residualsOf(section) {
  const found = { foundation: [], shell: [] };
  for (const p of sectionPoints(section)) {
    const height = p.z - toShort(section.foundation || 0);
    if (!p.shell && known(section.slope) && p.d >= toShort(sections.band[0]) && p.d <= toShort(sections.band[1])) {
      found.foundation.push(height - section.slope * p.d);
    }
    if (p.shell && known(section.lean) && height > toShort(0.06)) found.shell.push(p.d - section.lean * height);
  }
  return found;
}

function addResiduals(section) {
  const all = { foundation: [], shell: [] };
  for (const s of sections.stations) {
    const own = residualsOf(s);
    all.foundation.push(...own.foundation);
    all.shell.push(...own.shell);
  }
  section.append(make("h3", { class: "residuals" }, say("residuals.residuals")), make("p", { class: "quiet residuals" },
    say("residuals.distances_of_the_sampled_points")));
  return addChart(section, {
    id: "residuals-chart", label: say("residuals.histograms_of_the_points_distances"), ratio: 0.32, least: 240, most: 320,
    legend: [{ name: "all", label: say("residuals.all_stations"), colour: "band" }, { name: "one", label: say("residuals.chosen_station"), colour: "mark" }],
    draw: (svg, width, height) => {
      const own = residualsOf(chosenSection()), half = width / 2;
      drawHistogram(svg, 0, half, height, all.foundation, own.foundation, say("residuals.foundation"));
      drawHistogram(svg, half, width, height, all.shell, own.shell, say("common.shell"));
    },
  });
}

function drawHistogram(svg, from, to, height, all, own, title) {
  const sorted = all.map(Math.abs).sort(d3.ascending), half = Math.max(toShort(5e-4), 1.3 * (d3.quantile(sorted, 0.98) || 1));
  const x = d3.scaleLinear([-half, half], [from + 52, to - 20]).nice();
  const count = d3.histogram().domain(x.domain()).thresholds(d3.range(x.domain()[0], x.domain()[1], (x.domain()[1] - x.domain()[0]) / 30));
  const share = (values) => count(values).map((bin) => ({ x0: bin.x0, x1: bin.x1, part: values.length ? bin.length / values.length : 0 }));
  const bars = share(all), outline = share(own);
  const top = d3.max([...bars, ...outline], (bin) => bin.part) || 1, y = d3.scaleLinear([0, 100 * top], [height - 44, 26]).nice();
  drawAxes(svg, x, y, to - from < 190 ? x.ticks(2) : null, "", to - from < 190 ? say("residuals.distance", { unit: kShortUnit }) : say("residuals.distance_from_the_line", { unit: kShortUnit }));
  const spread = all.length > 1 ? say("residuals.two_thirds_within", { sorted: inShort(d3.quantile(sorted, 0.683), 2) }) : "";
  svg.append("text").attr("x", from + 52).attr("y", 14).text(to - from < 380 ? `${title} [%]` : say("residuals.points", { title, all: all.length, spread }));
  svg.append("g").selectAll("rect").data(bars).enter().append("rect").attr("class", "bar-all")
    .attr("x", (bin) => x(bin.x0)).attr("width", (bin) => Math.max(0, x(bin.x1) - x(bin.x0) - 0.5))
    .attr("y", (bin) => y(100 * bin.part)).attr("height", (bin) => y(0) - y(100 * bin.part))
    .append("title").text((bin) => say("residuals.to_of_all", { x0: inShort(bin.x0, 2), x1: inShort(bin.x1, 2), part: figure(100 * bin.part, 1) }));
  if (own.length === 0) return;
  const steps = d3.line().curve(d3.curveStepAfter).x((bin) => x(bin.x0)).y((bin) => y(100 * bin.part));
  svg.append("path").attr("class", "chosen").attr("d", steps([...outline, { x0: outline[outline.length - 1].x1, part: 0 }]));
}
