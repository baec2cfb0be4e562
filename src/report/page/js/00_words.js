// The words of the page, from one file a language; what a language lacks is said in English.

const kLanguages = embeddedJson("words");
const kSpoken = kLanguages[(datum || trend || index || {}).language] || kLanguages.en;

/** The words of a key, `{name}` in them replaced by what is given; the plural where `count` is not 1 and there is one. */
function say(key, values = {}) {
  const keys = values.count === undefined || values.count === 1 ? [key] : [`${key}.many`, key];
  const found = keys.map((k) => kSpoken[k] ?? kLanguages.en[k]).find((text) => text !== undefined);
  return found.replace(/\{(\w+)\}/g, (_, name) => values[name] ?? `{${name}}`);
}
