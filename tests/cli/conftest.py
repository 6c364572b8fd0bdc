# SPDX-License-Identifier: GPL-3.0-or-later
"""What tests of the program share: the fixture `granum` runs it, as a user does, in the folder of the data."""
import dataclasses
import json
import os
import pathlib
import re
import subprocess

import pytest

CLI = pathlib.Path(__file__).resolve().parent
DATA = CLI / "data"
ROOT = CLI.parents[1]


def pytest_addoption(parser):
    parser.addoption("--granum", type=pathlib.Path, required=True, help="the program")
    parser.addoption("--reference", type=pathlib.Path, help="the folder of its manual pages")
    parser.addoption("--preloaded", type=pathlib.Path, help="a library that is loaded before those of the program")
    parser.addoption("--calls", type=int, default=3, help="how many calls of a kind fail, one after the other")
    parser.addoption("--table", action="append", help="rows of this table alone")
    parser.addoption("--said", type=pathlib.Path, help="folder for the sentences that rows say")
    parser.addoption("--update", action="store_true", help="writes the golden sentences anew")


def pytest_configure(config):
    config.addinivalue_line("markers", "sanitized: runs under the sanitizers too")


@dataclasses.dataclass
class Run:
    """What a run of the program ended with."""

    words: list
    code: int
    out: str
    err: str

    @property
    def json(self):
        return json.loads(self.out)

    @property
    def flat(self):
        """Standard output with its wrapped lines joined."""
        return re.sub(r"\n *", " ", self.out)

    def __str__(self):
        return f"granum {' '.join(self.words)}\nexit code {self.code}\n--- standard output:\n{self.out}\n--- standard error:\n{self.err}"


class Program:
    def __init__(self, path):
        self.path = path

    def __call__(self, *words, code=0, at=DATA, input="", env=None, timeout=3600):
        """A run with these arguments; it must end with the exit code, unless that is None."""
        words = [str(word) for word in words]
        done = subprocess.run([self.path, *words], input=input, capture_output=True, text=True, errors="surrogateescape", cwd=at,
                              timeout=timeout, env={**os.environ, **(env or {})})
        run = Run(words, done.returncode, done.stdout, done.stderr)
        assert code is None or run.code == code, f"expected exit code {code}\n{run}"
        return run

    def line(self, text, *words, **how):
        """A run with the words of this text, and with more words as they are."""
        return self(*text.split(), *words, **how)

    def shell(self, script, *words, code=0, at=DATA, env=None):
        """A script of bash in which "$granum" is the program and "$@" are the words."""
        return Program("bash")("-c", script, "bash", *words, code=code, at=at, env={"granum": str(self.path), **(env or {})})


@pytest.fixture(scope="session")
def granum(pytestconfig):
    return Program(pytestconfig.getoption("--granum").resolve())


@pytest.fixture(scope="session")
def preloaded(pytestconfig):
    """The environment of a run that loads the library first."""
    library = pytestconfig.getoption("--preloaded") or pytest.skip("--preloaded is not given")
    return {"LD_PRELOAD": str(library.resolve())}
