// One azimuth is chosen and at most one hovered over; every chart marks both.

/** The azimuth of the station that the address asks for, if it does and there is one. */
function askedOf(listed) {
  const asked = /^#station=(\d+)$/.exec(window.location.hash);
  return asked ? listed[Number(asked[1])]?.azimuth_deg : undefined;
}

/** The azimuth to look at first: what the address asks for, where the governing check is worst, or the largest settlement. */
function firstAzimuth() {
  if (datum === null || stations.length === 0) return 0;
  const asked = askedOf(stations);
  if (asked !== undefined) return asked;
  const governing = datum.verdict && (datum.checks || []).find((c) => `${c.code} ${c.name}` === datum.verdict.governing);
  if (governing && governing.verdict !== "not_evaluated" && known(governing.azimuth_deg)) return governing.azimuth_deg;
  return extremeStation((s) => (known(s.u) ? Math.abs(s.u) : null)).azimuth_deg;
}

/** The measured station where a figure is largest; the first of all where there is none. */
function extremeStation(value) {
  const found = stations.filter((s) => s.flag === "measured" && known(value(s)));
  return found.reduce((most, s) => (value(s) > value(most) ? s : most), found[0] || stations[0]);
}

const link = {
  chosen: firstAzimuth(),
  hovered: null,
  marks: [],
  describe: describeStation,

  hover(azimuth) {
    this.hovered = azimuth;
    this.show();
  },

  choose(azimuth) {
    this.chosen = ((azimuth % 360) + 360) % 360;
    this.show();
    document.getElementById("spoken").textContent = this.describe(this.chosen).map(([name, value]) => `${name} ${value}`).join("; ");
    document.dispatchEvent(new CustomEvent("station"));
  },

  /** Redraws the marks of the charts that are drawn. */
  show() {
    for (const mark of this.marks) mark(this.chosen, this.hovered);
  },
};

/** One station further, for the arrow keys. */
function stepOfAzimuth() {
  return 360 / (stations.length || 360);
}

/** [name, value] of what is known at an azimuth, for tips, tables and listeners. */
function describeStation(azimuth) {
  const i = stationAt(azimuth);
  if (i < 0) return [[say("common.azimuth"), degrees(azimuth, 1)]];
  const s = stations[i];
  const lines = [[say("common.station"), say("link.at", { station: s.station, azimuth_deg: degrees(s.azimuth_deg, 1), flag: words(s.flag) })]];
  const point = nearestRow(surveyPoints, s.azimuth_deg);
  if (point !== null && angleApart(point.azimuth_deg, s.azimuth_deg) <= stepOfAzimuth() / 2) lines.push([say("link.survey_point"), String(point.number)]);
  if (!known(s.z)) return lines;
  lines.push([say("common.elevation"), `${longLength(s.z, 4)} ${plusMinus(s.sigma_z, 2)}`]);
  if (known(s.u)) lines.push([say("common.out_of_plane"), shortLength(s.u, 2)]);
  if (known(s.z_paper)) lines.push([say("link.papers_curve"), longLength(s.z_paper, 4)]);
  if (known(s.radius)) lines.push([say("common.radius"), longLength(s.radius, 4)]);
  if (known(s.n_foundation)) lines.push([say("common.points"), say("link.shell_foundation", { n_shell: s.n_shell, n_foundation: s.n_foundation })]);
  return lines;
}

const tip = {
  show(event, lines) {
    const box = document.getElementById("tip");
    box.replaceChildren(...lines.map(([name, value], i) => make(i === 0 ? "b" : "span", {}, `${name} ${value}`)));
    box.hidden = lines.length === 0;
    const { width, height } = box.getBoundingClientRect();
    const left = event.clientX + 16 + width > window.innerWidth ? event.clientX - 16 - width : event.clientX + 16;
    box.style.left = `${Math.max(4, left)}px`;
    box.style.top = `${Math.max(4, Math.min(event.clientY + 14, window.innerHeight - height - 4))}px`;
  },
  hide() {
    document.getElementById("tip").hidden = true;
  },
};
