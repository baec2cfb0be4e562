// Elements with text, and figures with units. Text only ever becomes text nodes.

/** An element; children that are not elements become text. */
function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === false || value === null || value === undefined) continue;
    element.setAttribute(name, value === true ? "" : value);
  }
  for (const child of children.flat()) {
    if (child === null || child === undefined) continue;
    element.append(child);
  }
  return element;
}

const kUnknown = say("word.unknown");
const minus = (text) => text.replaceAll("-", "\u2212");
const rounded = (value, digits) => value.toFixed(digits).replace(/^-(?=[0.]*$)/, "");  // no negative zero
const figure = (value, digits) => (known(value) ? minus(rounded(value, digits)) : kUnknown);
const withUnit = (value, digits, unit) => (known(value) ? `${figure(value, digits)}${unit === "\u2033" ? "" : "\u00a0"}${unit}` : kUnknown);
const degrees = (value, digits = 0) => (known(value) ? `${figure(value, digits)}\u00b0` : kUnknown);

/** An azimuth in whole degrees, 0 to 359. */
const roundAzimuth = (azimuth) => (known(azimuth) ? degrees(Math.round(azimuth) % 360) : kUnknown);

/** Figures of any size: as many digits as four significant ones take, small ones with an exponent. */
function anyFigure(value) {
  if (!known(value)) return "\u2013";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size < 1e-3 || size >= 1e6) return minus(value.toExponential(2));
  return minus(String(Number(value.toPrecision(4))));
}

/** The smaller angle between two azimuths [deg]. */
function angleApart(a, b) {
  const apart = Math.abs(a - b) % 360;
  return Math.min(apart, 360 - apart);
}

/** Of rows with `azimuth_deg`, the one nearest to an azimuth; null of none. */
function nearestRow(rows, azimuth) {
  return rows.reduce((best, r) => (best === null || angleApart(r.azimuth_deg, azimuth) < angleApart(best.azimuth_deg, azimuth) ? r : best), null);
}

/** Plain words of a result as a reader expects them: signs, and options of the command in one piece. */
function typeset(text) {
  const signs = text.replaceAll("+-", "\u00b1").replaceAll("2 sigma", "2\u03c3").replaceAll(">=", "\u2265").replaceAll("^2", "\u00b2");
  return signs.split(/(--[a-z][a-z-]*)/).map((part, i) => (i % 2 === 1 ? make("code", { class: "option" }, part) : part));
}

const capital = (text) => text.charAt(0).toUpperCase() + text.slice(1);
const sentence = (text) => `${capital(text)}${/[.?]$/.test(text) ? "" : "."}`;
const words = (name) => kSpoken[`word.${name}`] ?? name.replaceAll("_", " ");

/** Figures in boxes: [name, value, further words]. */
function boxes(list, kind = "facts") {
  return make("dl", { class: kind }, list.map(([name, value, more]) => (
    make("div", {}, make("dt", {}, name), make("dd", {}, value, more ? make("small", {}, more) : null)))));
}

/** A table; columns are [heading, kind] with kind "number" or "". */
function table(columns, rows, caption) {
  const head = columns.map(([name, kind]) => make("th", { scope: "col", class: kind || false }, name));
  const body = rows.map((row) => make("tr", {}, row.map((cell, i) => (
    cell instanceof HTMLTableCellElement ? cell
      : make("td", { class: columns[i][1] || false, "data-head": columns[i][0] }, make("span", {}, cell))))));
  return make("div", { class: "scroll" }, make("table", { class: "stacked" },
    caption ? make("caption", {}, caption) : null,
    make("thead", {}, make("tr", {}, head)), make("tbody", {}, body)));
}
