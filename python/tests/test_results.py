# SPDX-License-Identifier: GPL-3.0-or-later
"""Results and laws are values: they show their numbers, compare, and go into pickles, dictionaries and tables."""

import copy
import pickle

import granum
import numpy as np
import pytest

LAWS = {
    "sphere": lambda g: granum.sphere(shear_modulus=g, poisson_ratio=0.15, radius=5e-4),
    "cone": lambda g: granum.cone(shear_modulus=g, poisson_ratio=0.15, slope=0.4),
    "flat": lambda g: granum.flat_punch(shear_modulus=g, poisson_ratio=0.15, punch_radius=1e-6),
    "general": lambda g: granum.power_law(shear_modulus=g, poisson_ratio=0.15, alpha=1.5, profile_constant=180),
    "times": lambda g: granum.sphere(shear_modulus=g, poisson_ratio=0.15, radius=5e-4).times(1.7),
}


@pytest.mark.parametrize("make", LAWS.values(), ids=LAWS)
def test_laws_are_values(make):
    law = make(30e9)
    for other in (pickle.loads(pickle.dumps(law)), copy.copy(law), copy.deepcopy(law)):
        assert other == law and hash(other) == hash(law) and repr(other) == repr(law)
        assert other.stiffness_at_force(1e-3) == law.stiffness_at_force(1e-3)
    assert make(31e9) != law and law != 1
    assert len({law, make(30e9), make(31e9)}) == 2


INPUTS = {
    "means": lambda: granum.ContactMeans(branch=1.1, branch_square=1.3, pair_radius=0.9, grain_volume=1.2),
    "sizes": lambda: granum.Distribution("lognormal:0.35"),
}


@pytest.mark.parametrize("make", INPUTS.values(), ids=INPUTS)
def test_objects_made_by_users_are_restored(make):
    made = make()
    for other in (pickle.loads(pickle.dumps(made)), copy.deepcopy(made)):
        assert type(other) is type(made) and other == made
    solid = granum.isotropic(bulk_modulus=3e9, shear_modulus=2e9)
    assert pickle.loads(pickle.dumps(solid)).young_modulus == pytest.approx(solid.young_modulus, rel=1e-15)


def results(packing, sphere):
    pressure = np.geomspace(1e4, 1e6, 5)
    measured = granum.measure(packing, law=sphere)
    keywords = dict(radius=5e-4, void_ratio=0.6, coordination_number=5.0)
    yield granum.uniform_strain(law=sphere, pressure=1e5, **keywords)
    yield granum.uniform_strain(law=sphere, pressure=pressure, **keywords)
    yield granum.relaxed(law=sphere, pressure=pressure, rattler_fraction=0.02, **keywords)
    yield granum.packing_answer(law=sphere, pressure=pressure, radius=5e-4, void_ratio=0.6)
    yield granum.estimate(law=sphere, pressure=1e5, radius=5e-4, void_ratio=0.6, tolerance=0.1)
    yield granum.contact_prior(law=sphere, radius=5e-4, void_ratio=0.6, pressure=1e5)
    yield measured
    yield packing.contacts
    yield from (measured.counts, measured.fabric, measured.forces, measured.stress, measured.network, measured.sizes)


def test_every_class_shows_its_numbers():
    classes = [c for c in vars(granum).values() if isinstance(c, type) and not issubclass(c, BaseException)]
    assert len(classes) > 45
    assert [c.__name__ for c in classes if c.__repr__ is object.__repr__] == []


def simulation(sphere, grains=40):
    return granum.specimen(law=sphere, radius=5e-4, friction_coefficient=0.5, kind="dense", grains=grains)


def test_no_pickle_ends_the_process(packing, sphere, dump):
    """pybind11 ends it in object.__reduce__, which protocols 0 and 1 call, so no class may have that."""
    classes = [c for c in vars(granum._granum).values() if isinstance(c, type)]
    assert len(classes) > 45
    assert [c.__name__ for c in classes if c.__reduce__ is object.__reduce__] == []
    values = [sphere, packing, *(make() for make in INPUTS.values()), *results(packing, sphere)]
    for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
        for value in values:
            assert pickle.loads(pickle.dumps(value, protocol)) == value
    start = simulation(sphere)
    running = [
        start,
        granum.compress(start, [20e3]),
        granum.shear(start, path="TXC", mean_stress=20e3),
        granum.frames(*dump),
    ]
    for value in running:
        for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
            with pytest.raises(TypeError, match=type(value).__name__):
                pickle.dumps(value, protocol)
        for refused in (copy.copy, lambda it: it.__reduce__()):
            with pytest.raises(TypeError, match=type(value).__name__):
                refused(value)


