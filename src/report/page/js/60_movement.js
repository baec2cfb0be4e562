// Movement since an earlier survey, and over several surveys.

function addMovement() {
  const section = addSection("movement", say("movement.movement"));
  if (!usable) return sayAbsent(section, whyAbsent(say("movement.movement")));
  if (!datum.movement) return sayAbsent(section, say("movement.movement_since_an_earlier_survey"));
  const m = datum.movement;
  if (!m.stations || m.stations.length === 0) return sayAbsent(section, say("movement.movement_since_none", { baseline: m.baseline, message: m.message || say("movement.nothing_to_compare") }));
  section.append(make("p", { class: "breakable" }, say("movement.since", { baseline: m.baseline })));
  if (hasMovement(m)) section.append(make("p", { class: "screen-only" }, typeset(movementText(m))), movementBoxes(m), make("p", { class: "quiet" }, movementTerms(m)));
  addMovementCharts(section, m, "movement", [{ name: say("movement.this"), movement: m }]);
  if (!m.limits) return;
  section.append(make("h3", {}, say("limit_rate.heading")));
  addLimitRates(section, m.limits);
}

/** Movement against azimuth, and the plan of the last survey's. */
function addMovementCharts(section, m, name, surveys) {
  addPaperPair(section, (part) => drawMovements(part, `${name}-chart`, surveys),
    (part) => hasMovement(m) && known(d3.max(m.stations, (s) => s.rest)) && addMovementPlan(part, m, `${name}-plan`));
}

const kSurveyColours = ["datum", "reference", "shell", "fit", "tilt"];
const surveyColour = (i) => `var(--${kSurveyColours[i % kSurveyColours.length]})`;

/** One entry for a survey alone; of several one each, to be left out, and what the band is of. */
function movementLegend(surveys) {
  const marks = say("movement.band_level_of_detection_95");
  if (surveys.length === 1) {
    const apart = surveys[0].movement.stations.some((s) => known(s.rest)) ? [{ name: "rigid", label: say("movement.rigid_line"), colour: "tilt", on: true },
      { name: "rest", label: say("movement.rest_line"), colour: "fit", on: true }] : [];
    return [{ name: "0", label: say("movement.movement_2", { marks }), colour: "datum" }, ...apart];
  }
  return surveys.map(({ name }, i) => ({ name: String(i), colour: kSurveyColours[i % kSurveyColours.length], on: true,
    label: i === surveys.length - 1 ? `${name}; ${marks}` : name }));
}

/** Differences against azimuth; the level of detection as a band, significant stations as dots. */
function drawMovements(section, id, surveys) {
  const rows = surveys.map(({ movement }) => fewOrAll(movement.stations.map((s) => ({ ...s,
    value: toShort(s.dz), rest: toShort(s.rest), lod: toShort(s.lod95) })), (r) => r.value));
  addChart(section, {
    id, label: say("movement.movement_of_the_datum_against"), ratio: 0.36, least: 280, most: 420,
    legend: movementLegend(surveys),
    draw: (svg, width, height, shown) => {
      const drawn = rows.filter((_, i) => shown[i]), last = drawn[drawn.length - 1] || [];
      const values = [...drawn.flat().map((r) => r.value), ...last.flatMap((r) => [r.lod, known(r.lod) ? -r.lod : null])];
      const axes = azimuthAxes(svg, width, height, room([0, ...values]), say("movement.movement_up_positive", { unit: kShortUnit }));
      drawBand(svg, axes, last, () => 0, (r) => r.lod);
      drawLevel(svg, axes, 0, "zero");
      if (shown.rigid) drawLine(svg, axes, last, (r) => (known(r.value) && known(r.rest) ? r.value - r.rest : null), "tilt");
      if (shown.rest) drawLine(svg, axes, last, (r) => r.rest, "fit");
      rows.forEach((list, i) => {
        if (!shown[i]) return;
        drawLine(svg, axes, list, (r) => r.value, "survey").style("stroke", surveyColour(i));
        drawMoved(svg, axes, list, surveyColour(i));
      });
      followPointer(svg, azimuthUnder(axes), (azimuth) => describeMovement(azimuth, surveys));
      return azimuthMarks(svg, axes, height, (azimuth) => {
        const r = nearestRow(last, azimuth);
        return r && angleApart(r.azimuth_deg, azimuth) < 2 ? r.value : null;
      });
    },
  });
}

/** A dot on each station that moved significantly; where stations are few, a ring on the others. */
function drawMoved(svg, axes, list, colour) {
  for (const r of list) {
    if (!known(r.value) || (!r.significant && list.length > kFew)) continue;
    svg.append("circle").attr("class", r.significant ? "significant" : "unmoved").attr("r", 2.5).attr("cx", axes.x(r.azimuth_deg))
      .attr("cy", axes.y(r.value)).style("stroke", colour).style("fill", r.significant ? colour : null);
  }
}

function describeMovement(azimuth, surveys) {
  const lines = [[say("common.azimuth"), degrees(azimuth, 1)]];
  for (const { name, movement } of surveys) {
    const s = nearestRow(movement.stations, azimuth);
    if (s === null || !known(s.dz)) lines.push([name, say("movement.not_compared_here")]);
    else lines.push([name, say("movement.detectable_from", { dz: shortLength(s.dz, 2), lod95: shortLength(s.lod95, 2), significant: s.significant ? say("movement.significant_2") : "" })]);
  }
  return lines;
}
