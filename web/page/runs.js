// SPDX-License-Identifier: GPL-3.0-or-later
// Comparison of all specimens until they are cleared: one chart, one table, small pictures, one file.
"use strict";

const experimentPressures = [10, 13, 17, 22, 28, 36, 46, 60, 77, 100].map((p) => p * 1e3);
const stateNames = ["pressure", "voidRatio", "contacts", "z", "rattlers", "overlap", "bulk", "network", "affine", "uniformStrain", "relaxed",
  "s", "sError", "bulkUniformStrain", "bulkRelaxed", "lineFirst", "lineLast", "sRelaxed", "atRest", "contactAlone", "contactExponent"];
/// Names of G and K in a state.
const moduli = { G: { network: "network", uniformStrain: "uniformStrain", relaxed: "relaxed" }, K: { network: "bulk", uniformStrain: "bulkUniformStrain", relaxed: "bulkRelaxed" } };

/// {setup: {grain, loose, sigma, grains, seed}, guess, states, image, done}
const colourOf = (run) => shapeColour(run.setup.grain.shape);
const lastOf = (run) => run.states.at(-1);
const measuredS = (run) => `${fixed(lastOf(run).s, 3)} ± ${fixed(lastOf(run).sError, 3)}`;

/// "spheres, loose, 600 grains, seed 1"
const nameOf = (words, { setup }) => [lawNamed(setup.grain.shape).plural, ...(setup.grain.numbers ? [filled(words.isRough, { u: written(setup.grain.numbers.roughness * 1e9) })] : []), setup.loose ? words.isLoose : words.isDense, ...(setup.sigma ? [`σ ${setup.sigma}`] : []),
  filled(words.grainsSeed, setup)].join(", ");

/// Chart of all runs: the modulus of the network of each; for the last one also the closed forms and the contact alone.
function runsChart(granum, texts, runs, modulus) {
  const words = texts.experiment, legend = texts.legend, names = moduli[modulus];
  const shown = runs.filter((run) => run.states.length), last = shown.at(-1);
  const line = (run, key) => run.states.map((s) => [s.pressure / 1e3, s[key] / 1e6]);
  const ends = (run) => [run.states[0].pressure / 1e3, lastOf(run).pressure / 1e3];
  const fitted = modulus === "G" ? shown.filter((run) => run.states.length > 2) : [];
  const lineOf = (run) => [lastOf(run).lineFirst / 1e6, lastOf(run).lineLast / 1e6].map((G, k) => [ends(run)[k], G]);
  const series = shown.flatMap((run, k) => [
    { name: String(k + 1), label: shown.length > 1 ? `${k + 1}: ${nameOf(words, run)}` : legend.network, colour: shown.length > 1 ? colourOf(run) : colours.measured, points: line(run, names.network),
      line: false, dots: true, hollow: run.setup.loose },
    ...(fitted.includes(run) ? [{ colour: shown.length > 1 ? colourOf(run) : colours.measured, dash: run.setup.loose, faint: run !== last, points: lineOf(run) }] : [])]);
  if (last) series.unshift(
    { label: legend.uniformStrain, colour: colours.uniform_strain, faint: shown.length > 1, points: line(last, names.uniformStrain) },
    { label: legend.relaxed, colour: colours.closed_form, faint: shown.length > 1, points: line(last, names.relaxed) },
    { label: legend.contact, colour: colours.grey, dash: true, points: last.states.map((s) => [s.pressure / 1e3, (last.states[0][names.network] / 1e6) * s.contactAlone]) });
  const all = series.flatMap(({ points }) => points.map(([, y]) => y)).filter(Number.isFinite);
  const start = last && [ends(last)[0], last.states[0][names.network] / 1e6];
  return chart({
    title: shown.length === 1 ? `${texts.axis[modulus]}: ${nameOf(words, last)}` : words.chart, finding: filled(words.finding, { count: last?.states.length ?? 0, runs: shown.length }),
    x: { label: texts.axis.pressure, min: 9, max: 115, log: true },
    y: { label: texts.axis[modulus], min: all.length ? 0.8 * Math.min(...all) : 10, max: all.length ? 1.3 * Math.max(...all) : 500, log: true },
    series, bands: last && modulus === "G" ? [sandBand(granum, texts, start, ...(last.states.length > 1 ? ends(last) : [10, 100]))] : [],
    triangles: fitted.map((run) => {
      const [[x0, y0], [x1, y1]] = lineOf(run), x = x0 * (x1 / x0) ** 0.55;
      return { x0: x, x1, y: y0 * (y1 / y0) ** 0.55, slope: lastOf(run).s, colour: shown.length > 1 ? colourOf(run) : colours.measured, text: run === last ? filled(texts.slope, { s: measuredS(run) }) : "" };
    }),
    note: fitted.length ? filled(words.fittedOver, { from: written(ends(last)[0]), to: written(ends(last)[1]) }) : undefined,
  });
}

/// s of each run: guessed, measured, and for the contact alone.
function runsTable(texts, runs) {
  const words = texts.experiment;
  return element("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": words.runs }, element("table", { id: "xruns" },
    element("thead", {}, element("tr", {}, ...words.runColumns.map((name) => element("th", { scope: "col" }, ...worded(name))))),
    element("tbody", {}, ...runs.filter((run) => run.done).map((run) => element("tr", {},
      element("th", { scope: "row" }, element("span", { class: `swatch dot${run.setup.loose ? " hollow" : ""}`, style: `--colour:${colourOf(run)}` }), `${runs.indexOf(run) + 1}: ${nameOf(words, run)}`),
      ...[`${written(run.states[0].z)} → ${written(lastOf(run).z)}`, Number.isFinite(run.guess) ? written(run.guess) : "–", measuredS(run), written(lastOf(run).contactExponent)].map((text) => element("td", {}, text)))))));
}

const runsGallery = (texts, runs) => element("div", { class: "gallery" }, ...runs.filter((run) => run.image).map((run) => element("figure", {},
  element("img", { src: run.image, alt: filled(texts.experiment.specimen, { name: nameOf(texts.experiment, run) }) }), element("figcaption", {}, `${runs.indexOf(run) + 1}: ${nameOf(texts.experiment, run)}`))));

/// {name, text} of a file with all states; both contain the setup and the version of granum.
function runsFile(version, runs) {
  const names = ["p_Pa", "e", "C_n", "z_star", "rattler_fraction", "mean_overlap_over_d", "K_network_Pa", "G_network_Pa", "G_affine_Pa", "G_uniform_strain_Pa", "G_relaxed_Pa"];
  const of = ({ setup }) => [setup.grain.shape, setup.loose ? "loose" : "dense", setup.sigma, setup.grains, setup.seed, setup.grain.numbers?.roughness ?? ""];
  const made = runs.filter((run) => run.states.length);
  const rows = made.flatMap((run, k) => run.states.map((s) => [...names.map((_, n) => s[stateNames[n]]), k + 1, ...of(run)].join(",")));
  const [shape, preparation, , grains, seed] = of(made[0]);
  return {
    name: made.length === 1 ? `granum-${version}-${shape}-${preparation}-${grains}-seed${seed}.csv` : `granum-${version}-${made.length}-specimens.csv`,
    text: `# granum ${version}\n${[...names, "specimen", "contact", "preparation", "lognormal_sigma", "grains", "seed", "roughness_m"].join(",")}\n${rows.join("\n")}\n`,
  };
}
