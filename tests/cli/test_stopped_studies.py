# SPDX-License-Identifier: GPL-3.0-or-later
"""Studies that a signal, SIGKILL or a full disk ends: files are whole and marked as incomplete, and a run that is resumed
ends with the bytes of one that nothing interrupted. Speed decides how far a run comes, nothing else."""
import errno
import json
import os
import re
import shutil
import signal
import subprocess
import time

import pytest

from test_studies import TRADE, VERIFY
from written import names, rows

TABLES = [f"{name}.csv" for name in "states curves loops histograms table2 table4 table5 exponents verdicts".split()]


@pytest.fixture
def stop(granum, tmp_path):
    """stop(signal, text): what a study leaves that is sent the signal once its folder is there, and what it prints."""
    def ask(number, text):
        folder = tmp_path / "out"
        with open(tmp_path / "said", "w+") as said:
            run = subprocess.Popen([granum.path, *text.split(), "--out", folder], stdout=said, stderr=subprocess.DEVNULL)
            while not folder.exists() and run.poll() is None:
                time.sleep(0.01)
            run.send_signal(number)
            code = run.wait()
            said.seek(0)
            return code, names(folder), json.loads((folder / "manifest.json").read_text()), said.read()
    return ask


@pytest.mark.parametrize("number, expected", [(signal.SIGHUP, 129), (signal.SIGINT, 130), (signal.SIGTERM, 143)])
def test_signals(stop, number, expected):
    """Of a thousand stages, which no machine is done with when the signal comes; what was not run is not judged."""
    pressures = ",".join(f"{k}0Pa" for k in range(1001, 2001))
    code, files, result, _ = stop(number, "verify --grains 300 --set study.contacts=sphere --set study.probe_pressures="
                                f" --set study.pressures={pressures}")
    assert (code, files, result["complete"]) == (expected, VERIFY, False) and result["specimens"][1]["failure"]
    assert [verdict for verdict in result["verdicts"] if verdict["finding"] or not verdict["holds"]] == []


def test_interrupted_trade(stop):
    """Of thousands of specimens; each row that is shown has some of them."""
    code, files, result, out = stop(signal.SIGINT, "trade --quick --grains 60 --seeds 900 --set study.densities=dense")
    assert (code, files, result["complete"]) == (130, TRADE, False) and result["failure"]
    assert re.findall("(?:dense|loose) +0 ", out) == []


def scene(sizes):
    return (f"reproduce --grains 150 --set grain.sizes={sizes} --set study.contacts=sphere --set study.densities=dense"
            " --set study.pressures=25kPa,50kPa,100kPa --set study.probe_pressures= --set shear.paths=TXC,RTXE"
            " --set shear.inertial_number=5e-4 --set shear.largest_strain=0.002 --set shear.strain_step=0.0005")


def tables(folder):
    return {name: (folder / name).read_bytes() for name in TABLES}


@pytest.fixture(scope="module", params=["equal", "lognormal:0.25"])
def whole(request, granum, tmp_path_factory):
    """(sizes of the grains, folder of a run of one thread that nothing interrupted)"""
    folder = tmp_path_factory.mktemp("whole") / "out"
    assert granum.line(scene(request.param), "--threads", "1", "--out", folder).err == ""
    states = rows((folder / "states.csv").read_text())
    assert len([row for row in states if row["path"] == "TXC"]) >= 10
    assert (folder / "scene.toml").read_text().count(f'\nsizes = "{request.param}"\n') == 1
    return request.param, folder


def test_killed_and_resumed(granum, whole, tmp_path, preloaded):
    """Again and again, each time later: after its first file, before its second, after its second ..."""
    sizes, expected = whole
    folder = tmp_path / "resumed"
    start = [*scene(sizes).split(), "--threads", "2", "--out", folder]
    for kills in range(40):
        run = granum(*start, code=None, env={**preloaded, "GRANUM_TEST_MOMENT": str(kills + 1)})
        if run.code == 0:
            break
        assert run.code == -signal.SIGKILL, run
        if (folder / "scene.toml").exists():
            start = ["reproduce", "--threads", "2", "--resume", folder]
    assert kills >= 5 and tables(folder) == tables(expected)

    # begun anew in the folder of an unfinished run: --resume is named, nothing is touched
    unfinished = tmp_path / "unfinished"
    begin = [*scene(sizes).split(), "--out", unfinished]
    granum(*begin, code=-signal.SIGKILL, env={**preloaded, "GRANUM_TEST_MOMENT": "3"})
    left = names(unfinished)
    assert "--resume" in granum(*begin, code=3).err and names(unfinished) == left


def test_finished_runs(granum, whole, tmp_path):
    sizes, expected = whole
    folder = shutil.copytree(expected, tmp_path / "out")
    # its tables are written again, and not replaced unasked
    (folder / "states.csv").unlink()
    granum("reproduce", "--resume", folder)
    assert tables(folder) == tables(expected)
    assert "--force" in granum.line(scene(sizes), "--out", folder, code=3).err
    # a checkpoint that was damaged is named, not run on
    with open(folder / "checkpoints/sphere-dense-1-txc.checkpoint", "a") as checkpoint:
        checkpoint.write("x")
    assert "sphere-dense-1-txc.checkpoint" in granum("reproduce", "--resume", folder, code=3).err
    # a folder that is no run stays as it is, though it has a scene
    foreign = tmp_path / "foreign"
    foreign.mkdir()
    shutil.copy(expected / "scene.toml", foreign)
    (foreign / "states.csv").write_text("mine")
    assert "foreign/checkpoints" in granum("reproduce", "--resume", foreign, code=3).err
    assert names(foreign) == ["scene.toml", "states.csv"] and (foreign / "states.csv").read_text() == "mine"


def test_full_disk(granum, whole, tmp_path):
    """Here a limit on the size of files, in kilobytes: enough for packings, too few for the checkpoints of paths."""
    sizes, expected = whole
    folder = tmp_path / "full"
    run = granum.shell("trap '' XFSZ; ulimit -f 40; exec \"$granum\" \"$@\"", *scene(sizes).split(), "--out", folder, code=3)
    assert ".checkpoint" in run.err and os.strerror(errno.EFBIG) in run.err
    left = names(folder / "checkpoints")
    assert [name for name in left if ".part" in name] == [] and "sphere-1-packing.checkpoint" in left
    granum("reproduce", "--resume", folder)  # with room again
    assert tables(folder) == tables(expected)
