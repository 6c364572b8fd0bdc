# SPDX-License-Identifier: GPL-3.0-or-later
"""One call of the system after the other fails. Either the program says of which file and why, ends with 3, and no file that
it writes is there in part, or all it answers and writes is as without the fault. Never an answer from a part of a file."""
import gzip
import os
import pathlib
import shutil
from collections import Counter
from errno import EINTR, EIO, ENOSPC

import pytest

from conftest import DATA, ROOT
from written import contents, without_times

CHAIN = ROOT / "tests/io/data/lammps_chain.atoms", ROOT / "tests/io/data/lammps_chain.contacts"
SMALL = ("--seeds 1 --threads 1 --set study.contacts=sphere --set study.densities=dense --set study.pressures=20kPa,40kPa,60kPa"
         " --set study.probe_pressures= --grains 40")
FAULTS = {"EIO": EIO, "ENOSPC": ENOSPC, "EINTR": EINTR, "short": 0}


def same(a, b):
    return a == b or without_times(a) == without_times(b)


class Disk:
    """A folder whose files are read and written through calls that fail: in/ has inputs, out/ what is there before a run."""

    def __init__(self, granum, folder, env, most):
        self.granum, self.folder, self.most = granum, folder / "disk", most
        self.before, self.fired = folder / "before", folder / "fired"
        self.env = {**env, "GRANUM_TEST_FOLDER": str(self.folder), "GRANUM_TEST_FIRED": str(self.fired)}
        given = self.before / "in"
        given.mkdir(parents=True)
        (self.before / "out").mkdir()
        for name in "sieve.csv", "layers.csv", "isotropic.csv", "analyse_states.csv", "scene_small.toml", *CHAIN:
            shutil.copy(DATA / name, given)
        (given / "packed.gz").write_bytes(gzip.compress(CHAIN[1].read_bytes()))
        lines = (given / "isotropic.csv").read_text().splitlines(keepends=True)  # many reads long, with rows at both ends
        (given / "long.csv").write_text("".join([*lines[:5], *30000 * ["# a comment between the rows\n"], *lines[5:]]))
        (given / "speeds.csv").write_text("e,p_kPa,V_s_m/s\n0.6,100,250\n")
        (given / "probes.csv").write_text("modulus,value_MPa,step\nK,1,0\n")

    def run(self, text, fault, kind, number=0, code=None):
        shutil.rmtree(self.folder, ignore_errors=True)
        self.fired.unlink(missing_ok=True)
        shutil.copytree(self.before, self.folder)
        return self.granum(*(word.replace("disk/", f"{self.folder}/") for word in text.split()), code=code, env={
            **self.env, "GRANUM_TEST_FAULT": fault, "GRANUM_TEST_CALL": kind, "GRANUM_TEST_NUMBER": str(number)})

    def attack(self, text, fault, there=(), code=0):
        """Lets every call in turn fail, so many of a kind; these files in out/ are there, so that each is replaced."""
        for file in there:
            (self.before / "out" / file).parent.mkdir(exist_ok=True)
            (self.before / "out" / file).write_text("kept\n")
        before, whole = contents(self.before), self.run(text, fault, "all", code=code)
        after, calls = contents(self.folder), Counter(self.fired.read_text().split())
        for kind in calls if fault != "short" else {"read", "write"} & set(calls):
            for number in range(min(calls[kind], self.most)):
                run = self.run(text, fault, kind, number)
                self.judge(run, whole, fault, kind)
                found = contents(self.folder)
                for name in found.keys() | after.keys():
                    self.judge_file(name, *(files.get(name) for files in (before, found, after)), run, kind)

    def judge(self, run, whole, fault, kind):
        if run.code == whole.code and same(run.err, whole.err):
            assert same(run.out, whole.out), run
            return
        assert run.code == 3, run
        if kind != "stat":  # where the standard library goes on to a later call, which fails
            name = pathlib.Path(self.fired.read_text()).name
            assert name.replace(".granum.part", "") in run.err and os.strerror(FAULTS[fault]) in run.err, f"{name}\n{run}"

    def judge_file(self, name, before, found, after, run, kind):
        if after is None:
            assert name.endswith(".granum.part") and kind == "remove", f"{name}\n{run}"
        elif found is None or name.endswith(".checkpoint"):  # which may be of an earlier moment
            assert run.code == 3 or found == after, f"{name}\n{run}"
        else:
            assert same(found.decode("latin-1"), after.decode("latin-1")) or (run.code == 3 and found == before), f"{name}\n{run}"


@pytest.fixture
def disk(granum, tmp_path, preloaded, pytestconfig):
    return Disk(granum, tmp_path, preloaded, pytestconfig.getoption("--calls"))


@pytest.mark.parametrize("fault", ["EIO", "short"])
@pytest.mark.parametrize("text, there, code", [
    ("estimate --void-ratio 0.6 --pressure 100kPa --sieve disk/in/sieve.csv --out disk/out/a --force", ["a"], 0),
    ("sweep --depth 1m..9m --points 2 --layers disk/in/layers.csv --out disk/out/a --force", ["a"], 0),
    ("fit disk/in/long.csv --sum-only --out disk/out/a --picture disk/out/p.svg --force", ["a", "p.svg"], 0),
    ("fit disk/in/isotropic.csv --sum-only --out disk/out/a", ["a"], 3),
    ("sweep --table disk/in/speeds.csv --out disk/out/b", [], 0), ("infer --grain-shape sand --table disk/in/speeds.csv", [], 0),
    ("plan --scene disk/in/scene_small.toml --out disk/out/b", [], 0),
    ("analyse disk/in/lammps_chain.atoms disk/in/packed.gz --no-network --threads 1 --stress disk/in/analyse_states.csv"
     " --probes disk/in/probes.csv --frames 0 --out disk/out/r --force", ["r/report.html"], 0)])
def test_reading_and_writing(disk, fault, text, there, code):
    disk.attack(text, fault, there, code)


SHORT_RUN = f"reproduce {SMALL} --set shear.paths=TXC --set shear.largest_strain=0.001 --out disk/out/r"


# a run before, what fails, and files that are there
@pytest.mark.parametrize("fault", FAULTS)
@pytest.mark.parametrize("earlier, text, there", [
    ("", f"verify {SMALL} --out disk/out --force", ["report.html"]),
    (f"verify {SMALL} --out disk/out/v", "verify --report disk/out/v", []),
    ("trade --quick --grains 60 --threads 1 --set study.densities=dense --out disk/out/t", "trade --redraw disk/out/t", []),
    ("", f"export lammps {SMALL} --out disk/out/deck", []),
    ("", SHORT_RUN, []), (SHORT_RUN, "reproduce --threads 1 --resume disk/out/r", [])])
def test_studies(disk, fault, earlier, text, there):
    if earlier:
        disk.run(earlier, fault, "none", code=0)
        shutil.copytree(disk.folder / "out", disk.before / "out", dirs_exist_ok=True)
    disk.attack(text, fault, there)
