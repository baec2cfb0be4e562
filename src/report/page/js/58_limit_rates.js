// How the judged figures go towards their limits, and when they may reach them, in the words that the terminal has.

/** A rate a year in the unit of its check, with one more digit than the figure. */
function rateText(value, check) {
  const scale = scaleOf(check);
  return scale === null ? checked(value, check) : shownAs(value, scale[0], scale[1] + 1);
}

/** When, or whether, a limit is reached. */
function approachText(rate) {
  const { approach, expected, earliest, latest } = rate;
  if (approach === "reached" && latest === null) return say("limit_rate.reached_open", { expected, earliest });
  return say(`limit_rate.${approach}`, { expected, earliest, latest });
}

/** The one whose limit may be reached first, or why there is none. */
function limitRatesText({ rates, none }) {
  if (rates.length === 0) return say(none);
  const [first] = rates;
  return say("limit_rate.sentence", { check: checkTitle(first), rate: signed(rateText(first.rate, first), first.rate), two_sigma: rateText(2 * first.sigma, first),
    limit: checked(first.limit, first), outcome: approachText(first) });
}

/** All of them in a table. */
function addLimitRates(section, { rates, none }) {
  if (rates.length === 0) {
    sayAbsent(section, say(none));
    return;
  }
  section.append(make("p", { class: "quiet" }, say("limit_rate.how")), table(
    [[say("checks.check")], [say("limit_rate.columns.now"), "number"], [say("limit_rate.columns.limit"), "number"], [say("limit_rate.columns.rate"), "number"], [say("limit_rate.columns.reached")]],
    rates.map((rate) => [checkTitle(rate), checked(rate.value, rate), checked(rate.limit, rate),
      cellWith(say("limit_rate.columns.rate"), "number", signed(rateText(rate.rate, rate), rate.rate), `\u00b1 ${rateText(2 * rate.sigma, rate)} (2\u03c3)`), capital(approachText(rate))])));
}
