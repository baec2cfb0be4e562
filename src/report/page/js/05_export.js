// A chart as a file of its own: its styles, which come from the page, are written into its elements.

const kExported = ["fill", "fill-opacity", "stroke", "stroke-width", "stroke-dasharray", "stroke-linejoin", "opacity",
  "font-family", "font-size", "font-weight", "text-anchor"];

function standaloneSvg(svg) {
  const copy = svg.cloneNode(true);
  const from = svg.querySelectorAll("*"), to = copy.querySelectorAll("*");
  from.forEach((element, i) => {
    const style = getComputedStyle(element);
    for (const name of kExported) to[i].style.setProperty(name, style.getPropertyValue(name));
  });
  copy.querySelector(".background").style.setProperty("fill", getComputedStyle(document.body).backgroundColor);
  copy.removeAttribute("tabindex");
  return new XMLSerializer().serializeToString(copy);
}

/** Calls done(blob) with the chart as a PNG of twice its size on the screen. */
function pictureOf(svg, done) {
  const { width, height } = svg.viewBox.baseVal;
  const picture = new Image();
  picture.onload = () => {
    const canvas = make("canvas", { width: 2 * width, height: 2 * height });
    canvas.getContext("2d").drawImage(picture, 0, 0, 2 * width, 2 * height);
    canvas.toBlob(done, "image/png");
  };
  picture.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(standaloneSvg(svg))}`;
}

function downloadButtons(chart) {
  const svg = () => chart.canvas.querySelector("svg");
  const png = make("button", { type: "button", "aria-label": `${chart.id} as PNG` }, "PNG");
  png.addEventListener("click", () => pictureOf(svg(), (blob) => save(`${chart.id}.png`, blob)));
  const vector = saveButton("SVG", `${chart.id}.svg`, () => standaloneSvg(svg()), "image/svg+xml");
  vector.setAttribute("aria-label", `${chart.id} as SVG`);
  return make("span", { class: "controls" }, png, vector);
}