def test_results_come_back_out_of_a_pickle_with_every_number(packing, sphere):
    for result in results(packing, sphere):
        record = pickle.loads(pickle.dumps(result))
        again = isinstance(result, (granum.Inference, granum.SandInference))  # with its predictions
        assert isinstance(record, type(result) if again else granum.Record)
        assert record == result and result == record, type(result)
        assert pickle.loads(pickle.dumps(record)) == record
        assert copy.deepcopy(result) == result
        kind = type(result).__name__
        assert kind in repr(result) and kind in repr(record)
        names = list(result.to_dict())
        assert names and list(record.to_dict()) == names
        with pytest.raises(AttributeError):
            record.no_such_name
        with pytest.raises(AttributeError):
            (granum.Record("none", {}) if again else record).shape = (2,)


def test_results_of_other_numbers_differ(sphere):
    def at(pressure):
        return granum.uniform_strain(
            law=sphere, radius=5e-4, void_ratio=0.6, coordination_number=5.0, pressure=pressure
        )

    assert at(1e5) == at(1e5) and at(1e5) != at(1.001e5)
    assert at([1e5, 2e5]) == at([1e5, 2e5]) and at([1e5, 2e5]) != at([1e5, 3e5])
    assert at(1e5) != at([1e5]) and at(1e5) != 3


def test_dictionaries_contain_copies(packing, sphere):
    measured = granum.measure(packing, law=sphere)
    values = measured.to_dict()
    assert values["counts"]["grains"] == measured.counts.grains
    assert values["void_ratio"] == measured.void_ratio
    stiffness = values["network"]["relaxed"]
    stiffness[0, 0] = 0  # of its own memory
    assert measured.network.relaxed[0, 0] > 0


def test_columns_are_a_table(sphere):
    pressure = np.geomspace(1e4, 1e6, 6).reshape(2, 3)
    answer = granum.packing_answer(law=sphere, pressure=pressure, radius=5e-4, void_ratio=0.6)
    columns = answer.to_columns()
    assert {column.shape for column in columns.values()} == {(6,)}
    assert np.array_equal(columns["shear_modulus"], answer.shear_modulus.value.ravel())
    assert np.array_equal(columns["shear_modulus_low"], answer.shear_modulus.low.ravel())
    found = granum.uniform_strain(
        law=sphere, radius=5e-4, void_ratio=0.6, coordination_number=5.0, pressure=pressure
    )
    columns = found.to_columns()
    assert np.array_equal(columns["stiffness_44"], found.G_vh.ravel())
    assert np.array_equal(columns["G_vh"], found.G_vh.ravel())
    one = granum.symmetry_distances(found.stiffness[0, 0]).to_columns()
    assert {column.shape for column in one.values()} == {(1,)}


def test_columns_have_a_row_for_each_contact_direction_and_state(packing, sphere):
    contacts = packing.contacts
    columns = contacts.to_columns()
    assert np.array_equal(columns["i"], contacts.i) and np.array_equal(columns["branch_3"], contacts.branch[:, 2])
    assert {column.shape for column in columns.values()} == {(len(contacts),)}
    assert {"j", "normal_1", "overlap", "normal_force", "tangential_force_2", "sliding"} <= columns.keys()
    record = pickle.loads(pickle.dumps(contacts)).to_columns()
    assert all(np.array_equal(record[name], columns[name]) for name in columns)

    pressure = np.geomspace(1e4, 1e6, 6).reshape(2, 3)
    answer = granum.packing_answer(law=sphere, pressure=pressure, radius=5e-4, void_ratio=0.6)
    assert np.array_equal(answer.bulk_modulus.to_columns()["high"], answer.bulk_modulus.high.ravel())
    grains = dict(law=sphere, radius=5e-4, coordination_number=5.0, pressure=pressure)
    moduli = granum.uniform_strain_moduli(porosity=0.4, **grains)
    assert np.array_equal(moduli.to_columns()["shear_modulus"], moduli.shear_modulus.ravel())
    errors = granum.relaxed(void_ratio=0.6, rattler_fraction=0.02, **grains).relative_error
    assert np.array_equal(errors.to_columns()["G_vh"], errors.G_vh.ravel())
    waves = granum.plane_waves(np.eye(6) * 1e8, bulk_density=1650.0, direction=np.eye(3)[:2])
    assert np.array_equal(waves.to_columns()["speed_1"], waves.speed[:, 0])
    assert np.array_equal(waves.to_columns()["polarisation_13"], waves.polarisation[:, 0, 2])
    one = granum.plane_waves(np.eye(6) * 1e8, bulk_density=1650.0, direction=[0, 0, 1])
    assert one.to_columns()["speed_3"] == [one.speed[2]]


