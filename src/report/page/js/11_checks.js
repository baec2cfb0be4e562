// The checks of the codes, each with its value, limit, verdict and how far its rule is trusted.

/** [unit shown, digits] of a check's figures: the unit that value and limit share. */
function scaleOf(check) {
  if (check.unit === "m/m") return [display.slope, 2];
  if (check.unit === "1/m") return [display.bend, 1];
  if (check.unit !== "m") return null;
  return [check.value, check.limit].filter(known).every((v) => Math.abs(v) < 1) ? [display.short, 1] : [display.long, 3];
}

function checked(value, check) {
  if (!known(value)) return "\u2013";
  const scale = scaleOf(check);
  if (scale === null) return check.unit ? `${anyFigure(value)}\u00a0${check.unit}` : anyFigure(value);
  return shownAs(value, scale[0], scale[1]);
}

/** A check's figures without their unit. */
function checkedFigure(value, check) {
  const scale = scaleOf(check);
  return scale === null ? anyFigure(value) : figure(scale[0][0] * value, scale[1] + scale[0][2]);
}

/** The 95 % interval of a check's figure, which is a maximum and reaches further up than down; else two sigma. */
function intervalOf(check) {
  if (!known(check.value)) return "";
  if (known(check.low95) && known(check.high95)) return say("checks.interval", { low: checkedFigure(check.low95, check), high: checked(check.high95, check) });
  return known(check.sigma) ? `\u00b1 ${checked(2 * check.sigma, check)} (2\u03c3)` : "";
}

const isSecond = (check) => check.role === "second opinion" && ["pass", "fail", "undecided"].includes(check.verdict);

/** The furthest beyond its limit first, or nearest to it; second opinions last. */
const gravestFirst = (checks) => [...checks].sort((a, b) => isSecond(a) - isSecond(b) || (utilisation(b) || 0) - (utilisation(a) || 0));

const checkTitle = (check) => `${check.code} ${checkName(check.name)}`;

/** A cell with something below it. */
function cellWith(heading, kind, text, below) {
  return make("td", { class: kind || false, "data-head": heading },
    make("span", {}, text, below.length > 0 ? make("small", { class: "quiet under" }, below) : null));
}

function checkRow(check) {
  const more = [intervalOf(check), known(check.azimuth_deg) ? say("common.at", { azimuth: degrees(check.azimuth_deg) }) : ""].filter(Boolean).join(", ");
  return [cellWith(say("checks.check"), "", capital(checkName(check.name)), [check.code, check.clause].filter(Boolean).join(", ")),
    cellWith(say("checks.value"), "number", checked(check.value, check), more),
    checked(check.limit, check),
    make("td", { class: `verdict-word ${check.verdict}`, "data-head": say("common.verdict") }, make("span", {}, words(check.verdict))),
    cellWith(say("checks.rules_source"), "", say(`source.${check.source}`), typeset(translated(check.citation) || "")),
    typeset([isSecond(check) ? say("checks.second_opinion") : "", inShownUnits(translated(check.note))].filter(Boolean).join("; "))];
}

/** The share of its limit that a check's figure takes; null where it has none. */
function utilisation(check) {
  return known(check.value) && known(check.limit) && check.limit > 0 ? Math.abs(check.value) / check.limit : null;
}

/** A check's share of its limit in per cent, with the interval of that. */
function shareText(check) {
  const percent = (value) => percentOf(value / check.limit);
  const interval = known(check.low95) && known(check.high95) ? ` ${say("checks.range", { low: percent(check.low95), high: percent(check.high95) })}` : "";
  return `${percentOf(utilisation(check))} %${interval}`;
}

/** A bar for each judged check, the fullest first; where one is beyond its limit, all are shortened and a line shows the limit. */
function utilisationBars() {
  const judged = [...checksWith("fail"), ...checksWith("undecided"), ...checksWith("pass")].filter((check) => utilisation(check) !== null);
  if (judged.length === 0) return null;
  judged.sort((a, b) => utilisation(b) - utilisation(a));
  const longest = Math.max(1, utilisation(judged[0]));
  return make("ul", { class: "bars", "aria-label": say("checks.share_of_its_limit_that") }, judged.map((check) => {
    const share = utilisation(check), bar = make("i", { class: check.verdict }), limit = longest > 1 ? make("em", {}) : null;
    bar.style.width = `${(100 * share) / longest}%`;
    if (limit !== null) limit.style.left = `${100 / longest}%`;
    const figures = say("checks.value_of_limit", { value: checkedFigure(check.value, check), limit: checked(check.limit, check) });
    return make("li", {}, make("span", {}, `${capital(checkName(check.name))}, ${check.code}: ${figures}`), make("span", { class: "track" }, bar, limit),
      make("span", { class: "number" }, shareText(check)));
  }));
}

const checkColumns = [[say("checks.check")], [say("checks.value"), "number"], [say("checks.limit"), "number"], [say("common.verdict")], [say("checks.rules_source")], [say("checks.note")]];

/** A table of checks, folded under its heading where that is given. */
function checksTable(checks, heading) {
  if (checks.length === 0) return null;
  const rows = table(checkColumns, checks.map(checkRow));
  return heading ? make("details", { class: "checks" }, make("summary", {}, heading), rows) : rows;
}

/** What fails or is undecided in sight, the rest folded. */
function checkTables() {
  const bars = utilisationBars(), isCrossed = bars !== null && bars.querySelector("em") !== null;
  const open = [...gravestFirst(checksWith("fail")), ...gravestFirst(checksWith("undecided"))], passes = checksWith("pass");
  const rest = [...checksWith("not_evaluated"), ...checksWith("not_applicable")];
  return [bars, isCrossed ? make("p", { class: "quiet" }, say("checks.the_line_is_the_limit")) : null, checksTable(open), checksTable(passes, passes.length === 1 ? say("checks.1_check_passes") : say("checks.checks_pass", { passes: passes.length })),
    checksTable(rest, say("checks.not_evaluated_or_not_applicable", { rest: rest.length })),
    make("p", { class: "quiet" }, say("checks.the_rules_source_says_how"))].filter(Boolean);
}
