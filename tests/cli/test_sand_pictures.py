# SPDX-License-Identifier: GPL-3.0-or-later
"""Which answers and published laws are in pictures, and reports as a client reads them: what was asked, the answer,
assumptions and sources, and a way from each citation to its source."""
import datetime
import re

import pytest

from written import texts

LAWS = "published laws"
SAND = "sweep --points 3 --void-ratio 0.7 --grain-shape sand"
PATH = "--from 50kPa --to 400kPa"
STATE = "estimate --void-ratio 0.7 --pressure 100kPa"
STRAINED = f"{STATE} --strain 0.01%"


@pytest.mark.parametrize("text, there, absent", [
    *[(f"{SAND} {path}", [], [LAWS]) for path in (PATH, "--depth 1m..20m", "--path txc --from 100kPa --eta 0.6")],
    *[(f"{SAND} {path} --laws", [LAWS], []) for path in (PATH, "--depth 1m..20m", "--path txc --from 100kPa --eta 0.6")],
    (f"{SAND} {PATH} --laws --picture-of K", [], [LAWS]),
    # where nothing says what the grains are both are named in the picture
    (f"sweep --points 3 --void-ratio 0.7 {PATH} --laws", ["sand", "beads", LAWS], ["answer"]),
    (f"sweep --points 3 --void-ratio 0.7 {PATH}", ["sand", "beads"], ["answer", LAWS]),
    (f"{SAND} {PATH} --laws", ["answer"], ["beads"]),
    ("sweep --table rows.csv --laws", ["sand", "beads", LAWS], ["answer"]),
    ("sweep --table rows.csv", ["sand", "beads"], ["answer", LAWS]),
    ("sweep --table rows.csv --grain-shape sand", ["answer"], ["beads"]),
    # estimate draws around its state: over strain with each law of it, else over stress
    (STRAINED, ["shear strain [%]", "darendeli", "menq", "ishibashi-zhang", "range"], ["p' [kPa]"]),
    (STATE, ["p' [kPa]", "sand (measured laws)", "beads (spheres of the model)"], ["darendeli"]),
    (f"{STATE} --grain-shape sand", ["p' [kPa]"], ["darendeli", "beads (spheres of the model)"]),
])
def test_names_in_a_picture(granum, tmp_path, text, there, absent):
    (tmp_path / "rows.csv").write_text("e,p_kPa\n0.65,50\n0.7,100\n")
    granum.line(f"{text} --picture p.svg", at=tmp_path)
    drawn = texts((tmp_path / "p.svg").read_text())
    drawn += [LAWS for text in drawn if text.startswith(LAWS)]
    assert set(there) <= set(drawn) and not set(absent) & set(drawn)


def test_ends_of_a_picture(granum, tmp_path):
    """The lines of estimate begin and end with the answers at the ends of their axes."""
    for text, name, ends, field in [
            (STRAINED, "answer", {1e-4: "--strain 0.0001% --pressure 100kPa", 0.5: "--strain 0.5% --pressure 100kPa"},
             "strained_shear_modulus"),
            (f"{STATE} --grain-shape sand", "answer", {10: "--pressure 10kPa", 1000: "--pressure 1MPa"}, "shear_modulus")]:
        granum.line(text, "--picture", tmp_path / "p.svg", "--force")
        line = re.search(rf"; {name}: (\S+) at (\S+), (\S+) at ([^;\"]+)", (tmp_path / "p.svg").read_text())
        drawn = {float(x): float(y) for y, x in (line.group(1, 2), line.group(3, 4))}
        assert list(drawn) == list(ends)
        for x, state in ends.items():
            found = granum.line(f"estimate --void-ratio 0.7 --grain-shape sand --json {state}").json["answer"][field]["value"]
            assert drawn[x] == pytest.approx(found / 1e6, rel=6e-3)


@pytest.fixture
def report(granum, tmp_path):
    """A page; each of its citations leads to a source, each source has a row."""
    def today():
        now = datetime.datetime.now(datetime.timezone.utc)
        return f"{now.day} {now:%B %Y}"

    def ask(text):
        page, before = tmp_path / "page.html", today()
        granum.line(text, "--report", page, "--force")
        text = page.read_text()
        assert before in text or today() in text
        ids = re.findall(r'id="([A-Za-z0-9]+)"', text)
        cited = re.findall(r'href="#([A-Za-z0-9]+)"', text)
        assert len(ids) == len(set(ids)) and cited and set(cited) <= set(ids)
        assert {"asked", "assumptions", "sources"} <= set(ids) and "</svg>" in text and text.endswith("</html>\n")
        for fault in "from memory", "not found in", "otechnique'", "nan":
            assert not re.search(rf"\b{fault}\b", text), fault
        return text
    return ask


def test_report_of_depths(granum, report):
    text = "sweep --depth 0m..30m --points 7 --sand toyoura --relative-density 60% --water-table 2m --k0 0.5"
    page = report(text)
    deepest = granum.line(f"{text} --json").json["states"][6]
    assert deepest["depth"] == 30
    for value in deepest["answer"]["shear_modulus"]["value"] / 1e6, (deepest["stress_v"] + 2 * deepest["stress_h"]) / 3e3:
        assert f"{value:.4g}" in page
    assert '<td class="number">60%</td>' in page  # as typed


def test_report_of_a_path(report):
    page = report(f"sweep --void-ratio 0.6 {PATH} --points 3")
    assert "G_hv_rung3_" in page and "<td>--from</td>" in page


def test_report_of_a_state(granum, report):
    state = "estimate --relative-density 60% --uniformity 8 --d50 4mm --pressure 100kPa"
    page = report(state)
    modulus = granum.line(f"{state} --json").json["answer"]["shear_modulus"]
    low, value, high = (modulus[part] / 1e6 for part in ("low", "value", "high"))
    for shown in low, value, high, low**2 / value, high**2 / value:  # to one and two standard deviations
        assert f"{shown:.4g}" in page
    for cell in '<td class="number">4mm</td>', '<th class="number">bias</th>', '<a href="#WangStokoe2022">':
        assert cell in page
    assert "C_u of 9" in report(f"{STATE} --uniformity 9")


@pytest.mark.parametrize("text", [STATE, f"{SAND} {PATH}"])
def test_report_is_kept(granum, tmp_path, text):
    page = tmp_path / "page.html"
    page.write_text("mine")
    granum.line(text, "--report", page, code=3)
    assert page.read_text() == "mine"
    granum.line(text, "--report", tmp_path / "page.pdf", code=2)
    assert not (tmp_path / "page.pdf").exists()
