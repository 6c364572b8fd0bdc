# SPDX-License-Identifier: GPL-3.0-or-later
"""Names, headings and files that are meant to do harm, and what is more than the machine has."""
import os

import pytest

from conftest import DATA
from written import names

SWEEP = "sweep --void-ratio 0.6 --path iso --from 10kPa --to 20kPa"
FRAME = ("ITEM: TIMESTEP\n%d\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n0 1\n0 1\n0 1\n"
         "ITEM: ATOMS id radius x y z\n1 0.4 0.5 0.5 0.5\n")
OBEYED = "\x1b", "\x9b", "\u202e"  # what a terminal obeys: escapes, and a change of the direction of text


@pytest.fixture
def attack(granum, tmp_path):
    """attack(words): a run in a folder of its own; nothing that it prints may be obeyed by a terminal."""
    def run(*words, **how):
        done = granum(*words, at=tmp_path, **how)
        assert [sign for sign in OBEYED if sign in done.out + done.err] == []
        return done
    return run


def test_hostile_name(attack, tmp_path):
    """It is shown escaped; in JSON it comes back, but for what is no UTF-8."""
    hostile = os.fsdecode(b"n\xff\x1b[2J\xc2\x9b\xe2\x80\xae.csv")
    (tmp_path / hostile).write_bytes((DATA / "analyse_chain_contacts.csv").read_bytes())
    assert "x1b" in attack("analyse", hostile).out
    assert "x1b" in attack("analyse", "absent" + hostile, code=3).err
    shown = attack("analyse", hostile, "--json", "--out", "results")
    assert "\\u001b" in shown.out and "\\u009b" in shown.out and "\\u202e" in shown.out
    assert shown.json["files"][0]["path"] == hostile.replace("\udcff", "\ufffd")
    files = {"frames.csv", "rose.csv", "forces.csv", "rose.svg", "forces.svg", "analysis.json"}
    assert files <= set(names(tmp_path / "results"))


@pytest.mark.parametrize("command, table", [
    (["analyse"], "nx,ny,nz,\x1b[2J,nx\n1,0,0,1,1\n"), (["sweep", "--table"], "e,p_kPa,a\u202eb_kPa\n0.6,100\n")])
def test_hostile_headings(attack, tmp_path, command, table):
    (tmp_path / "t\u202e.csv").write_text(table)
    attack(*command, "t\u202e.csv", code=3)


def test_long_names(attack):
    attack("analyse", DATA / "analyse_chain_contacts.csv", "--out", "1" * 5000, code=3)
    attack("analyse", "1" * 5000, code=3)


def test_command_for_a_name(attack, tmp_path):
    attack(*SWEEP.split(), "--out", "< touch x; cat a.csv", "--picture", "a.svg")
    assert names(tmp_path) == ["< touch x; cat a.csv", "a.svg"]


def test_frames_without_end(granum):
    """No more of them are held than one answer has."""
    done = granum("analyse", "/dev/stdin", input="".join(FRAME % k for k in range(10500)))
    for shown, name in (done.out, "frame 9999"), (done.err, "--frames"):
        assert name in shown and "10000" in shown


@pytest.mark.parametrize("study", ["export lammps --start scattered", "verify", "reproduce"])
def test_out_of_memory(granum, tmp_path, study):
    words = f"{study} --set study.contacts=sphere --grains 10000000 --out deck".split()
    assert "--grains 10000000" in granum.shell('ulimit -v 200000; "$granum" "$@"', *words, at=tmp_path, code=1).err
