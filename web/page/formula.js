// SPDX-License-Identifier: GPL-3.0-or-later
// Formulas in texts: between two $, in a small language.  x^2, x_n, x^{1/3}, {a}/{b} for a fraction; words are unchanged.
"use strict";

/// The text without marks, for names and titles that cannot contain formulas.
const plain = (text) => text.replace(/\$([^$]*)\$/g, (_, formula) => formula.replaceAll("^*", "*").replace(/\{([^{}]*)\}/g, (_all, inner) => (inner.length > 1 ? `(${inner})` : inner)).replace(/([_^])\(([\w*]+)\)/g, "$1$2"));

const mathNode = (tag, ...children) => {
  const made = document.createElementNS("http://www.w3.org/1998/Math/MathML", tag);
  made.append(...children);
  return made;
};

/// MathML of a formula.
function mathOf(formula) {
  const tokens = formula.match(/[A-Za-zα-ωΔ]+|[\d.]+|[^\s]/gu) ?? [];
  let next = 0;
  const row = (until) => {
    const parts = [];
    while (next < tokens.length && tokens[next] !== until) {
      const token = tokens[next++];
      if (token === "^" || token === "_") {
        const base = parts.pop(), lifted = one();
        const both = base?.localName === (token === "^" ? "msub" : "msup"); // x_n^2
        parts.push(both ? mathNode("msubsup", base.firstChild, ...(token === "^" ? [base.lastChild, lifted] : [lifted, base.lastChild])) : mathNode(token === "^" ? "msup" : "msub", base, lifted));
      } else if (token === "/" && parts.at(-1)?.localName === "mrow" && tokens[next] === "{") parts.push(mathNode("mfrac", parts.pop(), one()));
      else parts.push(leaf(token));
    }
    next += 1;
    return parts;
  };
  const leaf = (token) => {
    if (token === "{") return mathNode("mrow", ...row("}"));
    if (/^[\d.]+$/.test(token)) return mathNode("mn", token);
    return mathNode(/^[A-Za-zα-ωΔ]/u.test(token) ? "mi" : "mo", { "-": "−", "~": "∼" }[token] ?? token);
  };
  const one = () => leaf(tokens[next++]);
  return mathNode("math", ...row());
}

/// Subscripts: C_n.
const lowered = (text) => text.split(/_(\w+)/).map((part, k) => (k % 2 ? element("sub", {}, part) : part));
/// Nodes of a text with its formulas.
const worded = (text) => text.split("$").flatMap((part, k) => (k % 2 ? mathOf(part) : lowered(part)));
