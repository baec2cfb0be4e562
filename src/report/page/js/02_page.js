// The page's frame: its sections and the table of contents.

/** A section with its heading, listed in the contents. */
function addSection(id, heading) {
  const title = make("h2", {}, heading);
  const section = make("section", { id, "aria-label": heading }, title);
  document.getElementById("main").append(section);
  document.getElementById("contents").append(make("a", { href: `#${id}` }, heading));
  return section;
}

/** Parts beside each other on paper, below each other on a screen; each is built by its function. */
function addPaperPair(section, ...builders) {
  const parts = builders.map((build) => {
    const part = make("div");
    build(part);
    return part;
  });
  section.append(make("div", { class: "paper-pair" }, parts.filter((part) => part.childElementCount > 0)));
}

/** One line that says what is missing and why. */
function sayAbsent(section, why) {
  if (section.childElementCount === 1) section.classList.add("absent-section");
  section.append(make("p", { class: "absent" }, typeset(why)));
}

/** Why there is no such section in a result. */
function whyAbsent(what) {
  if (!usable) return say("page.none_because_no_datum_was", { what, status: datum.message || words(datum.status) });
  return say("page.not_in_this_result_version", { what, version: datum.version });
}

/** A name that file systems hold, 255 bytes in UTF-8, with its ending. */
function fileNameOf(name) {
  const ending = name.slice(name.lastIndexOf("."));
  let stem = name.slice(0, name.length - ending.length);
  while (new TextEncoder().encode(stem + ending).length > 255) stem = [...stem].slice(0, -1).join("");
  return stem + ending;
}

function save(name, blob) {
  const link = make("a", { href: URL.createObjectURL(blob), download: fileNameOf(name) });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

function saveButton(label, name, content, type) {
  const button = make("button", { type: "button" }, label);
  button.addEventListener("click", () => save(name, new Blob([content()], { type })));
  return button;
}
