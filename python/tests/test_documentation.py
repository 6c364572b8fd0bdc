# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples of docs/python.md say what they print, and every function says what it takes."""

import doctest
import inspect

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
