// The page of several surveys: the movement of each since the first, and how fast each station moves.

const kTrendUnit = trend ? trend.trend.unit.replace("m/", "mm/") : "";
const rateOf = (s) => `${figure(1e3 * s.rate, 2)} \u00b1 ${withUnit(2e3 * s.sigma, 2, kTrendUnit)}`;
const dated = (name, date) => (date ? `${name} (${date})` : name);

function addTrend() {
  const surveys = trend.movements.map((movement) => ({ name: dated(movement.survey, movement.date), movement }));
  const rates = trend.trend.stations.filter((s) => known(s.rate));
  link.describe = (azimuth) => [...describeMovement(azimuth, surveys), ...describeRate(rates, azimuth)];
  addMovements(surveys, rates);
  addRates(rates);
  addCourse(addSection("course", "One azimuth over the surveys"), surveys, rates);
  addTrendProvenance();
}

function addMovements(surveys, rates) {
  const section = addSection("trend", "Movement between surveys"), last = surveys[surveys.length - 1].movement;
  const fastest = rates.reduce((best, s) => (best === null || Math.abs(s.rate) > Math.abs(best.rate) ? s : best), null);
  const moved = last.stations.filter((s) => s.significant).length;
  section.append(make("div", { class: "verdict none", role: "status" },
    make("p", {}, make("strong", { class: "breakable" }, `${moved} of ${plural(last.matched, "station")} moved significantly since ${dated(trend.baseline, trend.baseline_date)}; `
      + `largest ${millimetres(last.max, 2)} at ${degrees(last.max_azimuth_deg, 1)}.`)),
    make("p", {}, `${fastest ? `Fastest trend ${rateOf(fastest)} (2\u03c3) at ${degrees(fastest.azimuth_deg, 1)}. ` : ""}`
      + `Removed from the differences: ${last.removed}; error of registration ${millimetres(last.registration_error, 2)} and ${figure(last.registration_tilt_arcsec, 1)}\u2033.`)),
  table([["Survey"], ["Date"], ["Compared", "number"], ["Largest", "number"], ["At", "number"], ["RMS", "number"], ["Detectable from", "number"], ["Stations moved", "number"]],
    trend.movements.map((m) => [m.survey, m.date || "\u2013", `${m.matched}`, millimetres(m.max, 2), degrees(m.max_azimuth_deg, 1), millimetres(m.rms, 2),
      millimetres(d3.median(m.stations.filter((s) => known(s.dz)), (s) => s.lod95), 2), `${m.stations.filter((s) => s.significant).length}`]),
    "A station counts as moved by what its neighbours say too; the level of detection (95 %, median) is of one station alone."));
  drawMovements(section, "trend-chart", surveys);
}

/** The trend at an azimuth, for tips and listeners. */
function describeRate(rates, azimuth) {
  const s = nearestRow(rates, azimuth);
  if (s === null || angleApart(s.azimuth_deg, azimuth) > 1.5 * stepOfAzimuth()) return [["Trend", kUnknown]];
  return [["Trend", `${rateOf(s)} (2\u03c3)`]];
}

function addRates(rates) {
  const section = addSection("rates", "Trend of each station");
  if (rates.length === 0) return sayAbsent(section, "Trends: none, because no station is in two surveys.");
  section.append(make("p", { class: "quiet" }, `Least-squares slope of the elevation against ${trend.baseline_date ? "the date" : "the number of the survey"}.`));
  const rows = fewOrAll(trend.trend.stations.map((s) => ({ ...s, mm: known(s.rate) ? 1e3 * s.rate : null, half: known(s.lod95) ? 1e3 * s.lod95 : null })),
    (r) => r.mm);
  addChart(section, {
    id: "rate-chart", label: "Trend of the elevation against azimuth", ratio: 0.34, least: 270, most: 400,
    legend: [{ name: "rate", label: "trend; band: 95 %", colour: "fit" }],
    draw: (svg, width, height) => {
      const values = rows.flatMap((r) => (known(r.mm) ? [r.mm - (r.half || 0), r.mm + (r.half || 0)] : []));
      const axes = azimuthAxes(svg, width, height, room([0, ...values]), `Trend, up positive [${kTrendUnit}]`);
      drawLevel(svg, axes, 0, "zero");
      drawBand(svg, axes, rows, (r) => r.mm, (r) => r.half);
      drawLine(svg, axes, rows, (r) => r.mm, "fit");
      drawFew(svg, axes, rows, (r) => r.mm);
      followPointer(svg, azimuthUnder(axes), (azimuth) => [["Azimuth", degrees(azimuth, 1)], ...describeRate(rates, azimuth)]);
      return azimuthMarks(svg, axes, height, (azimuth) => {
        const r = nearestRow(rows, azimuth);
        return angleApart(r.azimuth_deg, azimuth) < 2 ? r.mm : null;
      });
    },
  });
}

function addTrendProvenance() {
  const section = addSection("provenance", "How it was made");
  section.append(table([["Survey"], ["Date"], ["SHA-256"]], trend.surveys.map((survey) => [survey.path, survey.date || "\u2013",
    make("td", { "data-head": "SHA-256" }, make("code", { class: "breakable" }, survey.sha256))])),
  make("p", {}, `tank_datum_compare ${trend.version}; the first survey is the baseline.`),
  make("h3", {}, "Options"), make("pre", { tabindex: 0, "aria-label": "Every option used" }, JSON.stringify(trend.options, null, 2)),
  make("div", { class: "controls" }, make("strong", {}, "Data to take along"),
    saveButton("movement.json", "movement.json", () => embeddedText("trend"), "application/json"),
    saveButton("movement.csv", "movement.csv", () => embeddedText("movements"), "text/csv")));
}
