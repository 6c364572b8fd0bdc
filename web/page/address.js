// SPDX-License-Identifier: GPL-3.0-or-later
// Settings are stored in the address: it opens with the same sliders.  #step=3&... opens at a step; ?only=step3 shows
// only this step, as in the frame of another page.
"use strict";

const address = {
  values: new URLSearchParams(location.hash.slice(1)),
  only: new URLSearchParams(location.search).get("only") ?? "",
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
    this.write(`#${this.values}`);
  },
  write(hash) {
    try {
      history.replaceState(null, "", hash);
    } catch {
      // a frame without its own address
    }
  },
  /// The address of this page with the values whose key begins with `start`, and with more.
  link(more = {}, start = "") {
    const chosen = new URLSearchParams(more);
    for (const [key, value] of this.values) if (key.startsWith(start) && !(key in more) && key !== "step") chosen.set(key, value);
    return `${location.href.split("#")[0]}#${chosen}`;
  },
};
// Another address in the same tab is another setting; an anchor of this page is not.
addEventListener("hashchange", () => document.getElementById(location.hash.slice(1)) ?? location.reload());

/// A line of text with {names} replaced by values; a name without a value is part of a formula and unchanged.
const filled = (text, values) => text.replace(/\{(\w+)\}/g, (all, name) => values[name] ?? all);

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

/// A slider between its name and its value with the unit.
function slider({ id, name, min, max, step, value, unit, format = (number) => written(number), change }) {
  const withUnit = (number) => `${format(number)}${unit ? ` ${unit}` : ""}`;
  const shown = element("output", { for: id, "aria-live": "off" }, withUnit(value));
  const input = element("input", { type: "range", id, min, max, step, value, "aria-valuetext": withUnit(value), oninput: () => {
    const number = Number(input.value);
    shown.textContent = withUnit(number);
    input.setAttribute("aria-valuetext", withUnit(number));
    change(number);
  } });
  return element("div", { class: "control" }, element("label", { for: id }, ...worded(name)), shown, input);
}

/// A button that copies a text; if the page may not copy, the text is shown in a field.
function copyButton(words, textOf) {
  const button = element("button", { onclick: async () => {
    const text = textOf();
    try {
      await navigator.clipboard.writeText(text);
      button.textContent = words.copied;
    } catch {
      const field = element("input", { readonly: true, value: text, "aria-label": words.copy });
      button.after(field);
      field.select();
    }
  } }, words.copy);
  return button;
}
