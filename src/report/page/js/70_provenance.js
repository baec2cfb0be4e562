// Where the result comes from: enough to run it again, and the data to take along.

/** What a file is known by; of results of earlier versions its SHA-256. */
function hashOf(file) {
  const hash = file.hash || (file.sha256 && { algorithm: "sha256", value: file.sha256 });
  if (!hash) return "not taken";
  const name = { xxh3_128: "XXH3-128", sha256: "SHA-256" }[hash.algorithm];
  return make("span", {}, `${name} `, make("code", { class: "breakable" }, hash.value));
}

function addProvenance() {
  const section = addSection("provenance", "How it was made");
  section.append(table([[levelled ? "Table" : "Scan"], [levelled ? "Stations" : "Points", "number"], ["Hash"]],
    datum.input.files.map((file) => [file.path, file.points.toLocaleString("en"), make("td", { "data-head": "Hash" }, hashOf(file))])));
  section.append(make("p", {}, levelled ? `tank_datum ${datum.version}, units of the table ${datum.input.units}.`
    : `tank_datum ${datum.version}, units of the scan ${datum.input.units}, ${datum.input.invalid_points || 0} invalid points left out, `
    + `local origin ${datum.input.origin.map((c) => figure(c, 3)).join(", ")} m.`));
  section.append(make("h3", {}, "Options"), make("pre", { tabindex: 0, "aria-label": "Every option used" }, JSON.stringify(datum.options, null, 2)));
  section.append(make("div", { class: "controls" }, make("strong", {}, "Data to take along"),
    saveButton("datum.json", "datum.json", () => embeddedText("datum"), "application/json"),
    saveButton("stations.csv", "stations.csv", () => embeddedText("stations"), "text/csv"),
    shellPoints.length > 0 ? saveButton("shell.csv", "shell.csv", () => embeddedText("shell"), "text/csv") : ""));
}
