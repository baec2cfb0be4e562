// The page of several surveys: the movement of each since the first, and how fast each station moves.

const kTrendUnit = trend ? say(trend.trend.unit === "m/year" ? "trend.unit_per_year" : "trend.unit_per_survey", { unit: kShortUnit }) : "";
const rateOf = (s) => `${figure(toShort(s.rate), 2 + display.short[2])} \u00b1 ${withUnit(toShort(twice(s.sigma)), 2 + display.short[2], kTrendUnit)}`;
const dated = (name, date) => (date ? `${name} (${date})` : name);

const fastestOf = (rates) => rates.reduce((best, s) => (Math.abs(s.rate) > Math.abs(best.rate) ? s : best));

function addTrend() {
  const surveys = trend.movements.map((movement) => ({ name: dated(movement.survey, movement.date), movement }));
  const rates = trend.trend.stations.filter((s) => known(s.rate));
  link.describe = (azimuth) => [...describeMovement(azimuth, surveys), ...describeRate(rates, azimuth)];
  if (rates.length > 0) link.chosen = askedOf(trend.trend.stations) ?? fastestOf(rates).azimuth_deg;
  addMovements(surveys, rates);
  addRates(rates);
  if (trend.limits) addLimitRates(addSection("limits", say("limit_rate.heading")), trend.limits);
  addCourse(addSection("course", say("trend.one_azimuth_over_the_surveys")), surveys, rates);
  addTrendProvenance();
}

function addMovements(surveys, rates) {
  const section = addSection("trend", say("trend.movement_between_surveys")), last = surveys[surveys.length - 1].movement;
  const fastest = rates.length > 0 ? fastestOf(rates) : null;
  const word = hasMovement(last) ? movementWord(last) : "";
  section.append(make("div", { class: `verdict ${last.moved ? "undecided" : "none"}`, role: "status" },
    word ? make("p", { class: "word" }, make("span", { "aria-hidden": "true" }, last.moved ? "\u2260 " : "= "), word) : null,
    make("p", { class: "breakable" }, say("movement.since", { baseline: dated(trend.baseline, trend.baseline_date) })),
    hasMovement(last) ? make("p", {}, typeset(movementText(last).slice(word.length + 2))) : null,
    trend.limits ? make("p", {}, make("strong", {}, say("limit_rate.line")), typeset(limitRatesText(trend.limits))) : null,
    make("p", {}, `${fastest ? say("trend.fastest_trend_2_at", { fastest: rateOf(fastest), azimuth_deg: degrees(fastest.azimuth_deg, 1) }) : ""}${movementTerms(last)}`)),
  table([[say("trend.survey")], [say("common.date")], [say("trend.compared"), "number"], [say("trend.largest"), "number"], [say("trend.at"), "number"], ["RMS", "number"], [say("trend.detectable_from"), "number"], [say("trend.stations_moved"), "number"]],
    trend.movements.map((m) => [m.survey, m.date || "\u2013", `${m.matched}`, shortLength(m.max, 2), degrees(m.max_azimuth_deg, 1), shortLength(m.rms, 2),
      shortLength(d3.median(m.stations.filter((s) => known(s.dz)), (s) => s.lod95), 2), `${m.stations.filter((s) => s.significant).length}`]),
    say("trend.a_station_counts_as_moved")));
  addSignature(section);
  addMovementCharts(section, last, "trend", surveys);
}

/** The trend at an azimuth, for tips and listeners. */
function describeRate(rates, azimuth) {
  const s = nearestRow(rates, azimuth);
  if (s === null || angleApart(s.azimuth_deg, azimuth) > 1.5 * stepOfAzimuth()) return [[say("trend.trend"), kUnknown]];
  return [[say("trend.trend"), `${rateOf(s)} (2\u03c3)`]];
}

function addRates(rates) {
  const section = addSection("rates", say("trend.trend_of_each_station"));
  if (rates.length === 0) return sayAbsent(section, say("trend.trends_none_because_no_station"));
  section.append(make("p", { class: "quiet" }, say("trend.least_squares_slope_of_the", { baseline_date: trend.baseline_date ? say("trend.the_date") : say("trend.the_number_of_the_survey") })));
  const rows = fewOrAll(trend.trend.stations.map((s) => ({ ...s, value: toShort(s.rate), half: toShort(s.lod95) })),
    (r) => r.value);
  addChart(section, {
    id: "rate-chart", label: say("trend.trend_of_the_elevation_against"), ratio: 0.34, least: 270, most: 400,
    legend: [{ name: "rate", label: say("trend.trend_band_95"), colour: "fit" }],
    draw: (svg, width, height) => {
      const values = rows.flatMap((r) => (known(r.value) ? [r.value - (r.half || 0), r.value + (r.half || 0)] : []));
      const axes = azimuthAxes(svg, width, height, room([0, ...values]), say("trend.trend_up_positive", { unit: kTrendUnit }));
      drawLevel(svg, axes, 0, "zero");
      drawBand(svg, axes, rows, (r) => r.value, (r) => r.half);
      drawLine(svg, axes, rows, (r) => r.value, "fit");
      drawFew(svg, axes, rows, (r) => r.value);
      followPointer(svg, azimuthUnder(axes), (azimuth) => [[say("common.azimuth"), degrees(azimuth, 1)], ...describeRate(rates, azimuth)]);
      return azimuthMarks(svg, axes, height, (azimuth) => {
        const r = nearestRow(rows, azimuth);
        return angleApart(r.azimuth_deg, azimuth) < 2 ? r.value : null;
      });
    },
  });
}

function addTrendProvenance() {
  const section = addSection("provenance", say("common.how_it_was_made"));
  section.append(table([[say("trend.survey")], [say("common.date")], ["SHA-256"]], trend.surveys.map((survey) => [survey.path, survey.date || "\u2013",
    make("td", { "data-head": "SHA-256" }, make("code", { class: "breakable" }, survey.sha256))])),
  make("p", {}, say("trend.tank_datum_compare_the_first", { version: trend.version })),
  ...optionsAppendix(trend.options),
  make("div", { class: "controls" }, make("strong", {}, say("common.data_to_take_along")),
    saveButton("movement.json", "movement.json", () => embeddedText("trend"), "application/json"),
    saveButton("movement.csv", "movement.csv", () => embeddedText("movements"), "text/csv")));
}