def test_columns_of_a_study_are_its_states():
    study = granum.verify(
        {"study.contacts": ["sphere"], "study.densities": ["dense"], "study.grains": 40,
         "study.pressures": [20e3, 40e3, 80e3], "study.probe_pressures": [40e3]}
    )  # fmt: skip
    columns = study.to_columns()
    numbers = {name: value for name, value in study.states.items() if isinstance(value, np.ndarray)}
    assert columns.keys() == numbers.keys() and len(columns) > 5
    for name, value in numbers.items():
        assert np.array_equal(columns[name], value, equal_nan=True)


def test_results_with_arrays_have_columns(packing, sphere):
    for result in results(packing, sphere):
        assert result.to_columns(), type(result)


def test_a_range_is_scaled_shifted_and_formatted():
    one = granum.packing_answer(law=LAWS["sphere"](30e9), radius=5e-4, void_ratio=0.6, pressure=1e5).shear_modulus
    for scaled in (one * 1e-6, 1e-6 * one, one / 1e6, pickle.loads(pickle.dumps(one)) * 1e-6):
        assert (scaled.value, scaled.low, scaled.high) == pytest.approx((one.value / 1e6, one.low / 1e6, one.high / 1e6))
    turned = -1 * one + 5
    assert turned.low == 5 - one.high and turned.high == 5 - one.low and turned - 5 == one * -1
    assert f"{one / 1e6:.1f}" == f"{one.value / 1e6:.1f} ({one.low / 1e6:.1f} to {one.high / 1e6:.1f})"
    assert f"{one}" == str(one)
    many = granum.packing_answer(law=LAWS["sphere"](30e9), radius=5e-4, void_ratio=[0.6, 0.7], pressure=1e5).shear_modulus
    assert (many * 2).high.tolist() == (2 * many.high).tolist()
    for refused in (lambda: one * one, lambda: one + "1", lambda: one * True, lambda: f"{many:.3g}"):
        with pytest.raises(TypeError):
            refused()


def test_results_are_tables_in_notebooks():
    answer = granum.packing_answer(law=LAWS["sphere"](30e9), radius=5e-4, void_ratio=0.6, pressure=1e5)
    html = answer._repr_html_()
    assert html.count("<tr>") == len(answer.to_dict()) and "<th>shear_modulus</th>" in html
    assert pickle.loads(pickle.dumps(answer))._repr_html_() == html


def test_notes_of_arrays_are_one_for_each_kind():
    void_ratio = np.concatenate([np.linspace(0.40, 0.50, 600), np.linspace(0.6, 0.7, 400), [0.45]])
    call = dict(law=LAWS["sphere"](30e9), radius=5e-4, pressure=1e5)
    many = granum.packing_answer(**call, void_ratio=void_ratio).notes
    alone = [granum.packing_answer(**call, void_ratio=e).notes for e in (0.40, 0.60)]
    assert len(many) == len(alone[0]) and not alone[1]
    assert all(number in many[0] for number in ("601", "1001", "1000")) and many[0].endswith(alone[0][0])
    one = granum.packing_answer(**call, void_ratio=[0.65, 0.40]).notes
    assert one[0] != alone[0][0] and one[0].endswith(alone[0][0])
    assert granum.packing_answer(**call, void_ratio=[0.40]).notes == alone[0]


def test_what_comes_back_of_an_inference_predicts():
    pressure = np.array([1e5, 4e5])
    call = dict(law=LAWS["sphere"](26e9), radius=5e-4, void_ratio=0.58, V_s=[320, 425], relative_error=0.02)
    for kind in (dict(), dict(sand="toyoura", saturation=[0, 1])):
        found = granum.infer(**call, **kind, pressure=pressure, grain_density=2500)
        pressure[0] *= 1.5  # a change afterwards is none of what was inferred
        for other in (pickle.loads(pickle.dumps(found)), copy.deepcopy(found)):
            assert type(other) is type(found) and other == found
            assert other.predict("G", pressure=2e5) == found.predict("G", pressure=2e5)
        pressure[0] /= 1.5
