// Sorts, filters and searches the table of tanks; colours the map by a column of it.

const body = document.querySelector("#tanks tbody");
const rows = [...body.rows];
const heads = [...document.querySelectorAll("#tanks thead th")];
const search = document.getElementById("search");
const verdict = document.getElementById("verdict-filter");
const alarm = document.getElementById("alarm-filter");
const kYear = 365.25 * 24 * 3600 * 1000;
const kLevels = ["none", "watch", "alarm"];
const kMarks = { FAIL: "var(--fail)", UNDECIDED: "var(--undecided)", PASS: "var(--pass)", alarm: "var(--fail)", watch: "var(--undecided)" };
const kWords = ["alarm", "verdict", "governing"];

const cellOf = (row, key) => row.querySelector(`[data-key="${key}"]`);

/** What a row is sorted by: a number, a word, or null where it is unknown. */
function valueOf(row, key) {
  const text = cellOf(row, key).dataset.value;
  if (text === undefined || text === "") return null;
  if (key === "age") return Date.parse(text);
  return text !== "" && Number.isFinite(Number(text)) && key !== "tank" ? Number(text) : text;
}

function compareValues(a, b) {
  if (typeof a === "number" && typeof b === "number") return a - b;
  return String(a).localeCompare(String(b), "en", { numeric: true });
}

/** Unknown values stay last, whichever way. */
function sortBy(head) {
  const key = head.dataset.key, up = head.getAttribute("aria-sort") !== "ascending";
  for (const other of heads) other.setAttribute("aria-sort", "none");
  head.setAttribute("aria-sort", up ? "ascending" : "descending");
  const keyed = rows.map((row) => [valueOf(row, key), row]);
  keyed.sort(([a], [b]) => {
    if (a === null || b === null) return (a === null) - (b === null);
    return up ? compareValues(a, b) : compareValues(b, a);
  });
  body.append(...keyed.map(([, row]) => row));
}

function filterRows() {
  const wanted = search.value.trim().toLowerCase();
  let count = 0;
  for (const row of rows) {
    const fits = (verdict.value === "all" || cellOf(row, "verdict").dataset.value === verdict.value)
      && (alarm.value === "all" || kLevels[Number(cellOf(row, "alarm").dataset.value)] === alarm.value)
      && (wanted === "" || row.textContent.toLowerCase().includes(wanted));
    row.hidden = !fits;
    count += fits ? 1 : 0;
    const mark = marks.get(row.dataset.tank);
    if (mark) mark.querySelector("circle").classList.toggle("dim", !fits);
  }
  document.getElementById("shown").textContent = `${count} of ${rows.length} tanks`;
}

/** Survey dates with their age on the day that the page is looked at. */
function showAges() {
  for (const row of rows) {
    const cell = cellOf(row, "age"), date = Date.parse(cell.dataset.value || "");
    if (!Number.isFinite(date)) continue;
    const age = document.createElement("span");
    age.className = "under";
    const years = (Date.now() - date) / kYear;
    age.textContent = years < 0 ? "in the future" : `${years.toFixed(1)} years ago`;
    cell.append(age);
  }
}

const marks = new Map([...document.querySelectorAll("#map svg a")].map((a) => [a.dataset.tank, a]));

function legendEntry(colour, words) {
  const entry = document.createElement("span"), swatch = document.createElement("i");
  swatch.style.background = colour;
  entry.append(swatch, words);
  return entry;
}

function colourByWord(key) {
  const wordOf = (row) => (key === "alarm" ? kLevels[Number(cellOf(row, key).dataset.value)] : cellOf(row, key).dataset.value || "unknown");
  const words = [...new Set(rows.map(wordOf))].sort();
  const colourOf = (word) => kMarks[word] || (words.length > 3 ? `hsl(${(360 * words.indexOf(word)) / words.length} 55% 60%)` : "var(--panel)");
  for (const row of rows) paint(row, colourOf(wordOf(row)));
  return words.map((word) => legendEntry(colourOf(word), word));
}

/** Pale for the least, strong for the most; of change and rate the magnitude counts. */
function colourByNumber(key) {
  const magnitude = (row) => { const value = valueOf(row, key); return value === null ? null : Math.abs(value); };
  const known = rows.map(magnitude).filter((value) => value !== null);
  const low = Math.min(...known), high = Math.max(...known);
  const colourAt = (share) => `color-mix(in oklab, var(--accent) ${Math.round(100 * share)}%, var(--paper))`;
  for (const row of rows) {
    const value = magnitude(row);
    paint(row, value === null ? "transparent" : colourAt(high > low ? (value - low) / (high - low) : 0.5));
  }
  if (known.length === 0) return [legendEntry("transparent", "unknown")];
  const shown = (value) => {
    const row = rows.find((each) => magnitude(each) === value);
    return cellOf(row, key).firstChild.textContent.replace("\u2212", "");
  };
  return [legendEntry(colourAt(0), shown(low)), legendEntry(colourAt(1), shown(high))];
}

function paint(row, colour) {
  const mark = marks.get(row.dataset.tank);
  if (mark) mark.querySelector("circle").style.fill = colour;
}

function colourMap() {
  const key = document.getElementById("colour-by").value;
  document.getElementById("legend").replaceChildren(...(kWords.includes(key) ? colourByWord(key) : colourByNumber(key)));
}

for (const head of heads) head.querySelector("button").addEventListener("click", () => sortBy(head));
for (const control of [search, verdict, alarm]) control.addEventListener("input", filterRows);
showAges();
filterRows();
if (marks.size > 0) {
  document.getElementById("colour-by").addEventListener("input", colourMap);
  colourMap();
}
