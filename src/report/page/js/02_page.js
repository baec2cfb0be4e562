// The page's frame: its sections and the table of contents.

/** A section with its heading, listed in the contents. */
function addSection(id, heading) {
  const title = make("h2", {}, heading);
  const section = make("section", { id, "aria-label": heading }, title);
  document.getElementById("main").append(section);
  document.getElementById("contents").append(make("a", { href: `#${id}` }, heading));
  return section;
}

/** One line that says what is missing and why. */
function sayAbsent(section, why) {
  if (section.childElementCount === 1) section.classList.add("absent-section");
  section.append(make("p", { class: "absent" }, typeset(why)));
}

/** Why there is no such section in a result. */
function whyAbsent(what) {
  if (!usable) return `${what}: none, because no datum was found (${datum.message || words(datum.status)}).`;
  return `${what}: not in this result; version ${datum.version} did not compute it from this scan.`;
}

function save(name, blob) {
  const link = make("a", { href: URL.createObjectURL(blob), download: name });
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
