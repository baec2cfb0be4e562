// Puts the page together and keeps its charts the width of their places.

const kPaperWidth = 680;  // of A4 between its margins [px]

function addHeading() {
  document.documentElement.lang = kLanguages[(datum || trend || index).language] ? (datum || trend || index).language : "en";
  const tank = about.tank ? say("main.datum_of_tank", { tank: about.tank }) : say("main.datum_of_a_storage_tank");
  const moved = about.tank ? say("main.movement_of_tank", { tank: about.tank }) : say("main.movement_of_a_storage_tanks");
  const title = index ? say("main.storage_tanks_of_a_scan") : trend ? moved : tank;
  document.getElementById("title").textContent = title;
  const names = trend ? trend.surveys.map((s) => dated(s.path, s.date)) : (index ? index.files : datum.input.files).map((file) => file.path);
  document.querySelector(".skip").textContent = say("page.skip");
  document.getElementById("contents").setAttribute("aria-label", say("page.sections"));
  document.title = `${title}: ${names.join(", ")}`;
  document.getElementById("scans").textContent = names.join(", ");
}

function addFooter() {
  const licences = make("details", {}, make("summary", {}, say("main.licences")), make("pre", {}, document.getElementById("licences").content.textContent));
  document.getElementById("footer").append(make("p", {}, say("main.written_by_figures_are_in", { trend: trend ? say("main.tank_datum_compare", { version: trend.version }) : say("main.tank_datum", { version: (index || datum).version }) })), licences);
}

window.addEventListener("hashchange", () => {
  const asked = askedOf(trend ? trend.trend.stations : stations);
  if (asked !== undefined) link.choose(asked);
});

addHeading();
addIdentity();
addSheetFoot();
if (index) {
  addIndex();
} else if (trend) {
  addTrend();
} else if (!usable) {
  addRefusal();
  addProvenance();
} else {
  addSummary();
  addElevation();
  addOutOfPlane();
  addPlan();
  addView();
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
