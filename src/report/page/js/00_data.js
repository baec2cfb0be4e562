// What the page was written with; null where it was written without.

function embeddedText(id) {
  const element = document.getElementById(`data-${id}`);
  return element === null ? null : element.textContent;
}

function embeddedJson(id) {
  const text = embeddedText(id);
  return text === null ? null : JSON.parse(text);
}

const kWordColumns = ["flag", "reason"];

/** A table as one object per row: numbers, null for an empty cell; some columns hold words. */
function readTable(csv) {
  if (csv === null) return [];
  const [header, ...rows] = csv.trim().split("\n").map((line) => line.split(","));
  return rows.map((cells) => Object.fromEntries(header.map((name, i) => {
    if (kWordColumns.includes(name)) return [name, cells[i]];
    return [name, cells[i] === "" ? null : Number(cells[i])];
  })));
}

const datum = embeddedJson("datum");
const stations = readTable(embeddedText("stations"));
const sections = embeddedJson("sections");
const shellPoints = readTable(embeddedText("shell"));
const sighting = embeddedJson("sighting");
const trend = embeddedJson("trend");
const index = embeddedJson("index");

const known = (value) => value !== null && value !== undefined && Number.isFinite(value);
const usable = datum !== null && (datum.status === "ok" || datum.status === "partial");
const levelled = datum !== null && datum.input.kind === "levelling";
const hasSection = (key) => usable && datum[key] !== undefined && datum[key] !== null;

/** Direction of an azimuth, counter-clockwise from the frame's +x [deg]. */
function directionOf(azimuth) {
  const options = datum ? datum.options.stations : { zero_azimuth_deg: 0, clockwise: false };
  return options.zero_azimuth_deg + (options.clockwise ? -azimuth : azimuth);
}

/** The station nearest to an azimuth [deg], or -1. */
function stationAt(azimuth) {
  const away = (s) => Math.abs(((((s.azimuth_deg - azimuth) % 360) + 540) % 360) - 180);
  return stations.reduce((best, s, i) => (best < 0 || away(s) < away(stations[best]) ? i : best), -1);
}
