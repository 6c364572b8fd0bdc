# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables and pictures of sweep, infer, fit and estimate: two files or none, kept or replaced, and the numbers of JSON in them."""
import pytest

from written import names, rows, texts

CONE = "--contact cone --slope 0.3 --void-ratio 0.56 --fabric 0.2 --coordination-number 4.5"
PATH = f"sweep {CONE} --from 10kPa --to 1MPa --points 9"
SPHERES = "--grain-shape sphere --grain quartz --radius 0.2mm --void-ratio 0.65 --fabric 0.05 --preparation loose"
DEPTHS = f"sweep {SPHERES} --depth 0m..24m --points 5 --unit-weight 18kN/m3 --water-table 5m --k0 0.5"
GLASS = "infer --porosity 0.38 --grain-shear-modulus 29GPa --grain-poisson-ratio 0.2 --grain-density 2480kg/m3"
SPEED = f"{GLASS} --pressure 2.76MPa --vs 587m/s+-1% --predict-pressure 6.89MPa,34.47MPa"


@pytest.mark.parametrize("command, more, title", [
    (PATH, "--picture-of s", "s"), (DEPTHS, "--columns all", "V_p [m/s]"), (SPEED, "", "V_s [m/s]")])
def test_two_files_or_none(granum, tmp_path, command, more, title):
    table, picture = tmp_path / "x.csv", tmp_path / "x.svg"
    files = "--out", table, "--picture", picture
    granum.line(command, *files)
    assert names(tmp_path) == ["x.csv", "x.svg"]
    texts(picture.read_text())
    table.unlink()
    picture.write_text("an old picture")
    assert "x.svg" in granum.line(command, *files, code=3).err
    assert names(tmp_path) == ["x.svg"] and picture.read_text() == "an old picture"
    granum.line(f"{command} {more} --force", *files)
    assert names(tmp_path) == ["x.csv", "x.svg"] and title in texts(picture.read_text())
    # a picture needs no other file
    alone = granum.line(command, "--picture", tmp_path / "alone.svg")
    assert len(alone.out) > 200 and names(tmp_path) == ["alone.svg", "x.csv", "x.svg"]
    granum.line(command, "--picture", picture, code=3)
    granum.line(f"{command} --force", "--picture", picture)
    assert picture.read_bytes() == (tmp_path / "alone.svg").read_bytes()


def draw(granum, tmp_path, text):
    granum.line(text, "--picture", tmp_path / "picture.svg", "--force")
    return (tmp_path / "picture.svg").read_text()


@pytest.mark.parametrize("text, drawn, count", [
    (PATH, ["p' [kPa]", "G_hv [MPa]", "answer", "range"], 10),  # nine states of rung 0, and its legend
    ("sweep --table sweep_few.csv", ["p' [kPa]", "beads, range"], 4),  # three rows, and its legend
    (DEPTHS, ["depth [m]", "G [MPa]", "V_s [m/s]", "V_p [m/s]", "stress [kPa]"], 0),
    (SPEED, ["V_s [m/s]", "measured", "predicted", "fit"], None)])
def test_pictures(granum, tmp_path, text, drawn, count):
    svg = draw(granum, tmp_path, text)
    assert set(drawn) <= set(texts(svg)) and count in (None, svg.count("<circle"))


def test_picture_of_a_fit(granum, tmp_path):
    """With its law and the slopes of cones and spheres; s is that of the fit."""
    for table, s in ("isotropic_by_hand.csv", "0.349"), ("hv_dense_cone.csv", "0.510"):
        drawn = texts(draw(granum, tmp_path, f"fit {table}"))
        assert f"{granum('fit', table, '--json').json['s']:.3f}" == s and any(f"s = {s}" in text for text in drawn)
        assert any(text.endswith("cone") and "0.500" in text for text in drawn), table
        assert any(text.endswith("sphere") and "0.333" in text for text in drawn), table


USUAL = """depth_m,total_sigma_v_kPa,total_sigma_h_kPa,pore_pressure_kPa,sigma_v_kPa,sigma_h_kPa,p_kPa,G_answer_MPa,G_low_MPa,
G_high_MPa,V_s_answer_m/s,V_s_low_m/s,V_s_high_m/s,V_p_answer_m/s,V_p_low_m/s,V_p_high_m/s,z_star_answer,z_star_low,z_star_high,
s_answer,s_low,s_high""".replace("\n", "").split(",")


