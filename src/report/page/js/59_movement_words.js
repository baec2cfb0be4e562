// What moved, in the words that the terminal has: as a rigid body, and the rest.

const significance = (part, taken) => say(taken ? "movement.taken" : part.significant ? "movement.significant" : "movement.not_significant");
/** With its sign; a figure that is shown as zero has none. */
const signed = (text, value) => (known(value) && value > 0 && parseFloat(text) !== 0 ? `+${text}` : text);
const arcseconds = (value, digits = 1) => say("unit.arcseconds", { value: figure(value, digits) });

/** Where a change of tilt rises to; null of one that is not shown, whose direction is not known. */
const tiltAzimuth = (m) => (m.tilt_change.significant && m.removed !== "tilt" ? m.tilt_change.azimuth_deg : null);

/** [name, value, two sigma, where, significance] of mean, tilt and the rest; of what was taken out nothing is known. */
function movementParts(m) {
  const mean = m.mean, tilt = m.tilt_change, rest = m.out_of_plane;
  const slopeSigma = known(tilt.sigma) ? Math.atan(2 * tilt.sigma) * (180 / Math.PI) * 3600 : null;
  const parts = [["movement.mean", signed(shortLength(mean.value, 2), mean.value), shortLength(twice(mean.sigma), 2), null, significance(mean, m.removed !== "none")],
    ["movement.tilt", arcseconds(tilt.angle_arcsec), arcseconds(slopeSigma), tiltAzimuth(m), significance(tilt, m.removed === "tilt")]];
  if (rest) parts.push(["movement.rest", signed(shortLength(rest.value, 2), rest.value), shortLength(twice(rest.sigma), 2), rest.azimuth_deg, significance(rest, false)]);
  return parts;
}

/** The word of the verdict; of what was taken out of the differences nothing is said. */
const movementWord = (m) => say(m.moved ? "movement.moved" : { mean: "movement.unmoved_mean", tilt: "movement.unmoved_tilt" }[m.removed] || "movement.unmoved");

const kErrorsWorthSaying = 1.25;  // as in the terminal

/** The whole verdict of a movement. */
function movementText(m) {
  const parts = movementParts(m).map(([key, value, twoSigma, at, shown]) => {
    const azimuth = roundAzimuth(at), risen = known(at) ? say("movement.risen", { azimuth }) : "";
    return say(key, { value, two_sigma: twoSigma, azimuth, risen, significance: shown });
  });
  const moved = say("movement.stations", { count: m.significant, of: m.matched });
  const used = (m.errors || {}).used;
  return [`${movementWord(m)}: ${[...parts, moved].join("; ")}.`,
    ...(used > kErrorsWorthSaying ? [say("movement.errors_used", { factor: figure(used, 1) })] : []),
    ...(m.not_given || []).map((key) => say(key))].join(" ");
}

const hasMovement = (m) => Boolean(m && m.stations && m.stations.length > 0 && m.tilt_change && known(m.mean.value));

/** What was taken out of the differences, and what the registration is known to. */
function movementTerms(m) {
  const given = m.registration_error > 0 || m.registration_tilt_arcsec > 0
    ? say("movement.registration", { height: shortLength(m.registration_error, 2), tilt: arcseconds(m.registration_tilt_arcsec) }) : "";
  const turned = m.azimuth_offset_deg ? say("movement.turned", { angle: degrees(m.azimuth_offset_deg, 2) }) : "";
  return [say("movement.signs"), say(`movement.removed.${m.removed}`), given, turned].filter(Boolean).join(" ");
}

/** The rigid part and the rest, each in its box. */
function movementBoxes(m) {
  const boxesOf = movementParts(m).map(([key, value, twoSigma, azimuth, shown]) => (
    [say(`${key}.name`), value, [`\u00b1 ${twoSigma} (2\u03c3)`, known(azimuth) ? say(`${key}.where`, { azimuth: roundAzimuth(azimuth) }) : "", shown].filter(Boolean).join(", ")]));
  boxesOf.push([say("movement.largest.name"), signed(shortLength(m.max, 2), m.max), say("movement.largest.more", { azimuth: roundAzimuth(m.max_azimuth_deg), rms: shortLength(m.rms, 2) })]);
  return boxes(boxesOf);
}

/** The movement from above: the rest outside of the ring where it rose, the rigid tilt as an arrow. */
function addMovementPlan(section, m, id) {
  const largest = d3.max(m.stations, (s) => (known(s.rest) ? Math.abs(s.rest) : 0)) || 1e-4;
  const power = 0.25 / largest;
  addChart(section, {
    id, label: say("movement.plan"), ratio: (width) => (width < kNarrow ? 1.1 : 0.6), least: 300, most: 460,
    legend: [{ name: "rest", label: say("movement.plan.rest", { most: shortLength(largest) }), colour: "datum" },
      { name: "moved", label: say("movement.plan.moved"), colour: "mark" },
      { name: "tilt", label: `${say("movement.plan.tilt")}: ${arcseconds(m.tilt_change.angle_arcsec, 0)}`, colour: "fit" }],
    remark: planConvention(), onPaper: kPaperHeight, draw: (svg, width, height) => drawMovementPlan(svg, width, height, m, power),
  });
}

function drawMovementPlan(svg, width, height, m, power) {
  const middle = [width / 2, height / 2], most = Math.min(width, height), ring = Math.min(0.33 * most, (0.5 * most - kAzimuthGap - 14) / 1.36);
  const place = (azimuth, radius) => {
    const turn = (directionOf(azimuth) * Math.PI) / 180;
    return [middle[0] + radius * Math.cos(turn), middle[1] - radius * Math.sin(turn)];
  };
  drawPlanFrame(svg, middle, ring, place);
  drawPlanMarks(svg, place, ring, false);
  if (datum !== null) drawNorth(svg, width);
  const seen = closed(m.stations), at = (s) => place(s.azimuth_deg, ring * (1 + power * s.rest));
  svg.append("path").attr("class", "line datum").attr("d", d3.line().defined((s) => known(s.rest)).x((s) => at(s)[0]).y((s) => at(s)[1])(seen));
  for (const s of m.stations.filter((one) => one.significant && known(one.rest))) {
    svg.append("circle").attr("class", "moved-place").attr("r", 2).attr("cx", at(s)[0]).attr("cy", at(s)[1]);
  }
  if (known(tiltAzimuth(m))) drawArrow(svg, place, ring, tiltAzimuth(m), arcseconds(m.tilt_change.angle_arcsec, 0));
  const middleText = signed(shortLength(m.mean.value), m.mean.value);
  svg.append("text").attr("class", "plan-label").attr("x", 14).attr("y", height - 8).text(say("movement.plan.mean", { value: middleText }));
  return null;
}
