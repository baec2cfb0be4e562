// Where the result comes from: enough to run it again, and the data to take along.

/** What a file is known by; of results of earlier versions its SHA-256. */
function hashOf(file) {
  const hash = file.hash || (file.sha256 && { algorithm: "sha256", value: file.sha256 });
  if (!hash) return say("provenance.not_taken");
  const name = { xxh3_128: "XXH3-128", sha256: "SHA-256" }[hash.algorithm];
  return make("span", {}, `${name} `, make("code", { class: "breakable" }, hash.value));
}

/** Every option, line by line on a screen and without breaks on paper. */
function optionsAppendix(options) {
  return [make("h3", {}, say("provenance.appendix_every_option_used")),
    make("pre", { class: "screen-only", tabindex: 0, "aria-label": say("provenance.every_option_used") }, JSON.stringify(options, null, 2)),
    make("p", { class: "paper-text" }, JSON.stringify(options).replace(/([,:])/g, "$1 "))];
}

function addProvenance() {
  const section = addSection("provenance", say("common.how_it_was_made"));
  section.append(table([[levelled ? say("provenance.levelling") : say("provenance.scan")], [levelled ? say("common.stations") : say("common.points"), "number"], [say("provenance.hash")]],
    datum.input.files.map((file) => [file.path, file.points.toLocaleString("en"), make("td", { "data-head": say("provenance.hash") }, hashOf(file))])));
  section.append(make("p", {}, levelled ? say("provenance.table", { version: datum.version, units: datum.input.units })
    : say("provenance.scan_read", { version: datum.version, units: datum.input.units, invalid: datum.input.invalid_points || 0,
      origin: datum.input.origin.map((c) => figure(toLong(c), 3)).join(", "), unit: kLongUnit })));
  section.append(...optionsAppendix(datum.options));
  section.append(make("div", { class: "controls" }, make("strong", {}, say("common.data_to_take_along")),
    saveButton("datum.json", "datum.json", () => embeddedText("datum"), "application/json"),
    saveButton("stations.csv", "stations.csv", () => embeddedText("stations"), "text/csv"),
    shellPoints.length > 0 ? saveButton("shell.csv", "shell.csv", () => embeddedText("shell"), "text/csv") : ""));
}
