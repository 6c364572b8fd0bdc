# SPDX-License-Identifier: GPL-3.0-or-later
"""Standard streams that are closed, full, or read by nobody any more. Standard error is no part of a result: what a run
answers, writes and ends with is the same without it. Standard output that cannot be written to is a file error, exit code
3, and files that were written before are kept."""
import os
import signal
import subprocess

import pytest

STATE = "estimate --void-ratio 0.6 --pressure 100kPa"
WARNED = f"{STATE} --coordination-number 13 --full"
STUDY = ("verify --grains 80 --seeds 1 --set study.contacts=sphere --set study.densities=dense"
         " --set study.pressures=20kPa,40kPa,60kPa --set study.probe_pressures= --out")


def redirected(granum, streams, text, **how):
    """A run whose streams are redirected so, in bash."""
    return granum.shell(f'"$granum" "$@" {streams}', *text.split(), **how)


# by the time that something is said to the last but one, its reader is gone
@pytest.mark.parametrize("streams", ["2>&-", "2>/dev/full", "2</dev/null", "2> >(exec true)", "2>&- <&-"])
def test_without_standard_error(granum, tmp_path, streams):
    expected = granum.line(WARNED)
    assert "granum: warning: " in expected.err
    assert redirected(granum, streams, WARNED).out == expected.out
    redirected(granum, streams, f"{WARNED} --out kept", at=tmp_path)  # a file does not take the place of the stream
    assert (tmp_path / "kept").read_text() == expected.out
    redirected(granum, streams, "estimate --void-ratio -1 --pressure 100kPa", code=2)
    redirected(granum, streams, "nonsense", code=2)


@pytest.mark.parametrize("streams", [">&-", ">/dev/full", "</dev/null >&0"])
@pytest.mark.parametrize("text", [WARNED, "--help", "--version", "sweep --help"])
def test_without_standard_output(granum, streams, text):
    assert "standard output" in redirected(granum, streams, text, code=3).err
    redirected(granum, f"{streams} 2>&-", text, code=3)


def test_reader_that_has_ended(granum):
    ours, theirs = os.pipe()
    os.close(ours)
    with open(theirs, "w") as stream:
        assert subprocess.run([granum.path, "--help"], stdout=stream, stderr=subprocess.PIPE).returncode == -signal.SIGPIPE


def test_study_without_a_stream(granum, tmp_path):
    granum.line(f"{STUDY} whole", at=tmp_path)
    redirected(granum, "2>&-", f"{STUDY} deaf", at=tmp_path)
    redirected(granum, ">&-", f"{STUDY} mute", at=tmp_path, code=3)
    for folder in "deaf", "mute":
        for name in "states.csv", "exponents.csv":
            assert (tmp_path / folder / name).read_bytes() == (tmp_path / "whole" / name).read_bytes()
        assert (tmp_path / folder / "manifest.json").stat().st_size > 0
