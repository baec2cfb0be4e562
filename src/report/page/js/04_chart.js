// A chart: a figure whose drawing is made anew for the width it has, with a legend and its own downloads.

const charts = [];
const kPaperHeight = 227;  // 60 mm [px]

/**
 * @param section  where it stands
 * @param id       its name, of the files too
 * @param label    what a listener is told
 * @param ratio    height by width, a figure or a function of the width, between `least` and `most` pixels
 * @param legend   [{name, label, colour, on}]; `on` undefined: always drawn
 * @param remark   words below the drawing, beside its legend
 * @param onPaper  its height on paper [px]; 0: as all others have
 * @param draw     draw(svg, width, height, shown) -> mark(chosen, hovered) or nothing
 */
function addChart(section, { id, label, ratio = 0.36, least = 260, most = 2000, legend = [], remark = "", onPaper = 0, draw }) {
  const canvas = make("div", { class: "canvas", id });
  const caption = make("figcaption");
  section.append(make("figure", {}, canvas, make("p", { class: "picked screen-only" }), caption));
  const chart = { id, canvas, draw, label, ratio, least, most, onPaper, shown: {}, mark: null };
  const list = make("div", { class: "legend" });
  for (const entry of legend) list.append(legendEntry(chart, entry));
  if (remark) list.append(make("span", { class: "remark" }, remark));
  caption.append(list, downloadButtons(chart));
  charts.push(chart);
  return chart;
}

function legendEntry(chart, { name, label, colour, on }) {
  const swatch = make("i");
  swatch.style.borderColor = colour.startsWith("rgb") || colour.startsWith("#") ? colour : `var(--${colour})`;
  chart.shown[name] = on !== false;
  if (on === undefined) return make("label", {}, swatch, label);
  const box = make("input", { type: "checkbox", checked: on });
  box.addEventListener("change", () => {
    chart.shown[name] = box.checked;
    drawChart(chart);
  });
  return make("label", {}, box, swatch, label);
}

function drawChart(chart, width = Math.floor(chart.canvas.clientWidth)) {
  if (width <= 0) return;
  link.marks = link.marks.filter((mark) => mark !== chart.mark);
  chart.width = width;
  const ratio = typeof chart.ratio === "function" ? chart.ratio(width) : chart.ratio;
  const paper = width === chart.paper;
  const height = Math.round(paper && chart.onPaper ? chart.onPaper : Math.min(paper ? kPaperHeight : chart.most, Math.max(paper ? chart.leastOnPaper : chart.least, ratio * width)));
  chart.canvas.replaceChildren();
  const svg = d3.select(chart.canvas).append("svg").attr("xmlns", "http://www.w3.org/2000/svg")
    .attr("width", width).attr("height", height).attr("viewBox", `0 0 ${width} ${height}`)
    .attr("role", "img").attr("aria-label", chart.label).attr("tabindex", 0);
  svg.append("rect").attr("class", "background").attr("width", width).attr("height", height);
  chart.mark = chart.draw(svg, width, height, chart.shown) || null;
  if (svg.select("a").size() > 0) svg.attr("role", "group").attr("tabindex", null);  // its links are reached, not itself
  svg.node().addEventListener("keydown", stepByKeys);
  if (chart.mark === null) return;
  link.marks.push(chart.mark);
  chart.mark(link.chosen, link.hovered);
}

function stepByKeys(event) {
  const step = stepOfAzimuth() * (event.shiftKey ? 10 : 1);
  const turns = { ArrowRight: step, ArrowUp: step, ArrowLeft: -step, ArrowDown: -step, Home: -link.chosen };
  if (!(event.key in turns) || event.ctrlKey || event.altKey || event.metaKey) return;
  event.preventDefault();
  link.choose(link.chosen + turns[event.key]);
}

/** Draws all charts whose place has another width than they were drawn for; `width` that of a sheet of paper. */
function drawCharts(width) {
  for (const chart of charts) {
    const paired = chart.canvas.closest(".paper-pair > :not(:only-child)") !== null;
    const place = paired || chart.canvas.closest(".pair") ? width / 2 - 10 : width;
    chart.leastOnPaper = paired ? kPaperHeight : 0;
    const wanted = width ? place : Math.floor(chart.canvas.clientWidth);
    chart.paper = width ? place : null;
    if (wanted !== chart.width) drawChart(chart, wanted);
  }
}

/** Calls follow(x, y, event) for a pointer over a chart, and what a click chooses. */
function followPointer(svg, azimuthAt, lines) {
  const node = svg.node();
  const at = (event) => {
    const box = node.getBoundingClientRect();
    const scale = node.viewBox.baseVal.width / box.width;
    return azimuthAt((event.clientX - box.left) * scale, (event.clientY - box.top) * scale);
  };
  node.addEventListener("pointermove", (event) => {
    const azimuth = at(event);
    link.hover(azimuth);
    if (azimuth === null) tip.hide();
    else tip.show(event, lines(azimuth));
  });
  node.addEventListener("pointerleave", () => {
    link.hover(null);
    tip.hide();
  });
  node.addEventListener("click", (event) => {
    const azimuth = at(event);
    if (azimuth === null) return;
    link.choose(azimuth);
    node.closest("figure").querySelector(".picked").replaceChildren(...lines(azimuth).map(([name, value]) => make("span", {}, `${name} ${value}`)));
  });
}
