# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples of docs/python.md say what they print, and every function says what it takes."""

import doctest
import inspect
import runpy

import granum
import pytest


def test_the_page_prints_what_it_says(source, monkeypatch):
    monkeypatch.chdir(source)
    page = source / "docs" / "python.md"
    text = page.read_text().replace("```", "")  # a fence would be taken for output
    test = doctest.DocTestParser().get_doctest(text, {}, "python.md", str(page), 0)
    assert len(test.examples) > 10
    runner = doctest.DocTestRunner()
    output = []
    runner.run(test, out=output.append)
    assert runner.failures == 0, "".join(output)


FUNCTIONS = [name for name in granum.__all__ if inspect.isroutine(getattr(granum, name))]


@pytest.mark.parametrize("name", FUNCTIONS)
def test_functions_say_what_they_take(name):
    documentation = inspect.getdoc(getattr(granum, name))
    assert documentation
    try:
        signature = inspect.signature(getattr(granum, name))
    except ValueError:  # of pybind11, which writes it into the documentation
        assert documentation.startswith(name + "(")
        return
    for parameter in signature.parameters.values():
        if "Parameters\n" in documentation:
            assert parameter.name in documentation, parameter


def test_all_names_are_there():
    assert all(hasattr(granum, name) for name in granum.__all__)
    assert "measure" in granum.__all__ and "__version__" in granum.__all__


EXAMPLES = {
    "judge_a_packing": [
        "steep contacts bear 1.007 of what flat ones bear",
        "force ~ overlap^1.5000, G_g = 30.00 GPa",
        "rung3           G_vh is 0.95 of the network's",
    ],
    "modulus_and_range": ["   3 m: G_vh = 129.3 MPa +- 5.1 %"],
}


def test_every_example_is_run(source):
    beside_others = ["beside_lammps"]  # run by tests/peer/lammps
    found = sorted(path.stem for path in (source / "examples" / "python").glob("*.py"))
    assert sorted([*EXAMPLES, *beside_others]) == found


@pytest.mark.parametrize("name", EXAMPLES)
def test_examples_print_what_they_should(source, name, capsys):
    runpy.run_path(str(source / "examples" / "python" / f"{name}.py"))
    printed = capsys.readouterr().out.splitlines()
    for line in EXAMPLES[name]:
        assert line in printed
