// What the user says of the tank: words in the heading and on paper, marks and north on the charts, the survey's points.

const kAboutNames = {
  tank: say("common.tank"), product: say("identity.product"), site: say("identity.site"), client: say("identity.client"), company: say("identity.company"), survey_date: say("identity.surveyed_on"),
  instrument: say("identity.instrument"), inspector: say("common.inspector"), report_number: say("identity.report"), revision: say("identity.revision"), notes: say("common.notes"),
};
const about = (datum || trend || {}).about || {};
const isDated = Boolean(trend && trend.baseline_date);  // then each survey has its own date
const surveyDate = isDated ? trend.movements[trend.movements.length - 1].date : about.survey_date;
const referenceMarks = (datum || trend || {}).marks || [];
const surveyPoints = (datum && datum.survey_points) || [];

const kLong = 80;  // letters: what is longer has a row of its own

/** The words of the heading, and the company's logo beside them. */
function addIdentity() {
  const logo = embeddedJson("logo"), said = Object.keys(kAboutNames).filter((key) => about[key] && !(key === "survey_date" && isDated)).map((key) => [kAboutNames[key], about[key]]);
  if (referenceMarks.length > 0) said.push([say("identity.marks"), referenceMarks.map((mark) => `${mark.name}: ${degrees(mark.azimuth_deg, mark.azimuth_deg % 1 === 0 ? 0 : 1)}`).join("; ")]);
  if (said.length === 0 && logo === null) return;
  const list = make("dl", { class: "about" }, said.map(([name, text]) => make("div", { class: text.length > kLong && "wide" }, make("dt", {}, name), make("dd", {}, text))));
  document.getElementById("scans").before(make("div", { class: "identity" }, list, logo === null ? "" : make("img", { src: logo, alt: about.company || "logo" })));
}

/** A text as a string of CSS. */
const cssText = (text) => `"${[...text].map((c) => (/[\w .,:-]/u.test(c) ? c : `\\${c.codePointAt(0).toString(16)} `)).join("")}"`;

/** "page 1 of 5", as a style sheet counts. */
function pageOfPages() {
  const counted = say("identity.page_of_pages").split(/(\{\w+\})/).filter(Boolean);
  return counted.map((part) => ({ "{page}": "counter(page)", "{pages}": "counter(pages)" }[part] || cssText(part))).join(" ");
}

/** What stands at the foot of every sheet of paper. */
function addSheetFoot() {
  const left = [about.tank && say("export.tank", { tank: about.tank }), about.report_number && say("identity.report_2", { report_number: about.report_number }), about.revision && say("identity.revision_2", { revision: about.revision }),
    surveyDate, about.company].filter(Boolean).join(", ");
  const small = "font: 8pt sans-serif; color: #444c56;";
  document.head.append(make("style", {}, `@page { @bottom-left { content: ${cssText(left)}; width: 85%; overflow-wrap: anywhere; ${small} } `
    + `@bottom-right { content: ${pageOfPages()}; ${small} } }`));
}

/** Moves a text up, a line at a time, until it covers none of `others`; where no line is free it is left out. */
function liftClear(text, others, lines) {
  const line = 13, box = text.node().getBBox(), y = Number(text.attr("y"));
  const covers = (lift) => others.some((o) => o.x < box.x + box.width + 2 && box.x < o.x + o.width + 2 && Math.abs(o.y - (box.y - lift)) < line - 1);
  const lift = d3.range(0, line * lines, line).find((up) => !covers(up));
  if (lift === undefined) return text.remove();
  text.attr("y", y - lift);
  others.push({ x: box.x, y: box.y - lift, width: box.width });
}

/** A text's end is cut off where it is longer than `most`; pointed at, it says all. */
function cutTo(text, most) {
  const whole = text.text();
  for (let count = whole.length - 1; count > 0 && text.node().getComputedTextLength() > most; count -= 1) text.text(`${whole.slice(0, count).trim()}\u2026`);
  if (text.text() !== whole) text.append("title").text(whole);
  return text;
}

/** The marks on a chart against azimuth, named at its foot. */
function drawReferenceMarks(svg, axes, height) {
  const named = [], bottom = height - axes.margin.bottom, lines = Math.min(4, Math.floor((bottom - axes.margin.top) / 26));
  for (const { name, azimuth_deg: azimuth } of referenceMarks) {
    const x = axes.x(azimuth), right = x > (axes.x.range()[0] + axes.x.range()[1]) / 2;
    svg.append("line").attr("class", "reference-mark").attr("x1", x).attr("x2", x).attr("y1", axes.margin.top).attr("y2", bottom);
    const text = svg.append("text").attr("class", "axis-title").attr("x", right ? x - 3 : x + 3).attr("y", bottom - 5).attr("text-anchor", right ? "end" : "start").text(name);
    liftClear(cutTo(text, right ? x - 3 - axes.x.range()[0] : axes.x.range()[1] - x - 3), named, lines);
  }
}

