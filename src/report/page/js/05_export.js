// A chart as a file of its own: its styles, which come from the page, are written into its elements.

const kExported = ["fill", "fill-opacity", "stroke", "stroke-width", "stroke-dasharray", "stroke-linejoin", "opacity",
  "font-family", "font-size", "font-weight", "text-anchor"];

const kFileHead = 46, kLegendRow = 20;  // px: above the chart, and for a line of its legend

/** The chart's drawing with its styles in it, in the colours of paper. */
function styledCopy(chart) {
  document.documentElement.classList.add("light");
  const svg = chart.canvas.querySelector("svg"), copy = svg.cloneNode(true);
  const from = svg.querySelectorAll("*"), to = copy.querySelectorAll("*");
  from.forEach((element, i) => {
    const style = getComputedStyle(element);
    for (const name of kExported) to[i].style.setProperty(name, style.getPropertyValue(name));
  });
  document.documentElement.classList.remove("light");
  copy.removeAttribute("tabindex");
  return copy;
}

/** The entries of the legend that are shown, set in lines. */
function legendLines(chart, width) {
  const lines = [[]];
  let at = 12;
  for (const label of chart.canvas.parentElement.querySelectorAll(".legend label, .legend .remark")) {
    const box = label.querySelector("input"), text = label.textContent, wide = 40 + 6.6 * text.length;
    if (box !== null && !box.checked) continue;
    if (at + wide > width && lines[lines.length - 1].length > 0) {
      lines.push([]);
      at = 12;
    }
    lines[lines.length - 1].push({ at, text, colour: box === null && !label.querySelector("i") ? "none" : getComputedStyle(label.querySelector("i")).borderTopColor });
    at += wide;
  }
  return lines.filter((line) => line.length > 0);
}

/** What a chart is of: the tank, its site, the survey's date, the scan. */
function sourceLine() {
  const said = [about.tank && say("export.tank", { tank: about.tank }), about.site, about.survey_date].filter(Boolean);
  const files = trend ? trend.surveys.map((s) => dated(s.path, s.date)) : (datum ? datum.input.files : index.files).map((file) => file.path);
  return [...said, files.join(", ")].join("; ");
}

/** The chart as a file that stands alone: title, source, drawing, legend. */
function standaloneSvg(chart) {
  document.documentElement.classList.add("light");
  const { width } = chart.canvas.querySelector("svg").viewBox.baseVal, lines = legendLines(chart, width);
  document.documentElement.classList.remove("light");
  const copy = styledCopy(chart), height = copy.viewBox.baseVal.height;
  const tall = kFileHead + height + kLegendRow * lines.length + 8;
  const svg = d3.create("svg:svg").attr("xmlns", "http://www.w3.org/2000/svg").attr("width", width).attr("height", tall).attr("viewBox", `0 0 ${width} ${tall}`);
  svg.append("rect").attr("width", width).attr("height", tall).attr("fill", "#ffffff");
  const write = (x, y, size, fill, text) => svg.append("text").attr("x", x).attr("y", y).attr("font-family", "DejaVu Sans, sans-serif").attr("font-size", size).attr("fill", fill).text(text);
  write(12, 19, 14, "#000000", chart.label);
  write(12, 37, 11, "#444c56", sourceLine());
  copy.setAttribute("y", kFileHead);
  copy.querySelector(".background").style.setProperty("fill", "#ffffff");
  svg.node().append(copy);
  lines.forEach((line, row) => line.forEach(({ at, text, colour }) => {
    const y = kFileHead + height + kLegendRow * (row + 0.7);
    svg.append("line").attr("x1", at).attr("x2", at + 22).attr("y1", y - 4).attr("y2", y - 4).attr("stroke", colour).attr("stroke-width", 3);
    write(at + 28, y, 11, "#000000", text);
  }));
  return new XMLSerializer().serializeToString(svg.node());
}

/** A chart's file: by the tank's name, or the first scan's. */
function chartFile(chart, kind) {
  const path = trend ? trend.surveys[0].path : (datum ? datum.input.files : index.files)[0].path;
  const name = about.tank || path.split("/").pop().replace(/\.[^.]*$/, "");
  return `${name.replace(/[^\p{L}\p{N}.-]+/gu, "_")}_${chart.id}.${kind}`;
}

/** Calls done(blob) with the chart as a PNG of twice its size on the screen. */
function pictureOf(chart, done) {
  const drawing = standaloneSvg(chart), root = new DOMParser().parseFromString(drawing, "image/svg+xml").documentElement;
  const width = Number(root.getAttribute("width")), height = Number(root.getAttribute("height"));
  const picture = new Image();
  picture.onload = () => {
    const canvas = make("canvas", { width: 2 * width, height: 2 * height });
    canvas.getContext("2d").drawImage(picture, 0, 0, 2 * width, 2 * height);
    canvas.toBlob(done, "image/png");
  };
  picture.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(drawing)}`;
}

function downloadButtons(chart) {
  const png = make("button", { type: "button", "aria-label": say("export.as_png", { id: chart.id }) }, "PNG");
  png.addEventListener("click", () => pictureOf(chart, (blob) => save(chartFile(chart, "png"), blob)));
  const vector = saveButton("SVG", chartFile(chart, "svg"), () => standaloneSvg(chart), "image/svg+xml");
  vector.setAttribute("aria-label", say("export.as_svg", { id: chart.id }));
  return make("span", { class: "controls" }, png, vector);
}
