// The page of a scan with several tanks: where they stand, and what was found of each.

const tankName = (tank) => words(tank.page.split("/")[0]);

/** The word of a tank's verdict; of one without a datum its status. */
function outcomeOf(tank) {
  if (tank.verdict) return tank.verdict.word;
  return words(tank.status);
}

const outcomeClass = (tank) => ({ FAIL: "fail", UNDECIDED: "undecided", INCOMPLETE: "undecided", PASS: "pass" }[outcomeOf(tank)] || "not_evaluated");

function addIndex() {
  const section = addSection("tanks", "Tanks"), found = index.tanks.filter((tank) => tank.tank);
  section.append(make("p", {}, `${plural(found.length, "tank")} found in the scan, the best seen first.`));
  if (found.length > 0) {
    addChart(section, { id: "index-chart", label: "Plan of the tanks, each with the word of its verdict", ratio: 0.6, least: 260, most: 520,
      draw: (svg, width, height) => drawTanks(svg, width, height, found) });
  }
  section.append(table([["Tank"], ["Verdict"], ["What it rests on"], ["Centre x", "number"], ["y", "number"], ["Radius", "number"], ["Tilt", "number"], ["Stations"]],
    index.tanks.map((tank) => [
      make("td", { "data-head": "Tank" }, make("a", { href: tank.page }, tankName(tank))),
      make("td", { class: `verdict-word ${outcomeClass(tank)}`, "data-head": "Verdict" }, make("span", {}, outcomeOf(tank))),
      tank.verdict ? tank.verdict.sentence : tank.message,
      tank.tank ? metres(tank.tank.center[0]) : "\u2013", tank.tank ? metres(tank.tank.center[1]) : "\u2013",
      tank.tank ? metres(tank.tank.radius) : "\u2013",
      tank.tilt && known(tank.tilt.angle_arcsec) ? `${withUnit(tank.tilt.angle_arcsec, 1, "\u2033")}, high side ${degrees(tank.tilt.direction_deg)}` : "\u2013",
      tank.datum ? `${tank.datum.measured} measured, ${tank.datum.missing} missing` : "\u2013"])));
}

/** The tanks to scale, each a link to its page. */
function drawTanks(svg, width, height, tanks) {
  const reach = (i) => [d3.min(tanks, (t) => t.tank.center[i] - t.tank.radius), d3.max(tanks, (t) => t.tank.center[i] + t.tank.radius)];
  const [x0, x1] = reach(0), [y0, y1] = reach(1), margin = 24;
  const scale = Math.min((width - 2 * margin) / (x1 - x0), (height - 2 * margin) / (y1 - y0));
  const at = ([x, y]) => [width / 2 + scale * (x - (x0 + x1) / 2), height / 2 - scale * (y - (y0 + y1) / 2)];
  for (const tank of tanks) {
    const [x, y] = at(tank.tank.center), link_to = svg.append("a").attr("href", tank.page);
    link_to.append("circle").attr("class", "ring").attr("cx", x).attr("cy", y).attr("r", scale * tank.tank.radius);
    link_to.append("text").attr("x", x).attr("y", y).attr("text-anchor", "middle").style("font-weight", 600).text(tankName(tank));
    link_to.append("text").attr("class", `verdict-word ${outcomeClass(tank)}`).style("fill", "currentColor").attr("x", x).attr("y", y + 16)
      .attr("text-anchor", "middle").text(outcomeOf(tank));
  }
  return null;
}
