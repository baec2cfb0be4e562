// The shell above the datum: its map unrolled, its roundness at heights, its plumbness.

function addShell() {
  const section = addSection("shell", "Shell");
  if (!usable) return sayAbsent(section, whyAbsent("Shell"));
  const shell = datum.shell || null;
  if (shell === null) {
    return sayAbsent(section, "Roundness, plumbness and the map of the shell: not in this result, because the scan shows too little of the shell above the datum.");
  }
  if (shellMap !== null) addShellMap(section);
  if ((shell.roundness || []).length > 0) addRoundness(section, shell.roundness);
  if ((shell.plumbness || []).length > 0) addPlumbness(section, shell);
}

function addRoundness(section, rounds) {
  section.append(make("h3", {}, "Roundness at heights"), table(
    [["Height", "number"], ["Radius", "number"], ["Largest", "number"], ["Smallest", "number"], ["At", "number"], ["2\u03c3", "number"], ["Points", "number"], ["Tolerance", "number"], ["Verdict"]],
    rounds.map((r) => [metres(r.height, 2), metres(r.radius, 4), millimetres(r.max_deviation), millimetres(r.min_deviation), degrees(r.azimuth_deg),
      millimetres(known(r.sigma) ? 2 * r.sigma : null, 2), anyFigure(r.n), millimetres(r.tolerance),
      make("td", { class: `verdict-word ${r.verdict}`, "data-head": "Verdict" }, words(r.verdict || ""))])));
}

function addPlumbness(section, shell) {
  const rows = shell.plumbness.map((p) => ({ azimuth_deg: p.azimuth_deg, mm: known(p.offset) ? 1e3 * p.offset : null,
    half: known(p.sigma) ? 2e3 * p.sigma : null, height: p.height }));
  const nearest = (azimuth) => rows.reduce((best, r) => (angleApart(r.azimuth_deg, azimuth) < angleApart(best.azimuth_deg, azimuth) ? r : best), rows[0]);
  section.append(make("h3", {}, "Plumbness"), make("p", { class: "quiet" },
    `How far the shell\u2019s top stands outside of its foot; the most is ${millimetres(shell.plumbness_max)} at ${degrees(shell.plumbness_azimuth_deg, 1)}.`));
  addChart(section, {
    id: "plumbness-chart", label: "Plumbness of the shell against azimuth", ratio: 0.3, least: 250, most: 360,
    legend: [{ name: "offset", label: "offset of the top, \u00b1 2\u03c3 band", colour: "shell" }],
    draw: (svg, width, height) => {
      const axes = azimuthAxes(svg, width, height, room([0, ...rows.flatMap((r) => (known(r.mm) ? [r.mm - (r.half || 0), r.mm + (r.half || 0)] : []))]), "Offset outwards [mm]");
      drawLevel(svg, axes, 0, "zero");
      drawBand(svg, axes, rows, (r) => r.mm, (r) => r.half);
      drawLine(svg, axes, rows, (r) => r.mm, "shell-line");
      followPointer(svg, azimuthUnder(axes), (azimuth) => {
        const r = nearest(azimuth);
        return [["Azimuth", degrees(r.azimuth_deg, 1)], ["Offset", `${withUnit(r.mm, 1, "mm")} over ${metres(r.height, 2)}`]];
      });
      return azimuthMarks(svg, axes, height, (azimuth) => nearest(azimuth).mm);
    },
  });
}

/** The smaller angle between two azimuths [deg]. */
function angleApart(a, b) {
  const apart = Math.abs(a - b) % 360;
  return Math.min(apart, 360 - apart);
}
