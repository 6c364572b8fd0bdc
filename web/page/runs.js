// SPDX-License-Identifier: GPL-3.0-or-later
// Comparison of all specimens until they are cleared: one chart, one table, small pictures, one file.
"use strict";

const experimentPressures = [10, 13, 17, 22, 28, 36, 46, 60, 77, 100].map((p) => p * 1e3);
const stateNames = ["pressure", "voidRatio", "contacts", "z", "rattlers", "overlap", "bulk", "network", "affine", "uniformStrain", "relaxed",
  "s", "sError", "bulkUniformStrain", "bulkRelaxed", "lineFirst", "lineLast", "sRelaxed", "atRest", "contactAlone", "contactExponent"];
/// Names of G and K in a state.
const moduli = { G: { network: "network", uniformStrain: "uniformStrain", relaxed: "relaxed" }, K: { network: "bulk", uniformStrain: "bulkUniformStrain", relaxed: "bulkRelaxed" } };

/// {setup: {grain, loose, sigma, grains, seed}, guess, states, image, done, points: of its shear}
const colourOf = (run) => shapeColour(run.setup.grain.shape);
const lastOf = (run) => run.states.at(-1);
const measuredS = (run) => `${fixed(lastOf(run).s, 3)} ± ${fixed(lastOf(run).sError, 3)}`;

/// "spheres, loose, 600 grains, seed 1"
const nameOf = (words, { setup }) => [lawNamed(setup.grain.shape).plural, ...(setup.grain.numbers ? [filled(words.isRough, { u: written(setup.grain.numbers.roughness * 1e9) })] : []), setup.loose ? words.isLoose : words.isDense, ...(setup.sigma ? [`σ ${setup.sigma}`] : []),
  filled(words.grainsSeed, setup)].join(", ");

/// Chart of all runs: the modulus of the network of each; for the last one also the closed forms and the contact alone.
function runsChart(granum, texts, runs, modulus) {
  const words = texts.experiment, legend = texts.legend, names = moduli[modulus];
  const shown = runs.filter((run) => run.states.length), last = shown.at(-1), several = shown.length > 1;
  const line = (run, key) => run.states.map((s) => [s.pressure / 1e3, s[key] / 1e6]);
  const ends = (run) => [run.states[0].pressure / 1e3, lastOf(run).pressure / 1e3];
  const fitted = modulus === "G" ? shown.filter((run) => run.states.length > 2) : [];
  const lineOf = (run) => [lastOf(run).lineFirst / 1e6, lastOf(run).lineLast / 1e6].map((G, k) => [ends(run)[k], G]);
  const colour = (run) => (several ? colourOf(run) : colours.measured);
  const number = (run) => runs.indexOf(run) + 1, ofLast = (text) => (several ? `${number(last)}: ${text}` : text);
  const series = shown.flatMap((run) => [
    { name: several ? String(number(run)) : "", label: several ? `${number(run)}: ${nameOf(words, run)}${fitted.includes(run) ? `, ${filled(texts.slope, { s: measuredS(run) })}` : ""}` : legend.network, colour: colour(run),
      points: line(run, names.network), line: false, dots: true, hollow: run.setup.loose },
    ...(fitted.includes(run) ? [{ colour: colour(run), dash: run.setup.loose, points: lineOf(run) }] : [])]);
  if (last) series.unshift(
    { label: ofLast(legend.uniformStrain), colour: colours.uniform_strain, faint: several, points: line(last, names.uniformStrain) },
    { label: ofLast(legend.relaxed), colour: colours.closed_form, faint: several, points: line(last, names.relaxed) },
    { label: ofLast(legend.contact), colour: colours.grey, dash: "dots", points: last.states.map((s) => [s.pressure / 1e3, (last.states[0][names.network] / 1e6) * s.contactAlone]) });
  const all = series.flatMap(({ points }) => points.map(([, y]) => y)).filter(Number.isFinite);
  const start = last && [ends(last)[0], last.states[0][names.network] / 1e6], measured = fitted.at(-1);
  return chart({
    title: shown.length === 1 ? `${texts.axis[modulus]}: ${nameOf(words, last)}` : words.chart, finding: filled(words.finding, { count: last?.states.length ?? 0, runs: shown.length }),
    x: { label: texts.axis.pressure, min: 9, max: 115, log: true },
    y: { label: texts.axis[modulus], min: all.length ? 0.8 * Math.min(...all) : 10, max: all.length ? 1.3 * Math.max(...all) : 500, log: true },
    series, bands: last && modulus === "G" ? [sandBand(granum, texts, start, ...(last.states.length > 1 ? ends(last) : [10, 100]))] : [],
    triangles: measured ? [measured].map((run) => {
      const [[x0, y0], [x1, y1]] = lineOf(run), x = x0 * (x1 / x0) ** 0.55;
      return { x0: x, x1, y: y0 * (y1 / y0) ** 0.55, slope: lastOf(run).s, colour: colour(run), text: filled(texts.slope, { s: measuredS(run) }) };
    }) : [],
    note: measured ? filled(words.fittedOver, { from: written(ends(measured)[0]), to: written(ends(measured)[1]) }) : undefined,
  });
}

