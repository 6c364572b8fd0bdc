# SPDX-License-Identifier: GPL-3.0-or-later
"""One state has one answer, to the last digit, whether estimate, a path, a depth, a layer or a row of a table asks for it."""
import pytest

BOTH = """shear_modulus shear_wave_speed compression_wave_speed bulk_modulus young_modulus poisson_ratio horizontal_shear_modulus
    horizontal_shear_wave_speed horizontal_compression_wave_speed horizontal_young_modulus bulk_density
    mechanical_coordination_number vertical_exponent horizontal_exponent stress_exponent""".split()
SPHERES = ["rattler_fraction", "coordination_number"]  # which nobody knows of a sand
STRAINED = "contact_softness strained_shear_modulus modulus_ratio damping_ratio slip_strain pm4sand_coefficient".split()


def states(granum, text, *words, code=0):
    return granum.line(f"sweep --json {text}", *words, code=code).json["states"]


def assert_same(found, expected, fields):
    for field in fields:
        assert found[field] == expected[field], field
        assert "exponent" in field or {"low", "value", "high"} <= set(found[field]), field  # of no stress there is none


def assert_estimated(granum, state, text):
    """The answer of a state is that of estimate, and so are the moduli of both hypotheses where the state has them."""
    estimate = granum.line(f"estimate --json {text}").json
    answer = estimate["answer"]
    sand = answer["grain_shape"] == "sand"
    assert_same(state["answer"], answer, BOTH + (STRAINED if "--strain" in text else [] if sand else SPHERES))
    rungs = {} if sand or "rung2" not in state else {"rung2": "uniform_strain", "uniform_stress": "uniform_stress"}
    for ours, theirs in rungs.items():
        for key in "G_hh G_hv E_v E_h K m n s".split():
            assert state[ours][key] == estimate[theirs]["G_vh" if key == "G_hv" else key] is not None, (ours, key)


@pytest.mark.parametrize("known", [
    "--grain-shape sphere", "--grain-shape sphere --preparation loose", "--rattler-fraction 3%", "--coordination-number 5.1",
    "--mechanical-coordination-number 5.2 --rattler-fraction 2% --contact cone --slope 0.3", "--grain-shape sand --strain 0.02%",
    "--sand toyoura --strain 0.02%"])
def test_path_depth_and_table(granum, tmp_path, known):
    packing = f"--grain quartz --radius 0.2mm --fabric 0.05 {known}"
    state = f"{packing} --void-ratio 0.65"
    found = states(granum, f"{state} --depth 0m..24m --points 5 --water-table 7m --k0 0.5")[1:]  # 6 m is dry, 12 m is not
    found += states(granum, f"{state} --from 80kPa --to 1MPa --points 2")
    found += states(granum, f"{state} --path txc --from 80kPa --eta 0.6 --points 2 --saturation 100%")[1:]
    rows = "e,sigma_v_Pa,sigma_h_Pa,saturation\n"
    for one in found:
        v, h = (one.get(f"stress_{axis}", one.get(f"sigma_{axis}")) for axis in "vh")
        saturation = one["answer"]["saturation"]
        assert_estimated(granum, one, f"{state} --stress-v {v!r}Pa --stress-h {h!r}Pa --saturation {saturation!r}")
        rows += f"0.65,{v!r},{h!r},{saturation}\n"
    assert [one["answer"]["saturation"] for one in found] == [0, 1, 1, 1, 0, 0, 1]
    (tmp_path / "rows.csv").write_text(rows)
    for one, by_table in zip(found, states(granum, packing, "--table", tmp_path / "rows.csv")):
        assert_same(by_table["answer"], one["answer"], BOTH + (STRAINED if "--strain" in known else SPHERES))


def test_rows_of_tables(granum):
    """Whether rows share or give contacts, preparation and sizes."""
    row = states(granum, "--table sweep_states.csv", code=1)  # some of whose rows are refused
    for k, text in {0: "--coordination-number 5.73 --fabric 0.1 --stress-v 200kPa --stress-h 100kPa",
                    1: "--contact cone --slope 0.4 --coordination-number 5.9 --fabric 0 --pressure 100kPa",
                    3: "--fabric 0 --pressure 100kPa",
                    8: "--coordination-number 3.5 --fabric -0.2 --stress-v 50kPa --stress-h 80kPa"}.items():
        assert_estimated(granum, row[k], f"--void-ratio 0.558 {text}")
    row = states(granum, "--table sweep_people.csv --grain quartz")
    for k, text in {0: "--void-ratio 0.65 --stress-v 100kPa --stress-h 50kPa --preparation dense",
                    1: "--void-ratio 0.7 --stress-v 150kPa --stress-h 75kPa --mechanical-coordination-number 5.2",
                    2: "--void-ratio 0.6 --stress-v 200kPa --stress-h 100kPa --uniformity 2",
                    4: "--void-ratio 0.62 --stress-v 80kPa --stress-h 60kPa --preparation friction:0.3"}.items():
        assert_estimated(granum, row[k], f"--grain quartz {text}")


