// The verdict and the facts of the tank.

const kStatusSentences = {
  ok: "Datum found all round",
  partial: "Datum found in part",
  no_tank: "No tank found",
  doubtful: "Perhaps no tank",
  no_crease: "No datum found",
  too_few_points: "Too few points",
  fit_failed: "No curve could be fitted",
};

const checksWith = (verdict) => (datum.checks || []).filter((check) => check.verdict === verdict);

/** pass, fail or undecided: the worst that any check says. */
function worstVerdict() {
  if (!usable) return "fail";
  if (datum.verdict) return { FAIL: "fail", UNDECIDED: "undecided", INCOMPLETE: "undecided", PASS: "pass" }[datum.verdict.word];
  if (checksWith("fail").length > 0) return "fail";
  if (checksWith("undecided").length > 0 || datum.status === "partial") return "undecided";
  return checksWith("pass").length > 0 ? "pass" : "none";
}

const kVerdictIcons = { PASS: "\u2714", FAIL: "\u2716", UNDECIDED: "?", INCOMPLETE: "\u2026" };

/** How many checks ended how. */
function countsSentence() {
  const count = (verdict) => checksWith(verdict).length;
  const judged = count("pass") + count("fail") + count("undecided");
  if (judged === 0) return "No check of a code could be judged; see below for what each needs.";
  const failing = checksWith("fail").map((check) => `${check.code} ${check.name}`);
  const parts = [`${count("pass")} of ${plural(judged, "judged check")} pass`];
  if (failing.length > 0) parts.push(`${failing.length} fail: ${failing.join(", ")}`);
  if (count("undecided") > 0) parts.push(`${count("undecided")} undecided`);
  if (count("not_evaluated") > 0) parts.push(`${count("not_evaluated")} not evaluated`);
  if (count("not_applicable") > 0) parts.push(`${count("not_applicable")} not applicable`);
  return `${parts.join("; ")}.`;
}

function statusSentence() {
  const name = kStatusSentences[datum.status] || words(datum.status);
  if (!usable) return `${name}.`;
  const { measured, interpolated, missing } = datum.datum;
  const found = `${plural(measured, "station")} measured, ${interpolated} interpolated, ${missing} missing`;
  return `${levelled ? "Levelling survey" : name}: ${found}.`;
}

/** The word of the verdict, what it rests on, and the counts; of a refusal its reason. */
function verdictBox() {
  const { word, sentence: why } = datum.verdict || {};
  const lines = usable ? [why, countsSentence()] : [statusSentence(), sentence(datum.message || words(datum.status))];
  const heading = usable ? word || "NO VERDICT" : "NO DATUM";
  return make("div", { class: `verdict ${worstVerdict()}`, role: "status" },
    make("p", { class: "word" }, make("span", { "aria-hidden": "true" }, `${(usable && kVerdictIcons[word]) || "\u2013"} `), heading),
    lines.filter(Boolean).map((line) => make("p", {}, line)));
}

/** What the data are worth, beneath the verdict. */
function qualityLine() {
  if (!usable) return null;
  const sigmas = stations.filter((s) => s.flag === "measured" && known(s.sigma_z)).map((s) => s.sigma_z);
  const error = sigmas.length > 0 ? ` Standard error of an elevation ${millimetres(d3.median(sigmas), 2)} (median).` : "";
  const mind = datum.message ? ` ${sentence(datum.message)}` : "";
  return make("p", { class: "quality" }, make("strong", {}, "Data: "), `${statusSentence()}${error}${mind}`);
}

/** [name, value, further words] of the tank. */
function tankFacts() {
  if (!datum.tank) return [];
  const { center, radius, sigma_radius: sigma, coverage_deg: seen, side } = datum.tank;
  if (levelled) return [["Radius", metres(radius, 4), "as given"]];
  return [["Radius", metres(radius, 4), known(sigma) ? `\u00b1 ${anyFigure(Number((2e3 * sigma).toPrecision(2)))} mm (2\u03c3)` : ""],
    ["Centre x, y", center.map((c) => figure(c, 3)).join(", "), "m, frame of the scan"],
    ["Shell seen", degrees(seen), `from the ${side}`]];
}

/** The same of its datum. */
function datumFacts() {
  if (!usable) return [];
  const level = datum.datum, of = levelled ? "of the points levelled" : "the paper\u2019s curve";
  const list = [["Mean elevation", metres(level.mean, 4), level.surface ? `of the ${words(level.surface)}` : of],
    ["Highest", metres(level.max, 4), `at ${degrees(level.max_azimuth_deg, 1)}`],
    ["Lowest", metres(level.min, 4), `at ${degrees(level.min_azimuth_deg, 1)}`],
    ["Range", millimetres(level.range)]];
  const sigmas = stations.filter((s) => s.flag === "measured" && known(s.sigma_z)).map((s) => s.sigma_z);
  if (sigmas.length > 0) list.push(["Standard error", millimetres(d3.median(sigmas), 2), "median of the stations"]);
  if (datum.tilt) {
    const p = datum.tilt.p_value < 0.001 ? "p < 0.001" : `p ${figure(datum.tilt.p_value, 3)}`;
    list.push(["Tilt", withUnit(datum.tilt.angle_arcsec, 1, "\u2033"),
      `high side ${degrees(datum.tilt.direction_deg)}, low side ${degrees((datum.tilt.direction_deg + 180) % 360)}, R\u00b2 ${figure(datum.tilt.r2, 3)}${known(datum.tilt.p_value) ? `, ${p}` : ""}`]);
  }
  if (datum.antipodal && known(datum.antipodal.max_h)) {
    list.push(["Worst diameter", millimetres(datum.antipodal.max_h),
      `over ${metres(datum.antipodal.diameter)} at ${degrees(datum.antipodal.azimuth_deg)}: ${withUnit(datum.antipodal.angle_arcsec, 1, "\u2033")}`]);
  }
  return list;
}

function addSummary() {
  const section = addSection("summary", "Verdict");
  const facts = [...tankFacts(), ...datumFacts()];
  section.append(verdictBox());
  const quality = qualityLine();
  if (quality !== null) section.append(quality);
  if (facts.length > 0) section.append(boxes(facts));
  section.append(make("h3", {}, "Checks of the codes"));
  if (hasSection("checks") && datum.checks.length > 0) section.append(...checkTables());
  else sayAbsent(section, whyAbsent("Checks"));
  const missing = missingItems();
  section.append(make("h3", {}, "What is missing"), missing.length > 0 ? make("ul", {}, missing.map((item) => make("li", {}, typeset(item))))
    : make("p", {}, "Nothing: every station is measured or lies in a short gap that the curve bridges."));
  const notes = datum.notes || [];
  if (notes.length > 0) section.append(make("h3", {}, "Notes"), make("ul", {}, notes.map((note) => make("li", {}, typeset(note)))));
  section.append(make("div", { class: "paper-only" }, ["Inspector", "Date", "Signature"].map((name) => make("span", {}, name))));
}
