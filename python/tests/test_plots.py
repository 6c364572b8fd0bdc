# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures show the numbers of the results, and the notebooks print what they hold."""

import pathlib
import re
import runpy
import sys

import granum
import numpy as np
import pytest

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")
import matplotlib.pyplot as plt

STATE = {"radius": 0.5e-3, "void_ratio": 0.6, "coordination_number": 5.7, "pressure": 100e3}


@pytest.fixture(autouse=True)
def no_picture_stays_open():
    yield
    plt.close("all")


def test_a_colour_has_one_meaning_everywhere():
    table = (pathlib.Path(__file__).parents[2] / "include/granum/plot/palette.hpp").read_text()
    rows = dict(re.findall(r'\{"(\w+)", "(#\w{6})"', table))
    plots = granum._plots
    drawn = [plots._CLOSED_FORM, plots._MEASURED, plots._FORCE, plots._GREY]
    assert drawn == [rows[name] for name in ("closed_form", "measured", "force", "grey")]


def test_the_ladder_shows_errors_and_times(sphere):
    known = {"mechanical_coordination_number": 5.8, "fabric_anisotropy": 0.0}
    ladder = granum.estimate(tolerance=0.05, law=sphere, **STATE, **known)
    shown = {tuple(line.get_xydata()[0]) for line in ladder.plot().lines if line.get_marker() == "o"}
    stated = {(rung.typical_time, 100 * rung.largest_error) for rung in ladder.rungs if rung.largest_error}
    assert shown == stated and len(stated) == 4


def test_the_rose_has_counts_errors_and_the_model(packing, sphere):
    fabric = granum.measure(packing, law=sphere).fabric
    ax = fabric.plot()
    bars = [bar for container in ax.containers if hasattr(container, "patches") for bar in container.patches]
    assert len(bars) == 4 * len(fabric.rose)
    assert bars[0].get_height() == fabric.rose[0].density
    model = ax.lines[-1].get_ydata()
    assert model[90] == granum.fabric_density(polar_angle=np.pi / 2, anisotropy=fabric.likeliest_anisotropy)


def test_chains_inside_of_the_cell_are_drawn(packing):
    (collection,) = packing.plot().collections
    contacts = packing.contacts
    straight = packing.position[contacts.j] - packing.position[contacts.i]
    inside = np.abs(straight - contacts.branch).max(axis=1) < 1e-9
    assert len(collection.get_segments()) == inside.sum() > 0.8 * len(contacts)


def test_the_study_shows_its_results():
    study = granum.verify(
        {
            "study.contacts": ["sphere"],
            "study.densities": ["dense"],
            "study.grains": 60,
            "study.pressures": [20e3, 40e3, 80e3],
            "study.probe_pressures": [40e3],
        }
    )
    ax = study.plot()
    network = [line for line in ax.lines if line.get_linestyle() == "-" and len(line.get_xdata()) == 3]
    np.testing.assert_array_equal(network[0].get_ydata(), study.states["G_vh_network_Pa"] / 1e6)
    labels = [text.get_text() for text in ax.get_legend().get_texts()]
    assert labels == ["closed form", "contact network", "DEM probe"]


def test_the_inference_shows_its_prediction(sphere):
    found = granum.infer(
        law=sphere, radius=0.5e-3, void_ratio=0.6, pressure=100e3, G=150e6, relative_error=0.02
    )
    pressure = np.geomspace(50e3, 200e3, 5)
    line = found.plot(pressure=pressure).lines[0]
    np.testing.assert_array_equal(line.get_ydata(), found.predict("G", pressure=pressure).value / 1e6)


def notebooks(source):
    return sorted((source / "examples" / "notebooks").glob("*.ipynb"))


def test_the_notebooks_reproduce_their_stored_output(source, capsys):
    paths = notebooks(source)
    assert len(paths) == 6
    run = runpy.run_path(str(source / "examples" / "notebooks" / "run.py"))
    code = run["main"](["--check", *map(str, paths)])
    assert code == 0, capsys.readouterr().out


def test_a_notebook_with_other_output_is_found(source, tmp_path):
    path = notebooks(source)[4]
    changed = tmp_path / path.name
    changed.write_text(path.read_text().replace("slope 0.3333", "slope 0.3334"))
    assert changed.read_text() != path.read_text()
    run = runpy.run_path(str(source / "examples" / "notebooks" / "run.py"))
    assert run["main"](["--check", str(changed)]) == 1
    assert sys.modules["matplotlib.pyplot"].get_fignums() == []
