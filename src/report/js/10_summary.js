// The verdict, the facts of the tank, the checks of the codes, what is missing, and how far to trust it.

const kStatusSentences = {
  ok: "Datum found all round",
  partial: "Datum found in part",
  no_tank: "No tank found",
  no_crease: "No datum found",
  too_few_points: "Too few points",
  fit_failed: "No curve could be fitted",
};

const checksWith = (verdict) => (datum.checks || []).filter((check) => check.verdict === verdict);

/** pass, fail or undecided: the worst that any check says. */
function worstVerdict() {
  if (!usable || checksWith("fail").length > 0) return "fail";
  if (checksWith("undecided").length > 0 || datum.status === "partial") return "undecided";
  return checksWith("pass").length > 0 ? "pass" : "none";
}

function verdictSentence() {
  if (!usable) return datum.message || words(datum.status);
  const count = (verdict) => checksWith(verdict).length;
  const judged = count("pass") + count("fail") + count("undecided");
  if (judged === 0) return "No check of a code could be judged; see below for what each needs.";
  const failing = checksWith("fail").map((check) => `${check.name} (${check.code})`);
  const parts = [`${count("pass")} of ${judged} judged checks pass`];
  if (failing.length > 0) parts.push(`${failing.length} fail: ${failing.join(", ")}`);
  if (count("undecided") > 0) parts.push(`${count("undecided")} undecided`);
  return `${parts.join("; ")}.`;
}

function stationsSentence() {
  const { measured, interpolated, missing } = datum.datum;
  return `${measured} stations measured, ${interpolated} interpolated, ${missing} missing`;
}

function verdictBox() {
  const head = usable ? `${kStatusSentences[datum.status]}: ${stationsSentence()}.` : `${kStatusSentences[datum.status] || words(datum.status)}.`;
  return make("div", { class: `verdict ${worstVerdict()}`, role: "status" },
    make("p", {}, make("strong", {}, head)), make("p", {}, verdictSentence()));
}

/** [name, value, further words] of the tank and its datum. */
function facts() {
  const list = [];
  if (datum.tank) {
    const { center, radius, sigma_radius: sigma, coverage_deg: seen, side } = datum.tank;
    list.push(["Radius", metres(radius, 4), known(sigma) ? `\u00b1 ${anyFigure(Number((2e3 * sigma).toPrecision(2)))} mm (2\u03c3)` : ""],
      ["Centre x, y", center.map((c) => figure(c, 3)).join(", "), "m, frame of the scan"],
      ["Shell seen", degrees(seen), `from the ${side}`]);
  }
  if (!usable) return list;
  const level = datum.datum;
  list.push(["Mean elevation", metres(level.mean, 4), level.surface ? `of the ${words(level.surface)}` : "the paper\u2019s curve"],
    ["Highest", metres(level.max, 4), `at ${degrees(level.max_azimuth_deg, 1)}`],
    ["Lowest", metres(level.min, 4), `at ${degrees(level.min_azimuth_deg, 1)}`],
    ["Range", millimetres(level.range)]);
  const sigmas = stations.filter((s) => s.flag === "measured" && known(s.sigma_z)).map((s) => s.sigma_z);
  if (sigmas.length > 0) list.push(["Standard error", millimetres(d3.median(sigmas), 2), "median of the stations"]);
  if (datum.tilt) {
    list.push(["Tilt", withUnit(datum.tilt.angle_arcsec, 1, "\u2033"),
      `up towards ${degrees(datum.tilt.direction_deg)}, R\u00b2 ${figure(datum.tilt.r2, 3)}, p ${anyFigure(datum.tilt.p_value)}`]);
  }
  if (datum.antipodal && known(datum.antipodal.max_h)) {
    list.push(["Worst diameter", millimetres(datum.antipodal.max_h),
      `over ${metres(datum.antipodal.diameter)} at ${degrees(datum.antipodal.azimuth_deg)}: ${withUnit(datum.antipodal.angle_arcsec, 1, "\u2033")}`]);
  }
  return list;
}

function factList() {
  return make("dl", { class: "facts" }, facts().map(([name, value, more]) => (
    make("div", {}, make("dt", {}, name), make("dd", {}, value, more ? make("small", {}, more) : null)))));
}

function checksTable() {
  const rows = datum.checks.map((check) => {
    const verdict = make("td", { class: `verdict-word ${check.verdict}`, "data-head": "Verdict" }, words(check.verdict));
    const rule = [check.code, check.clause].filter(Boolean).join(", ");
    const trust = make("td", { "data-head": "Rule\u2019s source" }, check.source, check.citation ? make("small", { class: "quiet" }, ` (${check.citation})`) : "");
    return [check.name, rule, checkedValue(check), withUnitOf(check.limit, check.unit), verdict, trust, check.note || ""];
  });
  return table([["Check"], ["Rule"], ["Value", "number"], ["Limit", "number"], ["Verdict"], ["Rule\u2019s source"], ["Note"]], rows,
    "The rule\u2019s source says how its limit was read: verified in the standard, from a secondary source, or unverified.");
}

/** A figure of a check: lengths of less than a metre in millimetres. */
function withUnitOf(value, unit) {
  if (!known(value)) return "\u2013";
  if (unit === "m" && Math.abs(value) < 1) return millimetres(value);
  return unit ? `${anyFigure(value)}\u00a0${unit}` : anyFigure(value);
}

/** The value with its uncertainty and where it stands. */
function checkedValue(check) {
  const more = [known(check.sigma) && known(check.value) ? `\u00b1 ${withUnitOf(2 * check.sigma, check.unit)} (2\u03c3)` : "",
    known(check.azimuth_deg) ? `at ${degrees(check.azimuth_deg)}` : ""].filter(Boolean).join(", ");
  return make("td", { class: "number", "data-head": "Value" }, make("span", {}, withUnitOf(check.value, check.unit),
    more ? make("small", { class: "quiet under" }, more) : ""));
}

/** Stretches that were not seen, in degrees. */
function missingList() {
  const half = stepOfAzimuth() / 2;
  return missingStretches().map(([first, last]) => (
    `${degrees(stations[first].azimuth_deg - half, 1)} to ${degrees(stations[last].azimuth_deg + half, 1)}`));
}

function addSummary() {
  const section = addSection("summary", "Verdict");
  section.append(verdictBox(), factList());
  section.append(make("h3", {}, "Checks of the codes"));
  if (hasSection("checks") && datum.checks.length > 0) section.append(checksTable());
  else section.append(make("p", { class: "absent" }, whyAbsent("Checks")));
  section.append(make("h3", {}, "What is missing"));
  const gaps = missingList();
  if (!usable) section.append(make("p", {}, datum.message));
  else if (gaps.length === 0) section.append(make("p", {}, "Nothing: every station is measured or lies in a short gap that the curve bridges."));
  else section.append(make("p", {}, `The datum was not seen, or something stands before it, at azimuths ${gaps.join(", ")}. Nothing is given there.`));
  const notes = datum.notes || [];
  if (notes.length > 0) section.append(make("h3", {}, "Notes"), make("ul", {}, notes.map((note) => make("li", {}, note))));
}
