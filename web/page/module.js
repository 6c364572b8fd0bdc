// SPDX-License-Identifier: GPL-3.0-or-later
// granum as a WebAssembly module. Runs in the page and in the worker. All numbers are in SI.
"use strict";

class Granum {
  /// From a compiled WebAssembly.Module. onFrame is called while an experiment runs.
  static async create(compiled, onFrame = () => {}) {
    const granum = new Granum();
    granum.compiled = compiled;
    granum.onFrame = onFrame;
    await granum.restart();
    const assumed = granum.call("assumed_inputs");
    assumedDeviations = Object.fromEntries(assumed.notes.map((name, k) => [name, assumed.numbers[k]]));
    contactLaws = granum.call("laws").notes.map((line) => {
      const [name, plural, ...numbers] = line.split("\t");
      return { name, plural, numbers: numbers.filter((_, k) => k % 2 === 0).map((key, k) => ({ key, value: Number(numbers[2 * k + 1]) })) };
    });
    return granum;
  }

  /// A new instance: after an error the old one is in an undefined state.
  async restart() {
    this.exports = this.begin(await WebAssembly.instantiate(this.compiled, this.imports()));
  }
  begin(instance) {
    instance.exports._initialize();
    return instance.exports;
  }

  imports() {
    const unsupported = () => 52; // ENOSYS: the page has no files
    return {
      page: {
        thrown: (address, length) => {
          throw new GranumError(this.text(address, length));
        },
        frame: () => this.onFrame(this),
      },
      wasi_snapshot_preview1: {
        clock_time_get: (_clock, _precision, address) => {
          const now = BigInt(Math.round(performance.now() * 1e6));
          new DataView(this.exports.memory.buffer).setBigUint64(address, now, true);
          return 0;
        },
        environ_get: unsupported,
        environ_sizes_get: unsupported,
        fd_close: unsupported,
        fd_seek: unsupported,
        fd_write: unsupported,
        proc_exit: () => {
          throw new GranumError("granum ended by itself");
        },
      },
    };
  }

  text(address, length) {
    return new TextDecoder().decode(new Uint8Array(this.exports.memory.buffer, address, length));
  }
  floats(address, count) {
    return new Float32Array(this.exports.memory.buffer, address, count).slice();
  }

  /// Calls an exported function: {numbers, notes}. Throws a GranumError with granum's own message.
  call(name, ...args) {
    try {
      this.exports.forget();
      this.exports[name](...args);
    } catch (error) {
      // Compiled modules of this size start at once only in a worker; elsewhere the next call waits for it.
      this.exports = this.begin(new WebAssembly.Instance(this.compiled, this.imports()));
      throw error;
    }
    const e = this.exports;
    return {
      numbers: Array.from(new Float64Array(e.memory.buffer, e.numbers_address(), e.numbers_count())),
      notes: this.text(e.words_address(), e.words_count()).split("\n").filter(Boolean),
    };
  }

  contactCurve(grain, largestOverlap, points) {
    const { numbers } = this.call("contact_curve", ...grainNumbers(grain), largestOverlap, points);
    const curve = { alpha: numbers[0], stiffnessExponent: numbers[1], tangentialRatio: numbers[2], points: [] };
    for (let k = 3; k < numbers.length; k += 4)
      curve.points.push({ overlap: numbers[k], force: numbers[k + 1], stiffness: numbers[k + 2], radius: numbers[k + 3] });
    return curve;
  }

  fabricCurve(anisotropy, points) {
    return this.call("fabric_curve", anisotropy, points).numbers;
  }

  relaxation(z, tangentialRatio, stiffnessExponent) {
    const [shear, shearError, bulk, bulkError] = this.call("relaxation", z, tangentialRatio, stiffnessExponent).numbers;
    return { shear, shearError, bulk, bulkError };
  }

  /// {uniformStrain, uniformStress, relaxed: {bulk, hh, vh, exponent, error}, meanForce,
  /// transitionPressure of rough spheres, notes}
  closedForms(grain, packing) {
    const { numbers, notes } = this.call("closed_forms", ...grainNumbers(grain), packing.voidRatio,
      packing.coordinationNumber, packing.anisotropy ?? 0, packing.stressV, packing.stressH ?? packing.stressV,
      packing.mechanicalCoordinationNumber ?? NaN);
    const form = (k) => ({ bulk: numbers[k], hh: numbers[k + 1], vh: numbers[k + 2], exponent: numbers[k + 3], error: numbers[k + 4] });
    return { uniformStrain: form(0), uniformStress: form(5), relaxed: form(10), meanForce: numbers[15], transitionPressure: numbers[16], notes };
  }

  /// One packing from pressure to pressure: {states: [{pressure, z, rattlers, voidRatio, uniformStrain, relaxed}],
  /// slope: {uniformStrain, relaxed}}
  carriedPath(grain, packing, to, points) {
    const { numbers, notes } = this.call("carried_path", ...grainNumbers(grain), packing.voidRatio,
      packing.mechanicalCoordinationNumber, packing.rattlerFraction, packing.pressure, to, points);
    const states = [];
    for (let k = 0; k < 6 * points; k += 6) {
      const [pressure, z, rattlers, voidRatio, uniformStrain, relaxed] = numbers.slice(k, k + 6);
      states.push({ pressure, z, rattlers, voidRatio, uniformStrain, relaxed });
    }
    const [uniformStrain, , relaxed] = numbers.slice(6 * points);
    return { states, slope: { uniformStrain, relaxed }, notes };
  }
}

class GranumError extends Error {}

/// Axial strain of a step of shear.
const shearStep = 0.001;
const shearNames = ["event", "axialStrain", "volumetricStrain", "deviator", "ratio", "stressV", "stressH",
  "peakDeviator", "peakRatio", "peakStrain", "peakAngle", "pathError", "work"];
/// A point of a stress-strain curve, of the row of experiment_shear.
const shearPoint = (numbers) => Object.fromEntries(shearNames.map((name, k) => [name, numbers[k]]));

/// granum's table of contact laws: [{name, plural, numbers: [{key, value}]}]
let contactLaws = [];
/// Standard deviations of the inputs that granum assumes, by the names of its arguments.
let assumedDeviations = {};
const lawNamed = (name) => contactLaws.find((law) => law.name === name);
/// Arguments of granum's functions for two grains; the numbers of a law are those of the table unless the grain has them.
function grainNumbers(grain) {
  const law = lawNamed(grain.shape);
  const numbers = law.numbers.map(({ key, value }) => grain.numbers?.[key] ?? value);
  return [contactLaws.indexOf(law), grain.shearModulus, grain.poissonRatio, grain.radius, numbers[0] ?? NaN, numbers[1] ?? NaN];
}