/** The marks and, where they are numbered, the survey's points round the plan. */
function drawPlanMarks(svg, place, ring, numbered = true) {
  const named = [], across = place(0, 0);
  for (const { name, azimuth_deg: azimuth } of referenceMarks) {
    const [x1, y1] = place(azimuth, 0.9 * ring), [x2, y2] = place(azimuth, ring), [x, y] = place(azimuth, (surveyPoints.length > 0 ? 1 - 21 / ring : 0.86) * ring);
    svg.append("line").attr("class", "reference-mark").attr("x1", x1).attr("y1", y1).attr("x2", x2).attr("y2", y2);
    const text = svg.append("text").attr("class", "plan-label").attr("x", x).attr("y", y + 4).attr("text-anchor", x > across[0] ? "end" : "start").text(name);
    liftClear(cutTo(text, Math.abs(x - across[0]) + Math.sqrt(Math.max(0, ring ** 2 - (y - across[1]) ** 2))), named, 6);
  }
  for (const point of numbered ? surveyPoints : []) {
    const [x, y] = place(point.azimuth_deg, ring);
    svg.append("circle").attr("class", "survey-place").attr("cx", x).attr("cy", y).attr("r", 2.5);
    const [at, down] = place(point.azimuth_deg, ring - 11);
    if (surveyPoints.length <= 40) svg.append("text").attr("class", "survey-number").attr("x", at).attr("y", down + 3).attr("text-anchor", "middle").text(point.number);
  }
}

/** An arrow to north where it is given. */
function drawNorth(svg, width) {
  if (!known(datum.north_azimuth_deg)) return;
  const turn = (directionOf(datum.north_azimuth_deg) * Math.PI) / 180, middle = [width - 40, 46], long = 20;
  const at = (length) => [middle[0] + length * Math.cos(turn), middle[1] - length * Math.sin(turn)];
  const [x1, y1] = at(-long), [x2, y2] = at(long), [x, y] = at(long + 12);
  const wing = (side) => [x2 - 9 * Math.cos(turn + side), y2 + 9 * Math.sin(turn + side)];
  svg.append("line").attr("class", "zero").attr("x1", x1).attr("y1", y1).attr("x2", x2).attr("y2", y2);
  svg.append("path").attr("class", "north").attr("d", d3.line()([[x2, y2], wing(0.4), wing(-0.4)]));
  svg.append("text").attr("x", x).attr("y", y + 4).attr("text-anchor", "middle").text("N");
}

/** A bar of a round length, and the tank's diameter. */
function drawPlanScale(svg, width, height, ring) {
  const radius = toLong(datum.tank.radius), perUnit = ring / radius, length = d3.ticks(0, radius, 2)[1], right = width - 14, y = height - 14;
  svg.append("line").attr("class", "zero").attr("x1", right - length * perUnit).attr("x2", right).attr("y1", y).attr("y2", y).style("stroke-width", 3);
  svg.append("text").attr("x", right).attr("y", y - 7).attr("text-anchor", "end").text(say("identity.diameter", { length: figure(length, Math.max(0, -Math.floor(Math.log10(length)))), unit: kLongUnit, radius: longLength(2 * datum.tank.radius) }));
}

/** On paper, where the inspector signs. */
function addSignature(section) {
  const places = [say("common.inspector"), say("common.date"), say("summary.signature")];
  section.append(make("div", { class: "paper-only signature" }, places.map((name) => make("span", {}, name))));
}

const kManyPoints = 72;  // in the table of more than these rows on paper are narrower

/** The elevations that the user's own points have. */
function addSurveyPoints(section) {
  if (surveyPoints.length === 0) return;
  const from = known(datum.north_azimuth_deg) ? say("identity.north") : say("identity.y_of_the_scans_frame");
  const inUnit = (name, unit) => [`${name} [${unit}]`, "number"];
  const listed = table([[say("identity.point"), "number"], inUnit(say("common.azimuth"), "\u00b0"), inUnit(say("common.elevation"), kLongUnit),
    inUnit("\u00b1", kShortUnit), inUnit(say("common.out_of_plane"), kShortUnit)],
    surveyPoints.map((p) => [String(p.number), figure(p.azimuth_deg, 1), known(p.z) ? figure(toLong(p.z), 4 + display.long[2]) : say("common.not_seen"),
      known(p.sigma_z) ? shortFigure(2 * p.sigma_z) : "", known(p.u) ? shortFigure(p.u) : ""]));
  listed.firstChild.className = "";  // narrow enough for a phone as it is
  section.append(make("h3", {}, say("identity.survey_points")), make("p", { class: "quiet" }, say("identity.numbered_clockwise_from_settlement_out", { from })),
    make("div", { class: `survey-points${surveyPoints.length > kManyPoints ? " many" : ""}` }, listed));
}