@pytest.mark.parametrize("columns", ["usual", "all"])
def test_empty_fields(granum, tmp_path, columns):
    """A row that leaves fields empty has the answer of a table without these columns, whatever the row before it gives."""
    headings = "a,contact,slope,grain,grain_shear_modulus_GPa,grain_poisson_ratio,radius_mm,saturation,grain_density_kg/m3,C_n"
    (tmp_path / "bare.csv").write_text("e,p_kPa\n0.6,100\n")
    (tmp_path / "empty.csv").write_text(f"e,p_kPa,{headings}\n0.6,100,0.2,cone,0.3,steel,70,0.3,2,1,2700,5\n0.6,100,,,,,,,,,,\n")
    bare, empty = (granum("sweep", "--table", f"{name}.csv", "--columns", columns, at=tmp_path).out.splitlines()[-1]
                   for name in ("bare", "empty"))
    assert empty == bare.replace("0.6,100", "0.6,100,,,,,,,,,,", 1) and len(bare) > 50


@pytest.mark.parametrize("known", ["", "--preparation dense", "--rattler-fraction 3%", "--coordination-number 5.1",
                                   "--mechanical-coordination-number 5.4"])
def test_rungs_of_the_contacts_of_the_answer(granum, known):
    state = "estimate --void-ratio 0.6 --stress-v 200kPa --stress-h 100kPa --json"
    first = granum.line(f"{state} {known}").json
    answer = first["answer"]
    contacts = f"--coordination-number {answer['coordination_number']['value']!r}"
    contacts += f" --mechanical-coordination-number {answer['mechanical_coordination_number']['value']!r}"
    more = known if "preparation" in known else ""  # which knows more than the contacts
    again = granum.line(f"{state} {contacts} {more}").json
    for form in "uniform_strain", "uniform_stress", "relaxed":
        for key in "C11 C33 C12 C13 C44 K G_hh G_vh E_v E_h m n s".split():
            assert first[form][key] == again[form][key] is not None, (form, key)
    fields = "shear_modulus", "horizontal_shear_modulus", "bulk_modulus", "young_modulus"
    assert [first["relaxed"][key] for key in ("G_vh", "G_hh", "K", "E_v")] == [answer[field]["value"] for field in fields]


SOIL = "--unit-weight 15kN/m3 --saturated-unit-weight 18.8kN/m3 --k0 0.5 --sand toyoura"
PLAIN = f"--void-ratio 0.8 {SOIL} --depth 1m..21m --points 5 --water-table 6m"


def of_ground(states):
    return [[state["stress_v"], state["stress_h"], state["pore_pressure"], state["answer"]["shear_modulus"],
             state["answer"]["compression_wave_speed"], state["answer"]["stress_exponent"]] for state in states]


def test_layers(granum, tmp_path):
    """One layer is level ground; so are the first metres of three, below which the weights add up."""
    plain = states(granum, PLAIN)
    (tmp_path / "one.csv").write_text("top_m,e\n0,0.8\n")
    one = states(granum, f"{SOIL} --depth 1m..21m --points 5 --water-table 6m", "--layers", tmp_path / "one.csv")
    assert of_ground(one) == of_ground(plain)
    three = states(granum, "--layers layers.csv --depth 1m..21m --points 5 --water-table 6m")
    assert of_ground(three[:1]) == of_ground(plain[:1])
    # 4 m of 15 and 2 m of 16 kN/m3, then 4 m of 19.3 in water of 998 kg/m3
    ends = states(granum, "--layers layers.csv --depth 6m..10m --points 2 --water-table 6m")
    assert [end["stress_v"] for end in ends] == pytest.approx([92e3, 92e3 + 4 * (19.3e3 - 998 * 9.80665)], rel=1e-9)


def test_water_table_of_layers(granum, tmp_path):
    """As a column, of any row, it is the option; a second one is refused with its line."""
    (tmp_path / "wet.csv").write_text("top_m,e,unit_weight_kN/m3,saturated_unit_weight_kN/m3,k0,sand,water_table_m\n"
                                      "0,0.80,15,18.8,0.5,toyoura,\n4,0.72,16,19.3,0.45,hostun,6\n10,0.65,17,20,0.4,,\n")
    span = "--depth 1m..21m --points 4"
    by_column = states(granum, span, "--layers", tmp_path / "wet.csv")
    by_option = states(granum, f"--layers layers.csv {span} --water-table 6m")
    assert of_ground(by_column) == of_ground(by_option)
    (tmp_path / "two.csv").write_text("top_m,e,water_table_m\n0,0.80,3\n4,0.72,6\n")
    assert "two.csv:3:" in granum.line(f"sweep {span} --layers", tmp_path / "two.csv", code=3).err


def test_rows_with_their_own_ground(granum, tmp_path):
    (tmp_path / "sites.csv").write_text("site,depth_m,e,unit_weight_kN/m3,saturated_unit_weight_kN/m3,water_table_m,k0,sand\n"
                                        "A,6,0.8,15,18.8,6,0.5,toyoura\nB,11,0.8,15,18.8,6,0.5,toyoura\nC,11,0.7,17,,,,\n")
    sites = states(granum, "", "--table", tmp_path / "sites.csv")
    plain = states(granum, PLAIN)
    third = states(granum, "--void-ratio 0.7 --unit-weight 17kN/m3 --depth 11m..12m --points 2")
    assert of_ground(sites) == of_ground([plain[1], plain[2], third[0]])
