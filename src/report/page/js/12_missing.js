// What a result lacks, and why.

const kReasons = {
  no_shell: "the shell is not seen there",
  hidden: "the foundation is not seen there, or by too few points",
  other_surface: "what is seen there is not the surface of the neighbours, or stands before the foot",
  off_circle: "what stands there is not the shell",
};

/** The reason that most of the stations from one to another have. */
function reasonOf(first, last) {
  const counts = {};
  for (let i = first; i <= last; i += 1) counts[stations[i].reason] = (counts[stations[i].reason] || 0) + 1;
  const [most] = Object.entries(counts).sort((a, b) => b[1] - a[1]);
  return kReasons[most[0]] || "the datum was not seen there";
}

/** Stretches that were not seen, in degrees, by reason. */
function missingRanges() {
  const half = stepOfAzimuth() / 2, ranges = new Map();
  for (const [first, last] of missingStretches()) {
    const range = `${degrees(stations[first].azimuth_deg - half, 1)} to ${degrees(stations[last].azimuth_deg + half, 1)}`;
    const reason = reasonOf(first, last);
    ranges.set(reason, [...(ranges.get(reason) || []), range]);
  }
  return [...ranges].map(([reason, found]) => `Elevations at azimuths ${found.join(", ")}: ${reason}.`);
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

/** What checks ask for and was not given, each option once. */
function missingInputs() {
  const notes = [...checksWith("not_evaluated"), ...checksWith("not_applicable")].map((check) => check.note || "");
  const named = notes.flatMap((note) => [...note.matchAll(/([^,;:(]+)\((option [a-z_]+)[^)]*\)/g)]);
  const asked = new Map(named.map(([, name, option]) => [option, name.replace(/ is not given $/, " ").trim()]));
  if (asked.size === 0) return [];
  return [`Not given, though some checks need it: ${[...asked].map(([option, name]) => `${name} (${option})`).join(", ")}.`];
}

function missingItems() {
  if (!usable) return [`Everything below: ${datum.message || words(datum.status)}.`];
  const list = missingRanges();
  if (sections === null) list.push(whyNoSections());
  if (!stations.some((s) => known(s.u_fit))) list.push(whyNoFit());
  if (!datum.shell) list.push(whyNoShell());
  else if (!hasRoundness()) list.push(kNoRoundness);
  if (datum.shell && !hasPlumbness()) list.push(kNoPlumbness);
  return [...list, ...missingInputs()];
}
