// SPDX-License-Identifier: GPL-3.0-or-later
// A guess before each answer: one tap, kept on this device, and shown beside the result.
"use strict";

/// "× 1.26"
const times = (factor) => `× ${written(factor)}`;

/// The question of a step: {options: [text], right: index, values} comes from the step, the words from its texts.
function guessPart(texts, words, name, { options, right, values = {} }) {
  const all = kept.read("guesses"), answer = element("p", { class: "answered" });
  const buttons = options.map((text, k) => element("button", { type: "button", "aria-pressed": "false", onclick: () => {
    kept.write("guesses", { ...kept.read("guesses"), [name]: k });
    show(k);
    say(answer.textContent);
  } }, ...worded(text)));
  const show = (k) => {
    buttons.forEach((button, at) => button.setAttribute("aria-pressed", String(at === k)));
    answer.replaceChildren(...worded(`${filled(k === right ? texts.guess.right : texts.guess.wrong, { guess: options[k] })} ${filled(words.answer, values)}`));
  };
  if (options[all[name]] !== undefined) show(all[name]);
  return element("fieldset", { class: "question", id: `${name}guess` }, element("legend", {}, ...worded(filled(words.question, values))), ...buttons, answer);
}
