# SPDX-License-Identifier: GPL-3.0-or-later
"""Every sentence of errors, warnings and notes that the rows of test_rows.py meet: once, in sentences/<command>.txt,
after the number of rows that say it; numbers and quoted words are left out. After a change of words:

  pytest test_rows.py test_sentences.py --granum <program> --said <folder> --update
"""
import collections
import json
import pathlib

import pytest

FOLDER = pathlib.Path(__file__).parent
COMMANDS = ["analyse", "estimate", "export", "fit", "granum", "infer", "plan", "reproduce", "sweep", "trade", "verify"]


@pytest.fixture(scope="session")
def said(pytestconfig):
    """{command: {sentence: number of rows}}"""
    folder = pytestconfig.getoption("--said")
    tables = {file.stem for file in (FOLDER / "rows").glob("*.txt")}
    assert {file.stem for file in folder.glob("*.json")} >= tables, "run test_rows.py with this --said first"
    counted = collections.defaultdict(collections.Counter)
    for table in tables:
        for command, sentence, count in json.loads((folder / f"{table}.json").read_text()):
            counted[command if command in COMMANDS else "granum"][sentence] += count
    return counted


@pytest.mark.parametrize("command", COMMANDS)
def test_sentences(pytestconfig, said, command):
    found = "".join(f"{count} {sentence}\n" for sentence, count in sorted(said[command].items()))
    golden = FOLDER / "sentences" / f"{command}.txt"
    if pytestconfig.getoption("--update"):
        golden.write_text(found)
    assert found == golden.read_text()
