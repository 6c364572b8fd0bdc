// SPDX-License-Identifier: GPL-3.0-or-later
// The curves of triaxial compression of all specimens: deviator and volumetric strain against axial strain, as they come in. They stay
// until they are cleared.
"use strict";

/// Strain at which a test ends, and that up to which its beginning is shown.
const largestShearStrain = 0.03, beginningOfShear = 0.005;
const shearColumns = { axial_strain: "axialStrain", volumetric_strain: "volumetricStrain", q_Pa: "deviator", eta: "ratio", sigma_v_Pa: "stressV", sigma_h_Pa: "stressH", work_J_per_m3: "work" };

class ShearCurves {
  /// `runs` gives all specimens.
  constructor(texts, runs) {
    this.texts = texts;
    this.words = texts.shear;
    this.all = runs;
    const part = (name) => {
      const picture = element("div", { class: "picture", id: `x${name}` });
      return [picture, element("div", {}, picture, saveButton(texts, picture, () => `${name}-${runsName(this.sheared())}`))];
    };
    const [beginning, beginningPane] = part("beginning"), [stress, stressPane] = part("deviator"), [volume, volumePane] = part("volume");
    this.pictures = { beginning, stress, volume };
    this.save = element("button", { id: "xshearcsv", disabled: true, onclick: () =>
      saveFile(`granum-${pageVersion}-shear-${runsName(this.sheared())}.csv`, fileOf(this.sheared(), shearColumns, (run) => run.points), "text/csv") }, this.words.csv);
    this.contrast = element("p", { class: "finding" });
    this.place = element("div", { id: "xshearpart", hidden: true }, element("h3", {}, this.words.title), ...this.words.text.split("\n").map((text) => element("p", {}, ...worded(text))),
      element("div", { class: "panes even" }, stressPane, beginningPane, volumePane, element("div", {}, this.contrast, this.save)));
    drawnToSize(() => this.draw());
  }
  sheared() {
    return this.all().filter((run) => run.points?.length);
  }

  /// The peak of a specimen as text.
  peakText(run) {
    const last = run.points.at(-1);
    return filled(this.words.peak, { q: written(last.peakDeviator / 1e3), strain: written(100 * last.peakStrain, 2), angle: written((180 / Math.PI) * last.peakAngle),
      grain: written((180 / Math.PI) * run.setup.grain.frictionAngle) });
  }
  /// q of dense and loose specimens of one kind at half of the strain that is seen of the beginning.
  contrastText() {
    const strain = beginningOfShear / 5, made = this.sheared().filter(({ points }) => points.at(-1).axialStrain >= strain);
    const q = (run) => {
      const k = run.points.findIndex((point) => point.axialStrain >= strain), [a, b] = [run.points[k - 1] ?? { axialStrain: 0, deviator: 0 }, run.points[k]];
      return a.deviator + ((b.deviator - a.deviator) * (strain - a.axialStrain)) / (b.axialStrain - a.axialStrain);
    };
    const dense = made.findLast(({ setup }) => !setup.loose), loose = dense && made.findLast(({ setup }) => setup.loose && setup.grain.shape === dense.setup.grain.shape);
    return loose ? filled(this.words.contrast, { strain: written(100 * strain), dense: written(q(dense) / 1e3), loose: written(q(loose) / 1e3), shape: lawNamed(dense.setup.grain.shape).plural }) : "";
  }

  draw() {
    const runs = this.sheared(), begun = this.all().some((run) => run.points);
    this.place.hidden = !begun;
    if (!begun) return;
    this.save.disabled = !runs.length;
    const curve = (run, of) => [[0, 0], ...run.points.map((point) => [100 * point.axialStrain, of(point)])];
    const named = (run) => `${this.all().indexOf(run) + 1}: ${nameOf(this.texts.experiment, run)}`;
    const series = (of) => runs.map((run) => ({ label: named(run), name: runs.length > 1 ? String(this.all().indexOf(run) + 1) : "", colour: colourOf(run), dash: run.setup.loose, points: curve(run, of) }));
    const q = (point) => point.deviator / 1e3, volume = (point) => 100 * point.volumetricStrain, last = runs.at(-1)?.points.at(-1);
    const finding = filled(this.words.finding, { count: runs.at(-1)?.points.length ?? 0, q: last ? written(q(last)) : "0" });
    const picture = (place, title, label, of, largest, limits, more) => {
      const heights = runs.flatMap((run) => curve(run, of).filter(([x]) => x <= 100 * largest).map(([, y]) => y)).concat(0);
      place.innerHTML = chart({ title, finding, x: { label: this.words.axial, min: 0, max: 100 * largest }, y: { label, ...limits(Math.min(...heights), Math.max(...heights)) }, series: series(of), ...more });
    };
    const upwards = (_, high) => ({ min: 0, max: 1.15 * Math.max(20, high) });
    picture(this.pictures.stress, this.words.deviator, this.words.deviator, q, largestShearStrain, upwards, runs.length === 1 ? { mark: [100 * last.peakStrain, last.peakDeviator / 1e3] } : {});
    picture(this.pictures.beginning, this.words.beginning, this.words.deviator, q, beginningOfShear, upwards, {});
    picture(this.pictures.volume, this.words.volumetric, this.words.volumetric, volume, largestShearStrain, (low, high) => {
      const room = Math.max(0.02, 0.08 * (high - low));
      return { min: low - room, max: high + room };
    }, { finding: filled(this.words.volumeFinding, { volume: last ? written(volume(last), 2) : "0" }) });
    this.contrast.textContent = this.contrastText();
  }
}
