// SPDX-License-Identifier: GPL-3.0-or-later
// Settings live in the address: whoever opens it sees the same sliders.
"use strict";

const address = {
  values: new URLSearchParams(location.hash.slice(1)),
  number(key, otherwise, min, max) {
    const text = this.values.get(key);
    const value = Number(text);
    return text !== null && text !== "" && Number.isFinite(value) ? Math.min(max, Math.max(min, value)) : otherwise;
  },
  choice(key, otherwise, choices) {
    const value = this.values.get(key);
    return choices.includes(value) ? value : otherwise;
  },
  put(key, value) {
    this.values.set(key, value);
    history.replaceState(null, "", `#${this.values}`);
  },
};

/// A line of text with {names} filled in.
const filled = (text, values) => text.replace(/\{(\w+)\}/g, (_, name) => values[name]);

/// An element with attributes and children.
function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
    else if (value !== undefined && value !== false) made.setAttribute(name, value === true ? "" : value);
  }
  made.append(...children);
  return made;
}
