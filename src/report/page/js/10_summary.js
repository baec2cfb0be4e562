// The verdict and the facts of the tank.

const kStatusSentences = {
  ok: say("summary.datum_found_all_round"),
  partial: say("summary.datum_found_in_part"),
  no_tank: say("summary.no_tank_found"),
  doubtful: say("summary.perhaps_no_tank"),
  no_crease: say("summary.no_datum_found"),
  too_few_points: say("summary.too_few_points"),
  fit_failed: say("summary.no_curve_could_be_fitted"),
};

const checksWith = (verdict) => (datum.checks || []).filter((check) => check.verdict === verdict);

/** pass, fail or undecided: the worst that any check says. */
function worstVerdict() {
  if (!usable) return "fail";
  if (datum.verdict) return kVerdictClasses[datum.verdict.word];
  if (checksWith("fail").length > 0) return "fail";
  if (checksWith("undecided").length > 0 || datum.status === "partial") return "undecided";
  return checksWith("pass").length > 0 ? "pass" : "none";
}

const kVerdictClasses = { FAIL: "fail", UNDECIDED: "undecided", INCOMPLETE: "undecided", PASS: "pass" };
const kVerdictIcons = { PASS: "\u2714", FAIL: "\u2716", UNDECIDED: "?", INCOMPLETE: "\u2026" };

/** How many checks ended how. */
function countsSentence() {
  const count = (verdict) => checksWith(verdict).length;
  const judged = count("pass") + count("fail") + count("undecided");
  if (judged === 0) return say("summary.no_check_of_a_code");
  const failing = gravestFirst(checksWith("fail")).map((check) => `${checkTitle(check)}${isSecond(check) ? ` (${say("checks.second_opinion")})` : ""}`);
  const of = say("count.judged_check", { count: judged });
  const parts = [say("summary.of_pass", { count: judged, pass: count("pass"), judged: of })];
  if (failing.length > 0) parts.push(say("summary.fail", { failing: failing.length, failing_2: failing.join(", ") }));
  if (count("undecided") > 0) parts.push(say("summary.undecided", { undecided: count("undecided") }));
  if (count("not_evaluated") > 0) parts.push(say("summary.not_evaluated", { not_evaluated: count("not_evaluated") }));
  if (count("not_applicable") > 0) parts.push(say("summary.not_applicable", { not_applicable: count("not_applicable") }));
  return `${parts.join("; ")}.`;
}

function statusSentence() {
  const name = kStatusSentences[datum.status] || words(datum.status);
  if (!usable) return `${name}.`;
  const { measured, interpolated, missing } = datum.datum;
  const found = say("summary.measured_interpolated_missing", { measured: say("count.station", { count: measured }), interpolated, missing });
  return `${levelled ? say("summary.levelling_survey") : name}: ${found}.`;
}

/** "API 653 out-of-plane settlement S_i" with its name in the page's language. */
function governingTitle(governing) {
  const name = Object.keys(kLanguages.en).filter((key) => key.startsWith("check_name.")).map((key) => kLanguages.en[key])
    .filter((known_name) => governing.endsWith(` ${known_name}`)).sort((one, other) => other.length - one.length)[0];
  return name === undefined ? governing : `${governing.slice(0, -name.length)}${checkName(name)}`;
}

/** How sure the verdict is, in the page's language; a full stop where datum.json says it in other words. */
function verdictMeaning(given) {
  const found = Object.entries(kLanguages.en).find(([key, text]) => key.startsWith("verdict.is_") && given.includes(text));
  return found ? say(found[0]) : ".";
}

/** A share of a limit in per cent, on its own side of the limit. */
function percentOf(share) {
  const text = figure(100 * share, 0);
  if (text !== figure(100, 0) || share === 1) return text;
  return figure((share < 1 ? Math.floor(1e4 * share) : Math.ceil(1e4 * share)) / 100, 2);
}

/** What a verdict rests on, from its figures; where they are not all there as datum.json has it. */
function verdictSentence(verdict, check) {
  const { word, governing, utilisation: used, utilisation_95: interval, sentence: given } = verdict || {};
  if (!given) return "";
  if (!governing) return `${say("verdict.no_rule")} ${say("common.screening")}`;
  const rule = governingTitle(governing), [low, high] = interval || [null, null];
  if (word === "INCOMPLETE" && check) return `${say("verdict.not_evaluated", { rule, note: inShownUnits(translated(check.note)) })} ${say("common.screening")}`;
  if (word === "INCOMPLETE" || !known(used)) return given;
  const between = known(low) && known(high) ? say("verdict.interval", { low: percentOf(low), high: percentOf(high) }) : "";
  const [, azimuth] = / at (\d+) deg/.exec(given) || [], place = azimuth ? ` ${say("common.at", { azimuth: degrees(Number(azimuth)) })}` : "";
  return `${say("verdict.share", { rule, share: percentOf(used), interval: between, place, meaning: verdictMeaning(given) })} ${say("common.screening")}`;
}

/** The check that a verdict rests on. */
const governingCheck = () => (datum.checks || []).find((c) => `${c.code} ${c.name}` === (datum.verdict || {}).governing);

/** The word of the verdict, what it rests on, and the counts; of a refusal its reason. */
function verdictBox() {
  const { word } = datum.verdict || {};
  const lines = usable ? [verdictSentence(datum.verdict, governingCheck()), countsSentence()] : [statusSentence(), sentence(translated(datum.message) || words(datum.status))];
  const heading = usable ? (word && words(word)) || say("summary.no_verdict") : say("summary.no_datum");
  return make("div", { class: `verdict ${worstVerdict()}`, role: "status" },
    make("p", { class: "word" }, make("span", { "aria-hidden": "true" }, `${(usable && kVerdictIcons[word]) || "\u2013"} `), heading),
    lines.filter(Boolean).map((line) => make("p", {}, line)));
}

