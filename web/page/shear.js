// SPDX-License-Identifier: GPL-3.0-or-later
// The curves of triaxial compression: deviator and volumetric strain against axial strain, as they come in.
"use strict";

/// Strain at which a test ends.
const largestShearStrain = 0.03;

class ShearCurves {
  constructor(texts) {
    this.words = texts.shear;
    this.points = [];
    const part = (name) => {
      const picture = element("div", { class: "picture", id: `x${name}` });
      return [picture, element("div", {}, picture, saveButton(texts, picture, name))];
    };
    const [stress, stressPane] = part("deviator"), [volume, volumePane] = part("volume");
    this.pictures = { stress, volume };
    this.save = element("button", { id: "xshearcsv", disabled: true, onclick: () => saveFile("granum-shear.csv", this.csv(), "text/csv") }, this.words.csv);
    this.place = element("div", { id: "xshearpart", hidden: true }, element("h3", {}, this.words.title), element("p", {}, this.words.text),
      element("div", { class: "panes even" }, stressPane, volumePane), this.save);
    drawnToSize(() => this.place.hidden || this.draw());
  }

  begin() {
    this.points = [];
    this.place.hidden = false;
    this.draw();
  }
  clear() {
    this.points = [];
    this.place.hidden = true;
  }
  add(point) {
    this.points.push(point);
    this.save.disabled = false;
    this.draw();
  }

  /// The peak as text, if there are points.
  peakText(grainFriction) {
    const last = this.points.at(-1);
    return filled(this.words.peak, { q: written(last.peakDeviator / 1e3), strain: written(100 * last.peakStrain, 2), angle: written((180 / Math.PI) * last.peakAngle),
      grain: written((180 / Math.PI) * grainFriction) });
  }

  draw() {
    const last = this.points.at(-1);
    const strain = { label: this.words.axial, min: 0, max: 100 * largestShearStrain };
    const curve = (of) => [[0, 0], ...this.points.map((point) => [100 * point.axialStrain, of(point)])];
    const stress = curve((point) => point.deviator / 1e3), volume = curve((point) => 100 * point.volumetricStrain);
    const heights = volume.map(([, y]) => y);
    const room = Math.max(0.02, 0.08 * (Math.max(...heights) - Math.min(...heights)));
    this.pictures.stress.innerHTML = chart({
      title: this.words.deviator, finding: filled(this.words.finding, { count: this.points.length, q: last ? written(last.deviator / 1e3) : "0" }),
      x: strain, y: { label: this.words.deviator, min: 0, max: 1.15 * Math.max(20, ...stress.map(([, y]) => y)) },
      series: [{ label: this.words.deviator, colour: colours.txc, points: stress }],
      mark: last && [100 * last.peakStrain, last.peakDeviator / 1e3],
    });
    this.pictures.volume.innerHTML = chart({
      title: this.words.volumetric, finding: filled(this.words.volumeFinding, { volume: written(heights.at(-1), 2) }),
      x: strain, y: { label: this.words.volumetric, min: Math.min(...heights) - room, max: Math.max(...heights) + room },
      series: [{ label: this.words.volumetric, colour: colours.txc, points: volume }],
    });
  }

  csv() {
    const columns = { axial_strain: "axialStrain", volumetric_strain: "volumetricStrain", q_Pa: "deviator", eta: "ratio", sigma_v_Pa: "stressV", sigma_h_Pa: "stressH", work_J_per_m3: "work" };
    return [Object.keys(columns).join(","), ...this.points.map((point) => Object.values(columns).map((name) => point[name]).join(","))].join("\n") + "\n";
  }
}
