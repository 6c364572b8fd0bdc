# SPDX-License-Identifier: GPL-3.0-or-later
"""Single runs of the program, a row each.

A row of rows/<command>.txt is: exit code and kinds of lines on standard error | name | command line | what it holds;...
Kinds are error, warning and note; a run that fails has an error. `said` lets the stream hold other lines, `sanitized`
rows run under the sanitizers too. The command line is read as a shell does, `< file` is its standard input.
What the output holds is a member of the JSON, `outer/inner = value` (a number to the digits that are written, a text,
null, or missing) or `outer/inner ~ text within`, or a text of standard output, after `err` of standard error; runs of
spaces and ends of lines count as one space, and `..` is anything.
`let name = text` defines $name, `file name = text` writes a file into $tmp, the folder of the table; {50:x} repeats x.
"""
import collections
import json
import pathlib
import re
import shlex

import pytest

from conftest import DATA

FOLDER = pathlib.Path(__file__).parent


def repeated(text):
    return re.sub(r"\{(\d+):(.*?)\}", lambda m: int(m[1]) * m[2], text, flags=re.S)


def read(file):
    """Files that the rows use, and the rows."""
    names = {"io": "../../io/data", "examples": "../../../examples", "tmp": "{tmp}"}
    files, rows = {}, []
    for line in file.read_text().splitlines():
        filled = re.sub(r"\$(\w+)", lambda m: names[m[1]], line)
        if line.startswith("let "):
            name, names[name] = filled[4:].split(" = ", 1)
        elif line.startswith("file "):
            name, text = line[5:].split(" = ", 1)
            files[name] = repeated(text.replace("\\\\", "\0").replace("\\n", "\n").replace("\0", "\\"))
        elif line and not line.startswith("#"):
            ends, name, command, *held = filled.split(" | ", 3)
            code, *kinds = ends.split()
            rows.append(pytest.param(file.stem, int(code), kinds, command, held[0].split("; ") if held else [],
                                     id=f"{file.stem}: {name}",
                                     marks=[pytest.mark.sanitized] if "sanitized" in kinds else []))
    return files, rows


def flat(text):
    return " ".join(text.split())


def kinds_of(err):
    return {m[1] for m in re.finditer(r"^granum: (\w+): ", err, re.M)}


def sentences_of(err):
    """Sentences of standard error with their kinds, without numbers, what is quoted, and folders of files."""
    for line in re.findall(r"^granum: (.*(?:\n .*)*)", err, re.M):
        line = re.sub(r"'[^']*'|\"[^\"]*\"", "''", flat(line))
        line = re.sub(r"(?<![\w.])\.{0,2}/(?:\S*/)*(?=[\w.-])", "", line)
        yield re.sub(r"(?<![\w-])[-−]?\d[\d.,]*(?:e[-+]?\d+)?", "#", re.sub(r"(.)\1{99,}", r"\1\1\1", line))


def agrees(value, expected):
    """Whether a member of JSON is what a row writes."""
    if not isinstance(value, (int, float)) or isinstance(value, bool):
        return expected == (value if isinstance(value, str) else json.dumps(value))
    try:
        number = float(expected)
    except ValueError:
        return False
    decimals, exponent = re.fullmatch(r"-?\d+\.?(\d*)(?:e([-+]?\d+))?", expected).groups()
    last_digit = 10.0 ** (int(exponent or 0) - len(decimals)) if decimals or exponent else 0
    return abs(value - number) <= max(0.6 * last_digit, 1e-12 * abs(number))


def member(document, keys):
    """(whether it is there, value)"""
    for key in keys.split("/"):
        try:
            document = document[int(key) if isinstance(document, list) else key]
        except (KeyError, IndexError, TypeError, ValueError):
            return False, None
    return True, document


def holds(run, what):
    """Whether a run's output holds what the row says."""
    in_json = re.fullmatch(r"(?!err )(.+?) ([=~]) (.*)", what) if "--json" in run.words else None
    if in_json:
        keys, relation, expected = in_json.groups()
        there, value = member(run.json, keys)
        if relation == "~":
            return there and expected in json.dumps(value, ensure_ascii=False)
        return not there if expected == "missing" else there and agrees(value, expected)
    stream, text = (run.err, what[4:]) if what.startswith("err ") else (run.out, what)
    return re.search(".*".join(map(re.escape, flat(text).split(".."))), flat(stream)) is not None


TABLES = {file.stem: read(file) for file in sorted((FOLDER / "rows").glob("*.txt"))}


@pytest.fixture(scope="session")
def tmp(tmp_path_factory):
    """The folder of a table, with its files."""
    made = {}

    def folder(table):
        if table not in made:
            made[table] = tmp_path_factory.mktemp(table)
            for name, text in TABLES[table][0].items():
                (made[table] / name).parent.mkdir(exist_ok=True)
                (made[table] / name).write_text(text)
        return str(made[table])

    return folder


@pytest.fixture(scope="module")
def said(pytestconfig):
    """Sentences of each table's commands, counted; written for test_sentences.py at the end."""
    counted = collections.defaultdict(collections.Counter)
    yield counted
    folder = pytestconfig.getoption("--said")
    for table, sentences in counted.items() if folder else ():
        folder.mkdir(parents=True, exist_ok=True)
        (folder / f"{table}.json").write_text(json.dumps([[*one, count] for one, count in sentences.items()]))


def pytest_generate_tests(metafunc):
    wanted = metafunc.config.getoption("--table") or TABLES
    metafunc.parametrize("table, code, kinds, command, held", [row for table in wanted for row in TABLES[table][1]])


def test_row(granum, said, tmp, table, code, kinds, command, held):
    words = [word.replace("{tmp}", tmp(table)) for word in shlex.split(repeated(command))]
    given = ""
    if "<" in words:
        words, given = words[:-2], (DATA / words[-1]).read_text()
    run = granum(*words, code=code, input=given)
    said[table].update((words[0] if words else "granum", one) for one in sentences_of(run.err.replace(tmp(table) + "/", "")))
    expected = {*kinds} - {"sanitized", "said"} | ({"error"} if code else set())
    assert kinds_of(run.err) == expected, f"kinds of lines on standard error\n{run}"
    assert "said" in kinds or bool(run.err) == bool(expected), f"standard error\n{run}"
    assert code != 2 or not run.out, f"refused, and yet there is output\n{run}"
    for what in held:
        assert holds(run, what), f"{what}\n{run}"
