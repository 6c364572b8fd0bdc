# SPDX-License-Identifier: GPL-3.0-or-later
"""What measurements say of a sand, and forecasts of it: as the program says them, to the bit."""

import granum
import numpy as np
import pytest

QUARTZ = {"shear_modulus": 44e9, "poisson_ratio": 0.074}
STATE = {"law": granum.sphere(**QUARTZ, radius=1e-4), "radius": 1e-4, "grain_density": 2650, "d50": 2e-4}
GRAIN = ["--grain-shear-modulus=44e9Pa", "--grain-poisson-ratio=0.074", "--radius=1e-4m", "--grain-density=2650kg/m3"]

SANDS = {
    "a name": ({"sand": "toyoura"}, ["--sand=toyoura"]),
    "no name": ({"grain_shape": "sand"}, ["--grain-shape=sand"]),
    "limits": (
        {"grain_shape": "sand", "least_void_ratio": 0.55, "largest_void_ratio": 0.9},
        ["--least-void-ratio=0.55", "--largest-void-ratio=0.9"],
    ),
    "a grading": ({"grain_shape": "sand", "uniformity": 2.4}, ["--uniformity=2.4"]),
    "full pores": ({"sand": "toyoura", "saturation": 1.0}, ["--sand=toyoura", "--saturation=100%"]),
    "spheres": ({"grain_shape": "sphere"}, ["--grain-shape=sphere"]),
}
# Quantity, value, pressure [Pa]; void ratio 0.7. A compression wave is last: none is measured in full pores.
MEASURED = [("V_s", 241.0, 103e3), ("G", 155e6, 400e3), ("V_p", 395.0, 103e3)]
QUANTITIES = ("G", "G_hh", "K", "V_s", "V_s_hh", "V_p", "V_p_h")


def measurements(count):
    """Keywords of the first measurements, one a row, and NaN where nothing was measured."""
    rows = MEASURED[:count]
    columns = {name: [value if name == key else np.nan for key, value, _ in rows] for name in QUANTITIES}
    return {"pressure": [p for *_, p in rows], **columns}


def table(path, count):
    lines = ["p_kPa,e,V_s_m/s,G_Pa,V_p_m/s"]
    for key, value, p in MEASURED[:count]:
        lines.append(f"{p / 1e3!r},0.7," + ",".join(repr(value) if key == name else "" for name in ("V_s", "G", "V_p")))
    path.write_text("\n".join(lines) + "\n")
    return path


def numbers_of(said, found, names):
    """Pairs of what the program and what Python have for these names, value and error or ends."""
    for name in names:
        for part, value in said[name].items():
            yield value, getattr(getattr(found, name), part)


@pytest.fixture(params=SANDS)
def case(request, run_program, tmp_path):
    """A sand measured three times: the program's JSON and Python's answer."""
    given, options = SANDS[request.param]
    count = 2 if "saturation" in given else 3
    options = [*options, *GRAIN, "--measurement-error=2%", "--predict-pressure=51kPa,1.9MPa"]
    said = run_program("infer", "--table", table(tmp_path / "measured.csv", count), *options, "--fabric=0")
    kept = {key: value for key, value in STATE.items() if key != "d50" or given != SANDS["spheres"][0]}
    found = granum.infer(**kept, **given, **measurements(count), void_ratio=0.7, relative_error=0.02)
    return said, found, given


def test_the_sand_is_that_of_the_program_to_the_bit(case):
    said, found, given = case
    if given == SANDS["spheres"][0]:
        assert said["sand"] is None and isinstance(found, granum.Inference)
        names = ("mechanical_coordination_number", "rattler_fraction", "coordination_number")
        assert all(a == b for a, b in numbers_of({**said["answer"]}, found, names[:1]))
        assert (found.chi_square, found.probability) == (said["chi_square"], said["probability"])
        return
    assert said["grain_shape"] == "sand" and isinstance(found, granum.SandInference)
    said = said["sand"]
    for a, b in numbers_of(said, found, ("level", "stress_exponent", "poisson_ratio")):
        assert a == b
    for name in ("tells_contacts", "chi_square", "degrees_of_freedom", "probability", "widening"):
        assert getattr(found, name) == said[name], name
    assert [one["deviation"] for one in said["measurements"]] == found.deviations
    assert [one["fitted"]["value"] for one in said["measurements"]] == [one.value for one in found.fitted]
    assert [one["fitted"]["standard_error"] for one in said["measurements"]] == [
        one.standard_error for one in found.fitted
    ]
    for a, b in numbers_of(said, found, ("mechanical_coordination_number", "contact_softness")):
        assert a == b


def test_forecasts_are_those_of_the_program_to_the_bit(case):
    said, found, given = case
    predictions = said["predictions"] if said["sand"] is None else said["sand"]["predictions"]
    assert len(predictions) == 2
    compared = 0
    for there in predictions:
        for quantity in QUANTITIES:
            if quantity not in there:
                with pytest.raises(granum.InvalidArgument):
                    found.predict(quantity, pressure=there["stress_v"])
                continue
            here = found.predict(quantity, stress_v=there["stress_v"], stress_h=there["stress_h"])
            assert (here.value, here.standard_error) == tuple(there[quantity].values()), quantity
            compared += 1
    assert compared == (10 if "saturation" in given else 14)


def test_forecasts_are_broadcast_and_remark_what_is_doubtful():
    found = granum.infer(**STATE, void_ratio=0.7, pressure=1e5, sand="toyoura", V_s=240, relative_error=0.02)
    there = found.predict("G", pressure=np.array([[5e4], [2e5]]), void_ratio=[0.7, 0.75, -1])
    assert there.value.shape == (2, 3) and np.isnan(there.value[:, 2]).all()
    one = found.predict("G", pressure=2e5, void_ratio=0.75)
    assert there.value[1, 1] == one.value and not one.notes
    assert found.predict("G", pressure=5e7).notes
    assert found.pressure == 1e5 and "level" in repr(found)


def test_what_belongs_to_the_other_kind_is_refused():
    measured = dict(**STATE, void_ratio=0.7, pressure=[1e5, 2e5], G=[9e7, 12e7], relative_error=0.02)
    fitted = granum.infer(**measured, sand="toyoura", growth="fitted")
    assert fitted.stress_exponent.value == pytest.approx(np.log(12 / 9) / np.log(2), rel=1e-3)
    for wrong in ({"rattler_fraction": 0.1}, {"contacts": "rough"}, {"pore_density": 1.0}):
        with pytest.raises(TypeError, match=next(iter(wrong))):
            granum.infer(**measured, sand="toyoura", **wrong)
    with pytest.raises(granum.InvalidArgument, match="fixed"):
        granum.infer(**measured, sand="toyoura", growth="fixed")
    with pytest.raises(granum.InvalidArgument, match="grain_shape"):
        granum.infer(**{key: value for key, value in measured.items() if key != "d50"}, growth="sand")
    with pytest.raises(TypeError, match="d50"):
        granum.infer(**measured)
    with pytest.raises(granum.InvalidArgument, match="saturation"):
        granum.infer(**measured, sand="toyoura", saturation=2)
    with pytest.raises(granum.InvalidArgument, match="uniformity"):
        granum.infer(**measured, grain_shape="sand", uniformity=0.5)