def table(granum, tmp_path, text):
    granum.line(text, "--out", tmp_path / "table.csv", "--force")
    return rows((tmp_path / "table.csv").read_text())


def test_columns_of_depths(granum, tmp_path):
    usual, every = (table(granum, tmp_path, f"{DEPTHS} --columns {which}") for which in ("usual", "all"))
    columns = list(usual[0])
    assert columns[:22] == USUAL and columns[-3:] == ["notes", "error", "grain_shape"]
    assert {usual[0][column] for column in USUAL[:13]} == {"0"}  # the surface
    assert {"K_answer_MPa", "G_hh_high_MPa", "density_low_kg/m3", "rattlers_answer"} <= set(every[0])
    assert [{column: row[column] for column in row if column in columns} for row in every] == usual
    assert [column for column in every[0] if column in columns] == columns


def test_numbers_of_depths(granum, tmp_path):
    """In exact SI the CSV has the numbers of the JSON."""
    for row, state in zip(table(granum, tmp_path, f"{DEPTHS} --units si"), granum.line(f"{DEPTHS} --json").json["states"]):
        answer = state["answer"]
        assert float(row["sigma_v_Pa"]) == state["stress_v"]
        for column, field in [("G_{}_Pa", "shear_modulus"), ("V_s_{}_m/s", "shear_wave_speed"),
                              ("V_p_{}_m/s", "compression_wave_speed")]:
            assert [float(row[column.format(part)]) for part in ("answer", "low", "high")] == \
                [answer[field][part] for part in ("value", "low", "high")]


def test_a_sweep_is_fitted(granum, tmp_path):
    """G ~ p^(1/2) of cones"""
    granum.line(f"{PATH} --units si", "--out", tmp_path / "iso.csv")
    fitted = granum("fit", tmp_path / "iso.csv", "--modulus-column", "G_hv_rung2", "--sum-only", "--json").json
    assert fitted["s"] == pytest.approx(0.5, abs=1e-8)


def test_table_of_an_inference(granum, tmp_path):
    """A measurement and two predictions of sand, then of spheres, which are those of the JSON."""
    answer = granum.line(f"{SPEED} --json").json
    found = table(granum, tmp_path, SPEED)
    assert [(row["kind"], row["grain_shape"]) for row in found] == [
        (kind, shape) for shape in ("sand", "sphere") for kind in ("measured", "predicted", "predicted")]
    for row, prediction in zip(found[1:3] + found[4:], answer["sand"]["predictions"] + answer["predictions"]):
        for column, field in {"G{}_Pa": "G", "K{}_Pa": "K", "V_s{}_m/s": "V_s", "V_p{}_m/s": "V_p"}.items():
            assert float(row[column.format("")]) == prediction[field]["value"]
            assert float(row[column.format("_error")]) == prediction[field]["standard_error"]
    assert float(found[5]["z_star"]) == answer["predictions"][1]["mechanical_coordination_number"]["value"]


def test_a_borehole(granum, tmp_path):
    """Speeds that sweep has at these depths give level 1 back, with the water table at 3 m, a surcharge and K_0."""
    ground = "--unit-weight 18kN/m3 --water-table 3m --surcharge 12kPa --k0 0.45 --sand toyoura"
    (tmp_path / "depths.csv").write_text("depth_m,e\n1,0.78\n4,0.75\n9.5,0.72\n")
    swept = rows(granum.line(f"sweep {ground} --units si --table", tmp_path / "depths.csv").out)
    states = granum.line(f"sweep {ground} --json --table", tmp_path / "depths.csv").json["states"]
    (tmp_path / "borehole.csv").write_text("depth_m,e,V_s_m/s,V_s_error_m/s\n" + "".join(
        f"{row['depth_m']},{row['e']},{row['V_s_answer_m/s']},3\n" for row in swept))
    sand = granum.line(f"infer {ground} --predict-pressure 200kPa --json --table", tmp_path / "borehole.csv").json["sand"]
    assert sand["level"]["value"] == pytest.approx(1, abs=1e-7) and sand["chi_square"] < 1e-9
    for key in "stress_v", "stress_h":
        assert [row[key] for row in sand["measurements"]] == [state[key] for state in states]
    assert [row["depth"] for row in sand["measurements"]] == [1, 4, 9.5]
