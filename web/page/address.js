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
    for (const act of this.heard) act();
  },
  /// What is done after each change of a setting.
  heard: [],
  /// An entry of the history of this page has a state: going back to it changes the place on the page, no setting.
  write(hash, anew = false) {
    try {
      history[anew ? "pushState" : "replaceState"]({ granum: true }, "", hash);
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
// Another address in the same tab is another setting; an anchor of this page is not, nor is a step back.
addEventListener("hashchange", () => {
  if (history.state?.granum) address.write(`#${address.values}`);
  else if (!goTo(location.hash.slice(1))) location.reload();
});

/// Brings a part of the page to the screen, and the keyboard into it; false if there is none of that name.
function goTo(name) {
  const part = name && document.getElementById(name);
  if (!part) return false;
  const heading = part.querySelector("h2, h3") ?? part;
  heading.setAttribute("tabindex", "-1");
  part.scrollIntoView();
  heading.focus({ preventScroll: true });
  return true;
}
/// A link to a part of this page: the settings in the address remain, and Back returns to where one was.
const partLink = (name, text, more = {}) => element("a", { href: `#${name}`, ...more, onclick: (event) => {
  event.preventDefault();
  address.write(location.href);
  address.write(location.href, true);
  goTo(name);
} }, text);

/// What this page keeps on the device, by name; nothing where the browser keeps nothing.
const kept = {
  read(name) {
    try {
      return JSON.parse(localStorage.getItem(`granum ${name}`)) ?? {};
    } catch {
      return {};
    }
  },
  write(name, value) {
    try {
      localStorage.setItem(`granum ${name}`, JSON.stringify(value));
    } catch {
      // a frame without a place of its own
    }
  },
  forget() {
    try {
      for (const name of Object.keys(localStorage)) if (name.startsWith("granum ")) localStorage.removeItem(name);
    } catch {
      // as above
    }
  },
};

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

/// A worker that answers as worker.js says.
const newWorker = () => new Worker(URL.createObjectURL(new Blob([document.getElementById("worker-source").textContent], { type: "text/javascript" })));

/// Numbers as people write them, with a decimal point or comma; NaN for none, undefined for what is no number or could be two: 1,000.
function typedNumber(text) {
  const given = text.trim().replace("−", "-");
  if (given === "") return NaN;
  const group = decimalSign === "," ? "." : ",";
  if (given.includes(group) && /^[+-]?[1-9]\d{0,2}[.,]\d{3}$/.test(given)) return undefined;
  return /^[+-]?(\d+([.,]\d*)?|[.,]\d+)(e[+-]?\d+)?$/i.test(given) ? Number(given.replace(",", ".")) : undefined;
}
/// As they are shown in a field.
const shownNumber = (number) => (Number.isNaN(number) ? "" : localised(String(number)));
/// A field for a number: browsers differ in the decimal signs that their own fields take. Its `typed` is as typedNumber.
function numberField({ id, value, change, ...more }) {
  const field = element("input", { type: "text", inputmode: "decimal", autocomplete: "off", id, value: shownNumber(value), ...more, oninput: () => change?.(field.typed) });
  Object.defineProperty(field, "typed", { get: () => typedNumber(field.value) });
  return field;
}

/// A short word for screen readers, when a slider has come to rest.
let saying;
function say(text) {
  clearTimeout(saying);
  saying = setTimeout(() => { document.getElementById("said").textContent = text; }, 900);
}

// A finger that goes on to scroll the page leaves the slider as it was.
const touched = new WeakMap();
addEventListener("pointerdown", ({ target, pointerType }) => {
  if (pointerType === "touch" && target.type === "range") touched.set(target, target.value);
}, true);
addEventListener("pointercancel", ({ target }) => {
  if (!touched.has(target)) return;
  target.value = touched.get(target);
  touched.delete(target);
  target.dispatchEvent(new Event("input", { bubbles: true }));
}, true);

/// A slider between its name and its value with the unit. A logarithmic one goes from min to max as a linear one does; the value
/// at its middle is their geometric mean.
function slider({ id, name, min, max, step, value, unit, log, format = (number) => written(number), change }) {
  const withUnit = (number) => `${format(number)}${unit ? ` ${unit}` : ""}`;
  const valueAt = (place) => {
    if (!log) return place;
    const at = (to) => min * (max / min) ** ((to - min) / (max - min));
    const exact = at(place), near = Math.sqrt(at(place + step) / exact);
    for (const round of [1, 2, 5]) {
      const whole = round * 10 ** Math.round(Math.log10(exact / round));
      if (whole / exact < near && exact / whole < near) return whole;
    }
    return Number(exact.toPrecision(3));
  };
  const placeOf = (number) => (log ? min + ((max - min) * Math.log(number / min)) / Math.log(max / min) : number);
  const shown = element("output", { for: id, "aria-live": "off" }, withUnit(value));
  const input = element("input", { type: "range", id, min, max, step, value: placeOf(value), "aria-valuetext": withUnit(value), oninput: () => {
    const number = valueAt(Number(input.value));
    shown.textContent = withUnit(number);
    input.setAttribute("aria-valuetext", withUnit(number));
    change(number);
  } });
  return element("div", { class: "control" }, element("label", { for: id }, ...worded(name)), shown, input);
}

/// A button that copies a text; if the page may not copy, the text is shown in a field. What it says is true until a setting changes.
function copyButton(words, textOf) {
  let field;
  const button = element("button", { onclick: async () => {
    const text = textOf();
    try {
      await navigator.clipboard.writeText(text);
      button.textContent = words.copied;
      say(words.copied);
    } catch {
      field ??= element("input", { readonly: true, "aria-label": words.copy });
      field.value = text;
      button.after(field);
      field.select();
    }
  } }, words.copy);
  address.heard.push(() => {
    button.textContent = words.copy;
    field?.remove();
  });
  return button;
}
