# SPDX-License-Identifier: GPL-3.0-or-later
"""A column is the option of its name, for every command that reads a table, however its heading is spelt."""
import re

import pytest

from written import rows


@pytest.fixture
def read(granum, tmp_path):
    """read(command, table, more words): its JSON; the rows of the table are divided by |."""
    def run(command, table, words="", code=0):
        (tmp_path / "table.csv").write_text(table.replace("|", "\n") + "\n")
        how = "" if command == "fit" else "--table"
        return granum.line(f"{command} {words} --json {how}", tmp_path / "table.csv", code=code)
    return run


PLAIN = "p_kPa,e,V_s_m/s|100,0.6,250"


@pytest.mark.parametrize("heading, value, option, words", [
    ("S_r", "100%", "--saturation 100%", "--grain-shape sand"),
    ("rho_s_kg/m3", "2500", "--grain-density 2500kg/m3", "--grain-shape sand"),
    ("sand", "toyoura", "--sand toyoura", ""),
    ("e_min,e_max", "0.5,0.8", "--least-void-ratio 0.5 --largest-void-ratio 0.8", ""),
])
def test_column_of_a_sand(read, heading, value, option, words):
    """What a table says of the sand counts as the option does, and is no column that is not used."""
    without = read("infer", PLAIN, "--grain-shape sand").json
    by_option = read("infer", PLAIN, f"{words} {option}").json
    by_column = read("infer", PLAIN.replace("|", f",{heading}|") + f",{value}", words).json
    levels = [answer["sand"]["level"]["value"] for answer in (without, by_option, by_column)]
    assert levels[2] == levels[1] != levels[0]
    assert not any(name in note.split(": ")[-1].split(", ") for note in by_column["notes"] for name in heading.split(","))


def test_kinds_of_rows(read):
    """The kind of grains; relative densities and K_0 may differ from row to row."""
    assert read("infer", "p_kPa,e,V_s_m/s,grain_shape|100,0.6,250,sand").json["grain_shape"] == "sand"
    found = read("infer", "sigma'v (kPa),K0,D_r,V_s_m/s|100,0.5,60%,230|200,0.4,70%,280",
                 "--sand toyoura --grain-shape sphere").json
    assert [row["stress_h"] for row in found["measurements"]] == [50000, 80000]


@pytest.mark.parametrize("heading, option, one, other", [
    ("rho_s_kg/m3", "--grain-density", "2600", "2700"), ("sand", "--sand", "toyoura", "nevada"),
    ("grain_shape", "--grain-shape", "sand", "")])
def test_one_material_in_a_table(read, heading, option, one, other):
    said = read("infer", f"p_kPa,e,V_s_m/s,{heading}|100,0.6,250,{one}|200,0.6,300,{other}", code=3).err
    assert ":3:" in said and heading in said and option in said


@pytest.mark.parametrize("table, option, code", [
    (PLAIN, "--unit-weight 18kN/m3", 2), ("depth_m,e,V_s_m/s|-5,0.6,250", "--unit-weight 18kN/m3", 3)])
def test_ground_needs_depths(read, table, option, code):
    read("infer", table, option, code=code)


@pytest.mark.parametrize("stresses", [
    "sigma'v (kPa),sigma'h (kPa)", "σ′v [kPa],σ′h [kPa]", "sigma_v'_kPa,sigma_h'_kPa", "stress v (kPa),stress h (kPa)"])
def test_headings_of_stresses(read, stresses):
    measured = "|100,50,90,0.6|200,100,125,0.6|100,80,100,0.6|300,100,150,0.6"
    inferred = read("infer", f"{stresses},Gmax (MPa),e{measured}", "--grain-shape sand").json
    assert inferred["sand"]["predictions"][0]["stress_v"] == 100000
    read("sweep", f"{stresses},Gmax (MPa),e{measured}", "--grain-shape sand")
    assert 0.3 < read("fit", f"{stresses},G0 [MPa],e{measured}").json["n"] < 0.4
    read("infer", "p′_kPa,e,G_0 [MPa]|100,0.6,100", "--grain-shape sand")


def test_porosity_is_a_void_ratio(read):
    """e = n/(1 - n)"""
    by_e = read("fit", "p_kPa,G_MPa,e|100,90,0.6|200,125,0.25|400,180,0.5625").json["C"]
    by_n = read("fit", "p_kPa,G_MPa,porosity_%|100,90,37.5|200,125,20|400,180,36").json["C"]
    assert by_e == pytest.approx(by_n, rel=1e-11)
    read("fit", "p_kPa,G_MPa,porosity|100,90,37.5|200,125,20|400,180,36", code=3)


def test_one_column_of_the_kind_of_grains(granum, tmp_path):
    """As the table has it and as the answer has it."""
    (tmp_path / "table.csv").write_text("p_kPa,e,grain_shape\n100,0.6,sand\n100,0.6,\n100,0.6,sphere\n")
    granum("sweep", "--table", "table.csv", "--out", "out.csv", at=tmp_path)
    text = (tmp_path / "out.csv").read_text()
    assert [row["grain_shape"] for row in rows(text)] == ["sand", "sphere", "sphere"]
    assert re.findall("^[^#].*", text, re.M)[0].split(",").count("grain_shape") == 1
