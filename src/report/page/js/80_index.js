// The page of a scan with several tanks: where they stand, and what was found of each.

const tankName = (tank) => say("export.tank", { tank: tank.page.split("/")[0].replace("tank_", "") });

/** The word of a tank's verdict; of one without a datum its status. */
function outcomeOf(tank) {
  if (tank.verdict) return tank.verdict.word;
  return words(tank.status);
}

/** Why a share stands above its own interval. */
function raisedText({ utilisation: share, utilisation_95: interval }) {
  return known(share) && interval && share > interval[1] ? ` ${say("out_of_plane.raised")}` : "";
}

/** A tilt, with its high side where it has one. */
function tiltOf(tilt) {
  const angle = withUnit(tilt.angle_arcsec, 1, "\u2033");
  return isTilted(tilt) ? say("index.high_side", { angle_arcsec: angle, direction_deg: roundAzimuth(tilt.direction_deg) }) : angle;
}

const outcomeClass = (tank) => kVerdictClasses[outcomeOf(tank)] || "not_evaluated";

function addIndex() {
  const section = addSection("tanks", say("index.tanks")), found = index.tanks.filter((tank) => tank.tank);
  section.append(make("p", {}, say("index.found_in_the_scan_the", { found: say("count.tank", { count: found.length }) })));
  if (found.length > 0) {
    addChart(section, { id: "index-chart", label: say("index.plan_of_the_tanks_each"), ratio: 0.6, least: 260, most: 520,
      draw: (svg, width, height) => drawTanks(svg, width, height, found) });
  }
  section.append(table([[say("common.tank")], [say("common.verdict")], [say("index.what_it_rests_on")], [say("index.centre_x"), "number"], ["y", "number"], [say("common.radius"), "number"], [say("common.tilt"), "number"], [say("common.stations")]],
    index.tanks.map((tank) => [
      make("td", { "data-head": say("common.tank") }, make("a", { href: tank.page }, tankName(tank))),
      make("td", { class: `verdict-word ${outcomeClass(tank)}`, "data-head": say("common.verdict") }, make("span", {}, words(outcomeOf(tank)))),
      tank.verdict ? `${verdictSentence(tank.verdict, null)}${raisedText(tank.verdict)}` : translated(tank.message),
      tank.tank ? longLength(tank.tank.center[0]) : "\u2013", tank.tank ? longLength(tank.tank.center[1]) : "\u2013",
      tank.tank ? longLength(tank.tank.radius) : "\u2013",
      tank.tilt && known(tank.tilt.angle_arcsec) ? tiltOf(tank.tilt) : "\u2013",
      tank.datum ? say("summary.measured_interpolated_missing", tank.datum) : "\u2013"])));
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
      .attr("text-anchor", "middle").text(words(outcomeOf(tank)));
  }
  return null;
}
