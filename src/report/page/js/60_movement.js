// Movement since an earlier survey, and over several surveys.

function addMovement() {
  const section = addSection("movement", "Movement");
  if (!usable) return sayAbsent(section, whyAbsent("Movement"));
  if (!datum.movement) return sayAbsent(section, "Movement since an earlier survey: none, because no earlier result was given (option baseline).");
  const m = datum.movement;
  if (!m.stations || m.stations.length === 0) return sayAbsent(section, `Movement since ${m.baseline}: none (${m.message || "nothing to compare"}).`);
  section.append(make("p", { class: "breakable" }, movementSentence(m)));
  drawMovements(section, "movement-chart", [{ name: "This survey", movement: m }]);
}

function movementSentence(m) {
  const turned = m.azimuth_offset_deg ? `, this survey turned by ${degrees(m.azimuth_offset_deg, 2)}` : "";
  const moved = m.stations.filter((s) => s.significant).length;
  const whole = m.mean && known(m.mean.value)
    ? `Settlement of the whole ${millimetres(m.mean.value, 2)} \u00b1 ${millimetres(2 * m.mean.sigma, 2)} (2\u03c3), ${m.mean.significant ? "significant" : "not significant"}. ` : "";
  return `Since ${m.baseline}: largest ${millimetres(m.max, 2)}, RMS ${millimetres(m.rms, 2)}; ${moved} of ${plural(m.matched, "station")} moved significantly. `
    + whole + `Removed: ${m.removed}; error of registration ${millimetres(m.registration_error, 2)}${turned}.`;
}

const kSurveyColours = ["datum", "reference", "shell", "fit", "tilt"];
const surveyColour = (i) => `var(--${kSurveyColours[i % kSurveyColours.length]})`;

/** One entry for a survey alone; of several one each, to be left out, and what the band is of. */
function movementLegend(surveys) {
  const marks = "band: level of detection (95 %); dots: significant";
  if (surveys.length === 1) return [{ name: "0", label: `movement; ${marks}`, colour: "datum" }];
  return surveys.map(({ name }, i) => ({ name: String(i), colour: kSurveyColours[i % kSurveyColours.length], on: true,
    label: i === surveys.length - 1 ? `${name}; ${marks}` : name }));
}

/** Differences against azimuth; the level of detection as a band, significant stations as dots. */
function drawMovements(section, id, surveys) {
  const rows = surveys.map(({ movement }) => fewOrAll(movement.stations.map((s) => ({ ...s,
    mm: known(s.dz) ? 1e3 * s.dz : null, lod: known(s.lod95) ? 1e3 * s.lod95 : null })), (r) => r.mm));
  addChart(section, {
    id, label: "Movement of the datum against azimuth, with the level of detection", ratio: 0.36, least: 280, most: 420,
    legend: movementLegend(surveys),
    draw: (svg, width, height, shown) => {
      const drawn = rows.filter((_, i) => shown[i]), last = drawn[drawn.length - 1] || [];
      const values = [...drawn.flat().map((r) => r.mm), ...last.flatMap((r) => [r.lod, known(r.lod) ? -r.lod : null])];
      const axes = azimuthAxes(svg, width, height, room([0, ...values]), "Movement, up positive [mm]");
      drawBand(svg, axes, last, () => 0, (r) => r.lod);
      drawLevel(svg, axes, 0, "zero");
      rows.forEach((list, i) => {
        if (!shown[i]) return;
        drawLine(svg, axes, list, (r) => r.mm, "survey").style("stroke", surveyColour(i));
        drawMoved(svg, axes, list, surveyColour(i));
      });
      followPointer(svg, azimuthUnder(axes), (azimuth) => describeMovement(azimuth, surveys));
      return azimuthMarks(svg, axes, height, (azimuth) => {
        const r = nearestRow(last, azimuth);
        return r && angleApart(r.azimuth_deg, azimuth) < 2 ? r.mm : null;
      });
    },
  });
}

/** A dot on each station that moved significantly; where stations are few, a ring on the others. */
function drawMoved(svg, axes, list, colour) {
  for (const r of list) {
    if (!known(r.mm) || (!r.significant && list.length > kFew)) continue;
    svg.append("circle").attr("class", r.significant ? "significant" : "unmoved").attr("r", 2.5).attr("cx", axes.x(r.azimuth_deg))
      .attr("cy", axes.y(r.mm)).style("stroke", colour).style("fill", r.significant ? colour : null);
  }
}

function describeMovement(azimuth, surveys) {
  const lines = [["Azimuth", degrees(azimuth, 1)]];
  for (const { name, movement } of surveys) {
    const s = nearestRow(movement.stations, azimuth);
    if (s === null || !known(s.dz)) lines.push([name, "not compared here"]);
    else lines.push([name, `${millimetres(s.dz, 2)}, detectable from ${millimetres(s.lod95, 2)}${s.significant ? ", significant" : ""}`]);
  }
  return lines;
}
