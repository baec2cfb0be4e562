// The page of several surveys: the movement of each since the first, and how the chosen azimuth went.

function addTrend() {
  const surveys = trend.movements.map((movement, i) => ({ name: movement.survey || `survey ${i + 2}`, movement }));
  const section = addSection("trend", "Movement between surveys");
  section.append(make("p", { class: "breakable" }, `Since ${surveys[0].movement.baseline}; removed: ${surveys[0].movement.removed}.`),
    table([["Survey"], ["Largest", "number"], ["At", "number"], ["RMS", "number"], ["Stations moved", "number"]],
      surveys.map(({ name, movement: m }) => [name, millimetres(m.max, 2), degrees(m.max_azimuth_deg, 1), millimetres(m.rms, 2),
        `${m.stations.filter((s) => s.significant).length} of ${m.stations.length}`])));
  drawMovements(section, "trend-chart", surveys);
  const course = addSection("course", "One azimuth over the surveys");
  const chart = addCourse(course, surveys);
  document.addEventListener("station", () => drawChart(chart));
  const files = addSection("provenance", "Data");
  files.append(make("div", { class: "controls" }, saveButton("movement.json", "movement.json", () => embeddedText("trend"), "application/json")));
}

function addCourse(section, surveys) {
  return addChart(section, {
    id: "course-chart", label: "Movement at the chosen azimuth, survey by survey", ratio: 0.34, least: 260, most: 400,
    legend: [{ name: "course", label: "movement with its level of detection (95 %); choose an azimuth in the chart above", colour: "datum" }],
    draw: (svg, width, height) => {
      const at = [{ mm: 0, lod: 0, name: "baseline" }, ...surveys.map(({ name, movement }) => {
        const s = nearestRow(movement.stations, link.chosen);
        return { name, mm: s && known(s.dz) ? 1e3 * s.dz : null, lod: s && known(s.lod95) ? 1e3 * s.lod95 : 0 };
      })];
      const x = d3.scalePoint(at.map((_, i) => i), [62, width - 14]).padding(0.4);
      const y = d3.scaleLinear(room(at.flatMap((p) => (known(p.mm) ? [p.mm - p.lod, p.mm + p.lod] : []))), [height - 44, 26]).nice();
      drawAxes(svg, x, y, x.domain(), `Movement at ${degrees(link.chosen, 1)} [mm]`, "Survey, 0 the baseline");
      svg.append("path").attr("class", "line datum").attr("d", d3.line().defined((p) => known(p.mm)).x((_, i) => x(i)).y((p) => y(p.mm))(at));
      at.forEach((p, i) => {
        if (!known(p.mm)) return;
        svg.append("line").attr("class", "whisker").attr("x1", x(i)).attr("x2", x(i)).attr("y1", y(p.mm - p.lod)).attr("y2", y(p.mm + p.lod));
        svg.append("circle").attr("class", "chosen").attr("r", 4).attr("cx", x(i)).attr("cy", y(p.mm))
          .append("title").text(`${p.name}: ${withUnit(p.mm, 2, "mm")}`);
      });
    },
  });
}
