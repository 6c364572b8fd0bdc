# SPDX-License-Identifier: GPL-3.0-or-later
"""Studies write these files and no others, keep them without --force, and write the same numbers again with it."""
import json
import re

import pytest

from conftest import ROOT
from written import contents, names, rows, texts

TRADE = ["manifest.json", "report.html", "samples.csv", "trade.csv", "trade.svg"]
VERIFY = ["exponents.csv", "figures", "manifest.json", "report.html", "scene.toml", "states.csv"]
WIDE = "lognormal:0.35"  # sizes of 1:7.4, which need 294 grains


def manifest(folder):
    return json.loads((folder / "manifest.json").read_text())


def test_scene_of_the_examples(granum):
    """It is the scene that the program takes when it is given none, and sets every key that there is."""
    scene = ROOT / "examples/scene.toml"
    assert granum("plan", "--scene", scene, "--json").json["scene"] == granum("plan", "--json").json["scene"]
    keys = re.findall(r"^  ([a-z]+\.[a-z_]+) ", granum("plan", "--help").out, re.M)
    text = scene.read_text()
    assert len(keys) > 20 and [key for key in keys if f"\n{key.split('.')[1]} = " not in text] == []


def test_files_of_verify(granum, tmp_path):
    folder = tmp_path / "out"
    text = ("verify --grains 120 --set study.contacts=sphere --set study.densities=dense --set study.pressures=10kPa,20kPa,40kPa"
            " --set study.probe_pressures=20kPa --out")
    assert granum.line(text, folder).err == ""
    assert names(folder) == VERIFY and manifest(folder)["complete"] is True
    first = contents(folder)
    states = rows(first["states.csv"].decode())
    assert [(row["contact"], row["density"], row["seed"], row["p_Pa"]) for row in states] == [
        ("sphere", "dense", "1", pressure) for pressure in ("10000", "20000", "40000")]
    # kept, also where some are gone
    assert "states.csv" in granum.line(text, folder, code=3).err
    assert contents(folder) == first
    for name in "states.csv", "exponents.csv":
        (folder / name).unlink()
    granum.line(text, folder, code=3)
    assert not (folder / "states.csv").exists()
    granum.line(text, folder, "--force")
    again = contents(folder)
    assert again.keys() == first.keys()
    assert [name for name in first if name.endswith(".csv") and again[name] != first[name]] == []
    # the report is made again from the run
    (folder / "report.html").unlink()
    for file in (folder / "figures").iterdir():
        file.unlink()
    assert granum("verify", "--report", folder).err == ""
    assert contents(folder) == again
    # a manifest that is none is named
    for text in "", "{}", "[1", '{"exponents": [{"contact": "cube", "density": "dense", "contact_law": 0, "network": null}]}':
        (folder / "manifest.json").write_text(text)
        assert "manifest.json" in granum("verify", "--report", folder, code=3).err


# Equal grains: 3 sizes, 3 rates of compression, 3 of shear, 3 time steps, 3 probes and the network; periodic cells of 125
# and 500 grains, and 125 between smooth and rough walls. Unequal ones: 294 for 125 and 250 grains, the fewest of their sizes.
@pytest.mark.parametrize("grains, sizes, count, walls", [(60, "equal", 20, 125), (300, WIDE, 19, 294)])
def test_files_of_trade(granum, tmp_path, grains, sizes, count, walls):
    folder = tmp_path / "out"
    text = (f"trade --quick --grains {grains} --set grain.sizes={sizes} --set study.densities=dense"
            " --set study.pressures=20kPa,40kPa,80kPa --out")
    run = granum.line(text, folder)
    assert ("grain.sizes" in run.err and "1:7.4" in run.err) if sizes == WIDE else run.err == ""
    assert names(folder) == TRADE
    first, result = contents(folder), manifest(folder)
    table, samples = rows(first["trade.csv"].decode()), rows(first["samples.csv"].decode())
    assert result["complete"] is True and len(result["rows"]) == len(table) == count
    assert [(row["varied"], float(row["value"])) for row in table] == [(row["varied"], row["value"]) for row in result["rows"]]
    assert {row["density"] for row in table} == {"dense"} and {row["specimens"] for row in table} == {"2"}
    assert {row["value"] for row in table if "walls" in row["boundary"]} == {str(walls)}
    references = [row for row in table if row["reference"] == "1"]
    assert sorted(row["varied"] for row in references) == sorted({row["varied"] for row in table})
    assert {row["G_bias"] for row in references} == {"0"}
    assert [row for row in samples if row["failure"]] == [] and len([row for row in samples if row["varied"] == "shear"]) == 6
    texts(first["trade.svg"].decode())
    assert "trade.csv" in granum.line(text, folder, code=3).err
    assert contents(folder) == first
    # the picture is drawn again from the table alone; what trade did not write is refused
    (folder / "trade.svg").write_text("another picture")
    granum("trade", "--redraw", folder)
    assert contents(folder) == first
    for column, damage in ("density", ("dense", "dens")), ("G_bias", ("G_bias", "bias_of_G")):
        (folder / "trade.csv").write_text(first["trade.csv"].decode().replace(*damage))
        said = granum("trade", "--redraw", folder, code=3).err
        assert "trade.csv:" in said and column in said


@pytest.mark.parametrize("start, grains, sizes", [("packed", 60, "equal"), ("scattered", 60, "equal"), ("scattered", 300, WIDE)])
def test_deck(granum, tmp_path, start, grains, sizes):
    """Whole, kept, and the same again."""
    folder = tmp_path / "deck"
    text = (f"export lammps --grains {grains} --start {start} --set grain.sizes={sizes} --set study.contacts=sphere"
            " --set study.pressures=10kPa,20kPa,40kPa --set study.probe_pressures=20kPa --json --out")
    run = granum.line(text, folder)
    first = contents(folder)
    assert sorted(run.json["files"]) == sorted(str(folder / name) for name in first)
    assert {"dense-1/in.all", "loose-1/in.all", "dense-1/grains.data", "loose-1/manifest.json"} <= set(first)
    assert f"variable start index {start} " in first["loose-1/scene.lmp"].decode()
    head, atoms = first["dense-1/grains.data"].decode().split("Atoms # sphere\n\n")
    assert f"\n{grains} atoms\n" in head
    diameters = [atom.split()[2] for atom in atoms.strip().split("\n\n")[0].splitlines()]
    assert len(diameters) == grains and len(set(diameters)) == (1 if sizes == "equal" else grains)
    (folder / "dense-1/in.all").unlink()
    granum.line(text, folder, code=3)
    assert not (folder / "dense-1/in.all").exists()
    granum.line(text, folder, "--force")
    assert contents(folder) == first
