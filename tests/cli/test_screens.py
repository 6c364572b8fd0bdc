# SPDX-License-Identifier: GPL-3.0-or-later
"""What a terminal shows: lines of at most 80 characters, a short first answer, help in groups, and manual pages of it."""
import re
import shutil
import subprocess

import pytest

from conftest import DATA, ROOT

COMMANDS = ["estimate", "infer", "sweep", "fit", "analyse", "verify", "plan", "reproduce", "trade", "export lammps"]


def assert_narrow(text):
    assert [line for line in text.splitlines() if len(line) > 80] == []


# one option of each group, in the order of the groups
@pytest.mark.parametrize("command, first", [
    ("estimate", "--void-ratio --coordination-number --grain --contact --sieve --bounds --out"),
    ("infer", "--shear-modulus --void-ratio --fabric --grain --contact --sieve --unit-weight --predict-pressure --out"),
    ("sweep", "--depth --void-ratio --coordination-number --grain --contact --sieve --for --eta --unit-weight --columns --out"),
    ("fit", "--modulus-column --sum-only --out"), ("analyse", "--grain-density --law --column-map --window --out"),
    ("verify", "--scene --report --out"), ("plan", "--scene --error --out"), ("reproduce", "--scene --resume --out"),
    ("trade", "--scene --quick --redraw --out"), ("export lammps", "--scene --start --out"),
])
def test_help(granum, command, first):
    """All options are in groups; the last group is that of the output."""
    run = granum.line(f"{command} --help")
    assert_narrow(run.out)
    assert run.err == ""
    groups = re.split("^[A-Z][A-Za-z ]*:$", run.out, flags=re.M)[1:]
    found = [options for options in (re.findall(r"^  (?:-\w, )?(--[a-z0-9-]+)", group, re.M) for group in groups) if options]
    every = [option for group in found for option in group]
    assert len(every) == len(set(every))
    places = [next(k for k, group in enumerate(found) if option in group) for option in first.split()]
    assert places == list(range(len(found)))
    assert {"--out", "--json", "--force", "--strict"} <= set(found[-1])


def test_help_of_the_program(granum):
    text = granum("--help").out
    assert_narrow(text)
    assert re.findall(r"^  ([a-z]+)  ", text, re.M) == [command.split()[0] for command in COMMANDS]


CHAIN = "analyse lammps_chain.atoms lammps_chain.contacts"
SMALL = "--grains 120 --set study.pressures=10kPa,20kPa,40kPa --set study.probe_pressures=20kPa"


@pytest.mark.parametrize("text", [
    f"{CHAIN} --grain-shear-modulus 30GPa", f"{CHAIN} --frames 0 --stress 367.6Pa,0Pa,1049.7Pa,178.6Pa,0Pa,0Pa",
    "analyse lammps_box.atoms lammps_box.contacts --no-network --window ..,..,1mm..3mm",
    "analyse lammps_types.atoms lammps_types.contacts", "analyse analyse_chain_contacts.csv",
    "analyse analyse_lattice.grains analyse_lattice.contacts --grain-density 2650kg/m3",
    "analyse yade_lognormal_dense.grains.gz yade_lognormal_dense.contacts.gz --grain-density 2650kg/m3",
    "estimate --void-ratio 0.6 --pressure 100kPa --bounds --tolerance 5%",
    "estimate --void-ratio 0.6 --stress-v 200kPa --stress-h 100kPa --saturation 100% --uniformity 1.5 --bounds",
    "sweep --void-ratio 0.6 --depth 0m..30m --water-table 2m", "sweep --void-ratio 0.6 --depth 0m..3000m",
    "infer --void-ratio 0.6 --pressure 100kPa --vs 280m/s+-2% --predict-pressure 50kPa,400kPa",
    "infer --void-ratio 0.6 --stress-v 200kPa --stress-h 100kPa --vs 280m/s",
    "export lammps --grains 60 --start scattered --seeds 4 --set study.contacts=sphere --out export",
    "fit hv_dense_cone.csv", "fit isotropic_by_hand.csv", "plan --grains 200", "plan --error 2%", f"verify {SMALL} --out verify",
    "trade --quick --grains 60 --set study.densities=dense --set study.pressures=20kPa,40kPa,80kPa --out trade",
    f"reproduce {SMALL} --set study.contacts=sphere --set study.densities=dense --set shear.paths=TXC,RTXE"
    " --set shear.inertial_number=5e-4 --set shear.largest_strain=0.002 --set shear.strain_step=0.0005 --out reproduce",
])
def test_width(granum, tmp_path, text):
    """In a folder with copies, as a long name of a folder cannot be broken."""
    for folder in DATA, ROOT / "tests/io/data", ROOT / "examples/data":
        for file in folder.iterdir():
            if file.name in text.split():
                shutil.copy(file, tmp_path)
    run = granum.line(text, at=tmp_path, code=None)
    assert run.code in (0, 1) and len(run.out) >= 200, run
    assert_narrow(run.out)


@pytest.mark.parametrize("stress", ["--pressure 100kPa", "--pressure 123456kPa", "--pressure 0kPa", "--stress-v 200kPa --k0 0.5"])
@pytest.mark.parametrize("grains", [
    "", "--grain-shape sand", "--grain-shape sphere --preparation dense", "--sand toyoura --strain 0.1%",
    "--fabric 0.1 --saturation 100%", "--coordination-number 5.2 --rattler-fraction 2%", "--uniformity 2 --grain-shape sphere"])
def test_first_screen(granum, stress, grains):
    """16 lines at most, each of whose numbers is on the full screen too."""
    text = f"estimate --void-ratio 0.65 {stress} {grains}"
    first, full = granum.line(text).out, granum.line(f"{text} --full").out
    assert len(first.splitlines()) <= 16
    assert_narrow(first)
    assert [number for number in re.findall(r"\d+\.\d+", first) if number not in full] == []


@pytest.fixture
def pages(pytestconfig):
    return (pytestconfig.getoption("--reference") or pytest.skip("--reference is not given")) / "man1"


@pytest.mark.parametrize("command", ["", *COMMANDS, "export"])
def test_manual_page(granum, pages, command):
    """It has all options of help; groff and mandoc find no fault. Pages have no date, so that every build makes the same."""
    page = pages / ("-".join(["granum", *command.split()]) + ".1")
    text = page.read_text().replace("\\-", "-")
    options = re.findall(r"^  (--[a-z0-9-]+)", granum.line(f"{command} --help").out, re.M)
    assert [option for option in options if not re.search(rf"[^a-z-]{option}[^a-z-]", text)] == []
    assert "\n.SH NAME\n" in text and len(list(pages.iterdir())) == len(COMMANDS) + 2  # with those of granum and export
    for reader in "groff -ww -man -Tutf8 -z", "mandoc -T lint -W warning":
        if shutil.which(reader.split()[0]):
            said = subprocess.run([*reader.split(), page], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True).stdout
            assert [fault for fault in said.splitlines() if "missing date" not in fault] == []
