// The words of the page, from one file a language; what a language lacks is said in English.

const kLanguages = embeddedJson("words");
const kSpoken = kLanguages[(datum || trend || index || {}).language] || kLanguages.en;

/** The words of a key, `{name}` in them replaced by what is given; the plural where `count` is not 1 and there is one. */
function say(key, values = {}) {
  const keys = values.count === undefined || values.count === 1 ? [key] : [`${key}.many`, key];
  const found = keys.map((k) => kSpoken[k] ?? kLanguages.en[k]).find((text) => text !== undefined);
  return found.replace(/\{(\w+)\}/g, (_, name) => values[name] ?? `{${name}}`);
}

/** The name of a check in the page's language; a name that is not of the standard limits stays as it is. */
function checkName(name) {
  const key = `check_name.${name.toLowerCase().replace(/[^a-z0-9]+/g, "_").replace(/^_|_$/g, "")}`;
  return kSpoken[key] ?? kLanguages.en[key] ?? name;
}

/** [template, key] of the sentences of datum.json that other languages have words for; those with more words of their own first. */
const kTemplates = Object.entries(kLanguages.en).filter(([key]) => key.startsWith("said."))
  .map(([key, text]) => [new RegExp(`^${text.replace(/[.*+?^$()|[\]\\]/g, "\\$&").replace(/\{(\w+)\}/g, "(?<$1>[^;]+)")}$`, "i"), key])
  .sort(([, a], [, b]) => kLanguages.en[b].length - kLanguages.en[a].length);

/** A sentence of datum.json, which is English, in the page's language; in clauses where it is known by those alone, else as it is. */
function translated(text) {
  if (kSpoken === kLanguages.en || !text) return text;
  const found = kTemplates.find(([template]) => template.test(text));
  if (found) {
    const { groups } = found[0].exec(text), inside = {};
    for (const [name, value] of Object.entries(groups || {})) inside[name] = translated(value);
    return say(found[1], inside);
  }
  for (const joint of ["; ", ", "]) if (text.includes(joint)) return text.split(joint).map(translated).join(joint);
  return text;
}
