// Lengths as readers want them: files hold metres, the page shows what --display-units asked for.

const kFoot = 0.3048;
/** [factor, unit, further digits] of short lengths, long ones, slopes and curvatures, for figures given in metres. */
const kDisplays = {
  mm: { short: [1e3, "mm", 0], long: [1, "m", 0], slope: [1e3, "mm/m", 0], bend: [1e6, "\u00d7 10\u207b\u2076 1/m", 0] },
  in: { short: [12 / kFoot, "in", 2], long: [1 / kFoot, "ft", 0], slope: [1200, "in/100 ft", 0], bend: [1e6 * kFoot, "\u00d7 10\u207b\u2076 1/ft", 0] },
  ft: { short: [1 / kFoot, "ft", 3], long: [1 / kFoot, "ft", 0], slope: [100, "ft/100 ft", 1], bend: [1e6 * kFoot, "\u00d7 10\u207b\u2076 1/ft", 0] },
};
const display = kDisplays[(datum || trend || index || {}).display_units || "mm"];
const kShortUnit = display.short[1], kLongUnit = display.long[1], kBendUnit = display.bend[1];

/** A figure in metres as one in the unit shown; null of an unknown one. */
const toShort = (metres) => (known(metres) ? display.short[0] * metres : null);
const toLong = (metres) => (known(metres) ? display.long[0] * metres : null);

/** A note, which holds metres, in the unit shown; not where it says feet beside them. */
function inShownUnits(text) {
  if (!text || kLongUnit === "m") return text;
  return text.replace(/(\d+(?:\.(\d+))?) (mm|m|\u043c\u043c|\u043c)(?![\p{L}\d/\u00b2^]| ?[(\uff08])/gu, (_, value, decimals, unit) => {
    const isLong = unit.length === 1, [factor, name, more] = isLong ? display.long : display.short, metres = Number(value) / (isLong ? 1 : 1000);
    return `${(factor * metres).toFixed((decimals || "").length + more)} ${name}`;
  });
}

const twice = (value) => (known(value) ? 2 * value : null);
const bend = (perMetre) => (known(perMetre) ? display.bend[0] * perMetre : null);

const shownAs = (value, [factor, unit, more], digits) => withUnit(known(value) ? factor * value : null, digits + more, unit);
const shortLength = (metres, digits = 1) => shownAs(metres, display.short, digits);
const longLength = (metres, digits = 3) => shownAs(metres, display.long, digits);
/** Without the unit, where a heading has it. */
const shortFigure = (metres, digits = 1) => figure(toShort(metres), digits + display.short[2]);
/** The same of a figure that is in the unit already. */
const inShort = (value, digits = 1) => withUnit(value, digits + display.short[2], kShortUnit);
const curvature = (perMetre) => shownAs(perMetre, display.bend, 1);
const plusMinus = (sigma, digits = 1) => (known(sigma) ? `\u00b1 ${shortLength(2 * sigma, digits)} (2\u03c3)` : "");
