// What a result lacks, and why.

const kReasons = {
  no_shell: say("missing.the_shell_is_not_seen"),
  hidden: say("missing.the_foundation_is_not_seen"),
  other_surface: say("missing.what_is_seen_there_is"),
  off_circle: say("missing.what_stands_there_is_not"),
  shell_below: say("missing.the_shell_is_seen_below"),
};

/** The reason that most of the stations from one to another have. */
function reasonOf(first, last) {
  const counts = {};
  for (let i = first; i <= last; i += 1) {
    const { reason } = stations[i % stations.length];
    counts[reason] = (counts[reason] || 0) + 1;
  }
  const [most] = Object.entries(counts).sort((a, b) => b[1] - a[1]);
  return kReasons[most[0]] || say("missing.the_datum_was_not_seen");
}

/** Stretches that were not seen, one across azimuth 0 as one: its last station counts from before. */
function missingArcs() {
  const runs = missingStretches(), [first, last] = [runs[0], runs[runs.length - 1]];
  if (runs.length < 2 || first[0] !== 0 || last[1] !== stations.length - 1) return runs;
  return [...runs.slice(1, -1), [last[0], first[1] + stations.length]];
}

/** They, in degrees, by reason. */
function missingRanges() {
  const half = stepOfAzimuth() / 2, ranges = new Map();
  for (const [first, last] of missingArcs()) {
    const range = say("missing.to", { half: degrees((stations[first].azimuth_deg - half + 360) % 360, 1), half_2: degrees(stations[last % stations.length].azimuth_deg + half, 1) });
    const reason = reasonOf(first, last);
    ranges.set(reason, [...(ranges.get(reason) || []), range]);
  }
  return [...ranges].map(([reason, found]) => say("missing.elevations_at_azimuths", { found: found.join(", "), reason }));
}

function whyNoSections() {
  if (levelled) return say("missing.sections_across_the_shell_none");
  const why = datum.options.method === "paper" ? say("missing.the_papers_method_fits_a") : say("missing.this_page_was_written_without");
  return say("missing.sections_across_the_shell_none_2", { why });
}

function whyNoShell() {
  const why = levelled ? say("missing.a_levelling_survey_holds_elevations") : say("missing.the_scan_shows_too_little");
  return say("missing.roundness_plumbness_and_the_map", { why });
}

const kNoRoundness = say("missing.roundness_and_the_map_of");
const kNoPlumbness = say("missing.plumbness_none_because_the_shell");
const hasRoundness = () => shellPoints.some((p) => known(p.deviation));
const hasPlumbness = () => (datum.shell.plumbness || []).length > 0;

function whyNoFit() {
  const found = datum.out_of_plane;
  return found && found.message ? say("missing.harmonic_fit_and_curvature_none", { message: translated(found.message) }) : whyAbsent(say("missing.harmonic_fit_and_curvature"));
}

/** What checks ask for and was not given, each option once. */
function missingInputs() {
  const notes = [...checksWith("not_evaluated"), ...checksWith("not_applicable")].map((check) => check.note || "");
  const named = notes.flatMap((note) => [...note.matchAll(/([^,;:(]+)\((option [a-z_]+)[^)]*\)/g)]);
  const asked = new Map(named.map(([, name, option]) => [option, name.replace(/ is not given $/, " ").trim()]));
  if (asked.size === 0) return [];
  return [say("missing.not_given_though_some_checks", { name: [...asked].map(([option, name]) => translated(`${name} (${option})`)).join(", ") })];
}

function missingItems() {
  if (!usable) return [say("missing.everything_below", { status: translated(datum.message) || words(datum.status) })];
  const list = missingRanges();
  if (sections === null) list.push(whyNoSections());
  if (!stations.some((s) => known(s.u_fit))) list.push(whyNoFit());
  if (!datum.shell) list.push(whyNoShell());
  else if (!hasRoundness()) list.push(kNoRoundness);
  if (datum.shell && !hasPlumbness()) list.push(kNoPlumbness);
  return [...list, ...missingInputs()];
}
