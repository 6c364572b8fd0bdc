# SPDX-License-Identifier: GPL-3.0-or-later
"""What each command ends with at each event. docs/architecture.md says which event has which exit code. A run that failed says
why; one that went well or was stopped does not speak of an error."""
import shutil
import subprocess

import pytest

from conftest import CLI, DATA

STATE = "--void-ratio 0.6 --pressure 100kPa"
PATH = "--void-ratio 0.6 --from 50kPa --to 200kPa --points 3"
CHAIN = "lammps_chain.atoms lammps_chain.contacts"
SMALL = ("--grains 80 --seeds 1 --set study.contacts=sphere --set study.pressures=20kPa,40kPa,60kPa"
         " --set study.probe_pressures=")
DENSE = f"{SMALL} --set study.densities=dense"
SHORT = f"{DENSE} --set shear.paths=TXC --set shear.largest_strain=0.001"
QUICK = "--quick --grains 60 --set study.densities=dense"
LONG = "--grains 20000 --set study.contacts=sphere --threads 1"
JAMMED = f"{SMALL} --set specimen.unjamming_strain=1e-9"

# Command: what it does well, how a file is read, and what is refused.
USUAL = {
    "estimate": (STATE, f"{STATE} --sieve", "--void-ratio 0.6 --pressure -1kPa"),
    "infer": (f"{STATE} --vs 280m/s", "--void-ratio 0.6 --table", f"{STATE} --vs -280m/s"),
    "sweep": (PATH, "--void-ratio 0.6 --table", f"{PATH} --points 1"),
    "fit": ("fit.csv --sum-only", "", "fit.csv --sum-only --atmospheric-pressure 0kPa"),
    "analyse": (CHAIN, "", f"{CHAIN} --grain-shear-modulus -1GPa"),
    "verify": (f"{SMALL} --json", "--scene", "--grains 0"),
    "plan": (SMALL, "--scene", f"{SMALL} --error 0"),
    "reproduce": (f"{SHORT} --out reproduced", "--scene", "--grains 0"),
    "trade": (f"{QUICK} --json", "--scene", "--seeds 1"),
    "export lammps": (f"{DENSE} --out deck", "--out new --scene", f"{DENSE} --grains 0 --out bad"),
}
FILES = ["estimate", "infer", "sweep", "fit", "plan"]  # which write one file; others a folder
STUDIES = ["verify", "reproduce", "trade", "export lammps"]
ENDLESS = {"verify": LONG, "reproduce": f"{LONG} --set shear.paths=TXC", "trade": f"{QUICK} --seeds 900",
           "export lammps": LONG.replace("--set study", "--set study.densities=dense --set study")}


def without_output(command):
    return USUAL[command][0].partition(" --out")[0].removesuffix(" --json")


def rows():
    for command, (good, reads, bad) in USUAL.items():
        start = without_output(command)
        yield 0, command, "ok", good
        yield 2, command, "bad argument", bad
        yield 2, command, "unknown option", f"{start} --no-such-option"
        for event, name in [("missing", "no-such-file.csv"), ("unreadable", "folder"), ("damaged", "damaged.gz")]:
            yield 3, command, f"{event} file", f"{reads} {name}"
        if command in FILES:
            yield 3, command, "no folder for output", f"{start} --out no-such-folder/out"
            yield 3, command, "output is a folder", f"{start} --out folder --force"
            yield 3, command, "full device", f"{start} --out full"
            yield 3, command, "existing output", f"{start} --out existing"
            yield 0, command, "existing output, --force", f"{start} --out replaced --force"
        else:
            yield 3, command, "output is a file", f"{start} --out existing"
            yield 3, command, "output within a file", f"{start} --out existing/inside"
            yield 3, command, "existing output", f"{start} --out holds-{'deck' if 'export' in command else 'report'}"
        if command in [*STUDIES, "plan"]:
            yield 4, command, "likely slip, --strict", f"{start} --set grain.radius=0.4m --strict" + (
                " --out new" if "export" in command else "")
    for command in STUDIES:
        for signal, code in [("INT", 130), ("TERM", 143), ("HUP", 129)]:
            yield code, command, f"stopped by {signal}", ENDLESS[command]


