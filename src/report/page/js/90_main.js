// Puts the page together and keeps its charts the width of their places.

const kPaperWidth = 680;  // of A4 between its margins [px]

function addHeading() {
  const title = index ? "Storage tanks of a scan" : trend ? "Movement of a storage tank\u2019s datum" : "Datum of a storage tank";
  document.getElementById("title").textContent = title;
  const names = trend ? trend.surveys.map((s) => dated(s.path, s.date)) : (index ? index.files : datum.input.files).map((file) => file.path);
  document.title = `${title}: ${names.join(", ")}`;
  document.getElementById("scans").textContent = names.join(", ");
}

function addFooter() {
  const licences = make("details", {}, make("summary", {}, "Licences"), make("pre", {}, document.getElementById("licences").content.textContent));
  document.getElementById("footer").append(make("p", {}, `Written by ${trend ? `tank_datum_compare ${trend.version}` : `tank_datum ${(index || datum).version}`}. Figures are in the frame of the scan; azimuths in degrees.`), licences);
}

window.addEventListener("hashchange", () => {
  if (window.location.hash.startsWith("#station=") && datum) link.choose(firstAzimuth());
});

addHeading();
if (index) {
  addIndex();
} else if (trend) {
  addTrend();
} else {
  addSummary();
  addElevation();
  addOutOfPlane();
  addPlan();
  addSetups();
  addStation();
  addShell();
  addMovement();
  addProvenance();
}
addFooter();
drawCharts();

let waiting = 0;
new ResizeObserver(() => {
  cancelAnimationFrame(waiting);
  waiting = requestAnimationFrame(() => drawCharts());
}).observe(document.getElementById("main"));
window.addEventListener("beforeprint", () => drawCharts(kPaperWidth));
window.addEventListener("afterprint", () => drawCharts());