/** Median standard error of the stations measured; unknown without any. */
const medianSigma = () => d3.median(stations.filter((s) => s.flag === "measured" && known(s.sigma_z)), (s) => s.sigma_z);

/** What the data are worth, beneath the verdict. */
function qualityLine() {
  if (!usable) return null;
  const sigma = medianSigma();
  const error = known(sigma) ? say("summary.standard_error_of_an_elevation", { sigma: shortLength(sigma, 2) }) : "";
  const mind = datum.message ? ` ${sentence(translated(datum.message))}` : "";
  return make("p", { class: "quality" }, make("strong", {}, say("summary.data")), `${statusSentence()}${error}${mind}`);
}

/** [name, value, further words] of the tank. */
function tankFacts() {
  if (!datum.tank) return [];
  const { center, radius, sigma_radius: sigma, coverage_deg: seen, side } = datum.tank;
  if (levelled) return [[say("common.radius"), longLength(radius, 4), say("summary.as_given")]];
  return [[say("common.radius"), longLength(radius, 4), known(sigma) ? `\u00b1 ${Number(toShort(2 * sigma).toPrecision(2))} ${kShortUnit} (2\u03c3)` : ""],
    [say("summary.centre_x_y"), center.map((c) => figure(toLong(c), 3)).join(", "), say("summary.frame_of_the_scan", { unit: kLongUnit })],
    [say("summary.shell_seen"), degrees(seen), say("summary.from_the", { side: words(side) })]];
}

/** Whether a tilt stands out of its errors, so that it has a high side. */
const isTilted = (tilt) => tilt.angle_arcsec >= 0.05 && !(tilt.slope < 2 * tilt.sigma_slope);

/** Its error, its sides and how well a plane fits. */
function tiltWords({ direction_deg: high, sigma_slope: sigma, r2: share, p_value: chance, ...tilt }) {
  const error = known(sigma) ? `\u00b1 ${withUnit((Math.atan(2 * sigma) * 180 * 3600) / Math.PI, 1, "\u2033")} (2\u03c3), ` : "";
  const p = known(chance) ? `, ${chance < 0.001 ? "p < 0.001" : `p ${figure(chance, 3)}`}` : "", r2 = figure(share, 3);
  if (!isTilted({ ...tilt, sigma_slope: sigma })) return `${error}${say("movement.not_significant")}, R\u00b2 ${r2}${p}`;
  return error + say("summary.high_side_low_side_r", { direction_deg: roundAzimuth(high), direction_deg_2: roundAzimuth(high + 180), r2, p_value: p });
}

/** The same of its datum. */
function datumFacts() {
  if (!usable) return [];
  const level = datum.datum, of = levelled ? say("summary.of_the_points_levelled") : say("summary.the_papers_curve");
  const list = [[say("summary.mean_elevation"), longLength(level.mean, 4), level.surface ? say("summary.of_the", { surface: words(level.surface) }) : of],
    [say("summary.highest"), longLength(level.max, 4), say("common.at", { azimuth: degrees(level.max_azimuth_deg, 1) })],
    [say("summary.lowest"), longLength(level.min, 4), say("common.at", { azimuth: degrees(level.min_azimuth_deg, 1) })],
    [say("summary.range"), shortLength(level.range)]];
  const sigma = medianSigma();
  if (known(sigma)) list.push([say("summary.standard_error"), shortLength(sigma, 2), say("summary.median_of_the_stations")]);
  if (datum.tilt) {
    list.push([say("common.tilt"), withUnit(datum.tilt.angle_arcsec, 1, "\u2033"), tiltWords(datum.tilt)]);
  }
  if (datum.antipodal && known(datum.antipodal.max_h)) {
    list.push([say("summary.worst_diameter"), shortLength(datum.antipodal.max_h),
      say("summary.over_at", { diameter: longLength(datum.antipodal.diameter), azimuth_deg: degrees(datum.antipodal.azimuth_deg), angle_arcsec: withUnit(datum.antipodal.angle_arcsec, 1, "\u2033") })]);
  }
  return list;
}

function addSummary() {
  const section = addSection("summary", say("common.verdict"));
  const facts = [...tankFacts(), ...datumFacts()];
  section.append(verdictBox());
  const quality = qualityLine();
  if (quality !== null) section.append(quality);
  if (hasMovement(datum.movement)) section.append(make("p", { class: "quality" }, make("strong", {}, say("movement.line")), typeset(movementText(datum.movement))));
  if (hasMovement(datum.movement) && datum.movement.limits) section.append(make("p", { class: "quality" }, make("strong", {}, say("limit_rate.line")), typeset(limitRatesText(datum.movement.limits))));
  if (facts.length > 0) section.append(boxes(facts));
  section.append(make("h3", {}, say("summary.checks_of_the_codes")));
  if (hasSection("checks") && datum.checks.length > 0) section.append(...checkTables());
  else sayAbsent(section, whyAbsent(say("summary.checks")));
  const missing = missingItems();
  section.append(make("h3", {}, say("summary.what_is_missing")), missing.length > 0 ? make("ul", {}, missing.map((item) => make("li", {}, typeset(item))))
    : make("p", {}, say("summary.nothing_every_station_is_measured")));
  const notes = datum.notes || [];
  if (notes.length > 0) section.append(make("h3", {}, say("common.notes")), make("ul", {}, notes.map((note) => make("li", {}, typeset(inShownUnits(translated(note)))))));
  if (kSpoken !== kLanguages.en) section.append(make("p", { class: "quiet" }, say("missing.in_english")));
  addSignature(section);
}
