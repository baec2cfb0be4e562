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
