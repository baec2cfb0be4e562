// How the chosen azimuth went over the surveys, against their dates where they have any.

/** A date as 2024-05-31 or 2024.41 in years. */
function yearOf(date) {
  const parts = /^(\d+)-(\d+)-(\d+)$/.exec(date);
  if (parts === null) return Number(date);
  const [year, month, day] = parts.slice(1).map(Number), from = Date.UTC(year, 0, 1);
  return year + (Date.UTC(year, month - 1, day) - from) / (Date.UTC(year + 1, 0, 1) - from);
}

const kLetter = 3.6;  // half the width of a figure [px]

/** The surveys at an azimuth, the baseline first: {time, label, value, lod}. */
function courseAt(azimuth, surveys) {
  const first = { time: trend.baseline_date ? yearOf(trend.baseline_date) : 0, label: trend.baseline_date || "0", value: 0, lod: 0 };
  return [first, ...surveys.map(({ movement: m }, i) => {
    const s = nearestRow(m.stations, azimuth), near = s !== null && angleApart(s.azimuth_deg, azimuth) < 2;
    return { time: m.date ? yearOf(m.date) : i + 1, label: m.date || String(i + 1), value: near ? toShort(s.dz) : null, lod: near ? toShort(s.lod95) || 0 : 0 };
  })];
}

function addCourse(section, surveys, rates) {
  const chart = addChart(section, {
    id: "course-chart", label: say("course.movement_at_the_chosen_azimuth"), ratio: 0.34, least: 260, most: 400,
    legend: [{ name: "course", label: say("course.movement_with_its_level_of"), colour: "datum" },
      { name: "trend", label: say("course.trend"), colour: "fit", on: true }],
    draw: (svg, width, height, shown) => drawCourse(svg, width, height, courseAt(link.chosen, surveys), shown.trend ? nearestRow(rates, link.chosen) : null),
  });
  document.addEventListener("station", () => drawChart(chart));
}

function drawCourse(svg, width, height, at, rate) {
  const seen = at.filter((p) => known(p.value)), times = at.map((p) => p.time), span = times[times.length - 1] - times[0];
  const half = kLetter * d3.max(at, (p) => p.label.length), margin = (span * half) / (width - 76 - 2 * half);  // room for the labels
  const x = d3.scaleLinear([times[0] - margin, times[times.length - 1] + margin], [62, width - 14]);
  const said = rate === null || seen.length < 2 ? "" : width < kNarrow ? rateOf(rate) : say("course.trend_2", { rate: rateOf(rate) });
  const title = say("course.movement_at", { chosen: degrees(link.chosen, 1), unit: kShortUnit }), crowded = 2 * kLetter * (title.length + said.length + 2) > width;
  const y = d3.scaleLinear(room(seen.flatMap((p) => [p.value - p.lod, p.value + p.lod])), [height - 44, crowded ? 42 : 26]).nice();
  drawAxes(svg, x, y, [], title, trend.baseline_date ? say("course.date_of_the_survey_the") : say("course.survey_0_the_baseline"));
  drawSurveyTicks(svg, x, y, at);
  svg.append("path").attr("class", "line datum").attr("d", d3.line().x((p) => x(p.time)).y((p) => y(p.value))(seen));
  if (seen.length === 1) {
    svg.append("text").attr("class", "gap-label").attr("x", width / 2).attr("y", 44).attr("text-anchor", "middle").text(say("course.no_later_survey_was_compared"));
  }
  if (said) {
    const time = d3.mean(seen, (p) => p.time), middle = d3.mean(seen, (p) => p.value);
    const level = (t) => y(middle + toShort(rate.rate) * (t - time));
    svg.append("line").attr("class", "line fit").attr("x1", x(times[0])).attr("y1", level(times[0]))
      .attr("x2", x(times[times.length - 1])).attr("y2", level(times[times.length - 1]));
    svg.append("text").attr("x", width - 14).attr("y", crowded ? 30 : 14).attr("text-anchor", "end").text(said);
  }
  for (const p of seen) {
    svg.append("line").attr("class", "whisker").attr("x1", x(p.time)).attr("x2", x(p.time)).attr("y1", y(p.value - p.lod)).attr("y2", y(p.value + p.lod));
    svg.append("circle").attr("class", "survey-point").attr("r", 4).attr("cx", x(p.time)).attr("cy", y(p.value))
      .append("title").text(`${p.label}: ${inShort(p.value, 2)}`);
  }
}

/** A tick for each survey; its label where the one before leaves room. */
function drawSurveyTicks(svg, x, y, at) {
  const low = y.range()[0];
  let free = -Infinity;
  for (const p of at) {
    const place = x(p.time), half = kLetter * p.label.length;
    svg.append("line").attr("class", "zero").attr("x1", place).attr("x2", place).attr("y1", low).attr("y2", low + 6);
    if (place - half < free) continue;
    free = place + half + 8;
    svg.append("text").attr("class", "survey-label").attr("x", place).attr("y", low + 18).attr("text-anchor", "middle").text(p.label);
  }
}
