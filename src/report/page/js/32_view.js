// The picture of the viewer, where the report was given one.

function addView() {
  const picture = embeddedJson("view");
  if (picture === null) return;
  const section = addSection("view", say("view.heading"));
  section.append(make("figure", {}, make("img", { class: "view", src: picture, alt: say("view.label") }), make("figcaption", {}, say("view.how"))));
}