/// s of each run: guessed, measured, and for the contact alone.
function runsTable(texts, runs) {
  const words = texts.experiment;
  return element("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": words.runs }, element("table", { id: "xruns" },
    element("thead", {}, element("tr", {}, ...words.runColumns.map((name) => element("th", { scope: "col" }, ...worded(name))))),
    element("tbody", {}, ...runs.filter((run) => run.done || (run.phase === "ended" && run.states.length > 2)).map((run) => element("tr", {},
      element("th", { scope: "row" }, element("span", { class: `swatch dot${run.setup.loose ? " hollow" : ""}`, style: `--colour:${colourOf(run)}` }), `${runs.indexOf(run) + 1}: ${nameOf(words, run)}`),
      ...[`${written(run.states[0].z)} → ${written(lastOf(run).z)}`, Number.isFinite(run.guess) ? written(run.guess) : "–", measuredS(run), written(lastOf(run).contactExponent)].map((text) => element("td", {}, text)))))));
}

const runsGallery = (texts, runs) => element("div", { class: "gallery" }, ...runs.filter((run) => run.image).map((run) => element("figure", {},
  element("img", { src: run.image, alt: filled(texts.experiment.specimen, { name: nameOf(texts.experiment, run) }) }), element("figcaption", {}, `${runs.indexOf(run) + 1}: ${nameOf(texts.experiment, run)}`))));

/// What a file says of a run.
const setupNames = ["specimen", "contact", "preparation", "lognormal_sigma", "grains", "seed", "roughness_m"];
const setupOf = ({ setup }) => [setup.grain.shape, setup.loose ? "loose" : "dense", setup.sigma, setup.grains, setup.seed, setup.grain.numbers?.roughness ?? ""];
/// "0.2.0-sphere-dense-200-seed1", or the number of specimens.
function runsName(runs) {
  if (runs.length !== 1) return `${runs.length}-specimens`;
  const [shape, preparation, , grains, seed] = setupOf(runs[0]);
  return `${shape}-${preparation}-${grains}-seed${seed}`;
}
/// The text of a file: rows of numbers of each run, by name, and what each is of.
function fileOf(runs, columns, rowsOfRun) {
  const rows = runs.flatMap((run, k) => rowsOfRun(run).map((row) => [...Object.values(columns).map((name) => row[name]), k + 1, ...setupOf(run)].join(",")));
  return `# granum ${pageVersion}\n${[...Object.keys(columns), ...setupNames].join(",")}\n${rows.join("\n")}\n`;
}
const stateColumns = { p_Pa: "pressure", e: "voidRatio", C_n: "contacts", z_star: "z", rattler_fraction: "rattlers", mean_overlap_over_d: "overlap", K_network_Pa: "bulk", G_network_Pa: "network",
  G_affine_Pa: "affine", G_uniform_strain_Pa: "uniformStrain", G_relaxed_Pa: "relaxed" };
/// {name, text} of a file with all states; both contain the setup and the version of granum.
function runsFile(runs) {
  const made = runs.filter((run) => run.states.length);
  return { name: `granum-${pageVersion}-${runsName(made)}.csv`, text: fileOf(made, stateColumns, (run) => run.states) };
}