# Exit code, command, event, arguments: what only some commands have.
MORE = [
    (0, "estimate", "outside validity", f"{STATE} --coordination-number 13"),
    (4, "estimate", "outside validity, --strict", f"{STATE} --coordination-number 13 --strict"),
    (3, "infer", "existing picture", f"{STATE} --vs 280m/s --picture existing.svg"),
    (1, "infer", "all rows failed", f"{STATE} --vs 5000m/s"),
    (4, "infer", "outside validity, --strict", "--void-ratio 0.6 --pressure 1GPa --vs 1500m/s --strict"),
    (0, "sweep", "table ok", "--void-ratio 0.6 --table rows.csv"),
    (1, "sweep", "some rows failed", "--void-ratio 0.6 --table bad-row.csv"),
    (1, "sweep", "all rows failed", "--void-ratio 0.6 --table bad-rows.csv"),
    (4, "sweep", "outside validity, --strict", f"{PATH} --coordination-number 13 --strict"),
    (3, "sweep", "existing output at depths", "--void-ratio 0.6 --depth 1m..20m --out existing"),
    (0, "sweep", "depths ok", "--void-ratio 0.6 --depth 1m..20m"),
    (1, "sweep", "some depths failed", "--void-ratio 0.6 --depth 1m..20m --grain-shape sphere --preparation dense:50kPa"),
    (2, "fit", "no file given", ""),
    (3, "fit", "existing picture", "fit.csv --sum-only --picture existing.svg"),
    (3, "fit", "damaged row", "bad-fit.csv"),
    (4, "fit", "outside validity, --strict", "shear.csv --modulus-column G_hv --sum-only --strict"),
    (2, "analyse", "no such frame", f"{CHAIN} --frames 7"),
    (2, "analyse", "another box than the files", f"{CHAIN} --box 3mm,3mm,3mm"),
    (2, "analyse", "another axis than x, y, z", f"{CHAIN} --axis w"),
    (2, "analyse", "units that are not SI", f"{CHAIN} --units lj"),
    (3, "analyse", "no such file of stresses", f"{CHAIN} --stress no-such-file.csv"),
    (0, "analyse", "existing output, --force", f"{CHAIN} --out replaced-report --force"),
    (4, "analyse", "a warning, --strict", f"{CHAIN} --strict"),
    (1, "verify", "a finding differs, --strict", f"{SMALL} --set study.contacts=cone --json --strict"),
    (3, "verify", "a folder in a file's place", f"{SMALL} --out blocked --force"),
    (3, "verify", "no earlier run", "--report folder"),
    (4, "verify", "not converged", f"{JAMMED} --json"),
    (1, "reproduce", "a finding differs, --strict", f"{SHORT} --out strict --strict"),
    (3, "reproduce", "a folder in a file's place", f"{SHORT} --out blocked-checkpoints --force"),
    (3, "reproduce", "no earlier run", "--resume folder"),
    (4, "reproduce", "not converged", f"{JAMMED} --set shear.paths=TXC --out jammed"),
    (1, "trade", "some samples failed", f"{QUICK},loose --set specimen.unjamming_strain=1e-9 --json"),
    (3, "trade", "no earlier run", "--redraw folder"),
    (4, "trade", "not converged", f"{QUICK.replace('dense', 'loose')} --set specimen.unjamming_strain=1e-9 --json"),
    (2, "export", "no code named", ""),
    (2, "export lammps", "no output", ""),
    (0, "export lammps", "existing output, --force", f"{DENSE} --out replaced-deck --force"),
    (4, "export lammps", "not converged", f"{JAMMED} --set study.densities=loose --out jammed-deck"),
]
ALL = [*rows(), *MORE]


@pytest.fixture
def folder(tmp_path):
    for name in ["folder", "holds-report", "holds-deck/dense-1", "replaced-report", "replaced-deck/dense-1", "blocked/states.csv",
                 "blocked-checkpoints"]:
        (tmp_path / name).mkdir(parents=True)
    for name in ["existing", "existing.svg", "replaced", "blocked-checkpoints/checkpoints"] + [
            f"{state}-{what}" for state in ["holds", "replaced"]
            for what in ["report/report.html", "report/trade.csv", "deck/dense-1/manifest.json"]]:
        (tmp_path / name).write_text("kept\n")
    (tmp_path / "full").symlink_to("/dev/full")
    (tmp_path / "damaged.gz").write_bytes(b"\x1f\x8b\x08 is no compressed file")
    for name, pressures in {"rows": (100, 200), "bad-row": (100, -200), "bad-rows": (-100, -200)}.items():
        (tmp_path / f"{name}.csv").write_text("p_kPa\n" + "".join(f"{p}\n" for p in pressures))
    shutil.copy(DATA / "isotropic.csv", tmp_path / "fit.csv")
    (tmp_path / "bad-fit.csv").write_text((DATA / "isotropic.csv").read_text().replace(",10,10,", ",10,-10,"))
    shutil.copy(DATA / "hv_dense_cone.csv", tmp_path / "shear.csv")
    for name in CHAIN.split():
        shutil.copy(CLI.parent / "io/data" / name, tmp_path)
    return tmp_path


@pytest.mark.parametrize(("code", "command", "event", "text"), ALL, ids=[f"{row[1]}: {row[2]}" for row in ALL])
def test_exit_code(granum, folder, code, command, event, text):
    words = [*command.split(), *text.split()]
    if event.startswith("stopped"):
        done = subprocess.run([CLI / "stop_when.sh", "stopped", event[-4:].strip(), granum.path, *words, "--out", "stopped"],
                              cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        assert done.returncode == code, done.stderr
        said = done.stderr
    else:
        said = granum(*words, code=code, at=folder, timeout=300).err
    assert any(line.startswith("granum: error: ") for line in said.split("\n")) == (0 < code < 128), said
