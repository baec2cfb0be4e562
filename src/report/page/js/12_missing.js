// What a result lacks, and why.

/** Stretches that were not seen, in degrees. */
function missingRanges() {
  const half = stepOfAzimuth() / 2;
  return missingStretches().map(([first, last]) => (
    `${degrees(stations[first].azimuth_deg - half, 1)} to ${degrees(stations[last].azimuth_deg + half, 1)}`));
}

function whyNoSections() {
  if (levelled) return "Sections across the shell: none, because the elevations were typed in and not scanned.";
  const why = datum.options.method === "paper" ? "the paper\u2019s method fits a curve and no surfaces" : "this page was written without them";
  return `Sections across the shell: none, because ${why}.`;
}

function whyNoShell() {
  const why = levelled ? "a levelling survey holds elevations only" : "the scan shows too little of the shell above the datum";
  return `Roundness, plumbness and the map of the shell: none, because ${why}.`;
}

const kNoRoundness = "Roundness and the map of the shell: none, because the shell is not seen round enough of the tank at any height.";
const kNoPlumbness = "Plumbness: none, because the shell is seen at one height only.";
const hasRoundness = () => shellPoints.some((p) => known(p.deviation));
const hasPlumbness = () => (datum.shell.plumbness || []).length > 0;

function whyNoFit() {
  const found = datum.out_of_plane;
  return found && found.message ? `Harmonic fit and curvature: none, because ${found.message}.` : whyAbsent("Harmonic fit and curvature");
}

/** The shell's inputs that checks ask for, once each. */
function missingInputs() {
  const notes = [...checksWith("not_evaluated"), ...checksWith("not_applicable")].map((check) => check.note || "").filter((note) => note.includes("(option "));
  return [...new Set(notes)].map((note) => `For some checks: ${note}.`);
}

function missingItems() {
  if (!usable) return [`Everything below: ${datum.message || words(datum.status)}.`];
  const gaps = missingRanges(), list = [];
  if (gaps.length > 0) list.push(`Elevations at azimuths ${gaps.join(", ")}: the datum was not seen there, or something stands before it.`);
  if (sections === null) list.push(whyNoSections());
  if (!stations.some((s) => known(s.u_fit))) list.push(whyNoFit());
  if (!datum.shell) list.push(whyNoShell());
  else if (!hasRoundness()) list.push(kNoRoundness);
  if (datum.shell && !hasPlumbness()) list.push(kNoPlumbness);
  return [...list, ...missingInputs()];
}
