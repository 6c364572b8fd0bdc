# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples of docs/python.md say what they print, and every function says what it takes."""

import doctest
import inspect
import runpy

import granum
import numpy as np
import pytest


@pytest.mark.parametrize("path, least", [("docs/python.md", 11), ("python/package.md", 3)])
def test_the_page_prints_its_stated_output(source, monkeypatch, path, least):
    monkeypatch.chdir(source)
    page = source / path
    text = page.read_text().replace("```", "")  # a fence would be taken for output
    test = doctest.DocTestParser().get_doctest(text, {}, path, str(page), 0)
    assert len(test.examples) >= least
    runner = doctest.DocTestRunner()
    output = []
    runner.run(test, out=output.append)
    assert runner.failures == 0, "".join(output)


FUNCTIONS = [name for name in granum.__all__ if inspect.isroutine(getattr(granum, name))]


@pytest.mark.parametrize("name", FUNCTIONS)
def test_functions_have_signatures(name):
    documentation = inspect.getdoc(getattr(granum, name))
    assert documentation
    for parameter in inspect.signature(getattr(granum, name)).parameters.values():
        if "Parameters\n" in documentation:
            assert parameter.name in documentation, parameter


def test_all_names_are_there():
    assert all(hasattr(granum, name) for name in granum.__all__)
    assert "measure" in granum.__all__ and "__version__" in granum.__all__


EXAMPLES = {
    "judge_a_packing": [
        "steep contacts carry 1.007 times the mean force of flat ones",
        "force ~ overlap^1.5000, G_g = 30.00 GPa",
        "rung3           G_vh is 0.97 of the network's",
    ],
    "modulus_and_range": ["   3 m: G_vh = 129.3 MPa +- 5.1 %"],
}


def test_every_example_is_run(source):
    beside_others = ["beside_lammps"]  # run by tests/peer/lammps
    found = sorted(path.stem for path in (source / "examples" / "python").glob("*.py"))
    assert sorted([*EXAMPLES, *beside_others]) == found


@pytest.mark.parametrize("name", EXAMPLES)
def test_examples_print_their_stated_output(source, name, capsys):
    runpy.run_path(str(source / "examples" / "python" / f"{name}.py"))
    printed = capsys.readouterr().out.splitlines()
    for line in EXAMPLES[name]:
        assert line in printed


def site(source, script):
    """Names of a script of docs/site."""
    return runpy.run_path(str(source / "docs" / "site" / f"{script}.py"))


def parts_of(value):
    """What the attributes of an object hold; what a rough law has none of raises."""
    for name in dir(value):
        if not name.startswith("_"):
            try:
                yield getattr(value, name)
            except granum.InvalidArgument:
                pass


def kinds_reached(values, depth=3):
    """The classes of the package that these objects are of, and those that their attributes and elements are of."""
    kinds = set()
    for value in values:
        if type(value).__module__.startswith("granum"):
            kinds.add(type(value).__name__)
            if depth and not isinstance(value, (granum.Frames, granum.Compression, granum.Shearing)):
                kinds |= kinds_reached(parts_of(value), depth - 1)
        elif isinstance(value, (list, tuple)):
            kinds |= kinds_reached(value[:1], depth)
        elif isinstance(value, dict):
            kinds |= kinds_reached(list(value.values())[:1], depth)
    return kinds


def example_of(name):
    """The section Examples of a docstring."""
    return inspect.getdoc(getattr(granum, name)).partition("\nExamples\n--------\n")[2].strip()


def test_every_public_name_has_an_example_that_prints_what_it_says(source, monkeypatch):
    monkeypatch.chdir(source)
    blocks, unseen = {}, []
    for name in granum.__all__:
        if name != "__version__":
            blocks.setdefault(example_of(name), []).append(name)
    assert "" not in blocks, blocks.get("")
    assert len(blocks) > 80
    for text, names in blocks.items():
        names_at_first = {"granum": granum, "np": np}
        test = doctest.DocTestParser().get_doctest(text + "\n", names_at_first, names[0], "examples.inc", 0)
        output = []
        runner = doctest.DocTestRunner()
        runner.run(test, out=output.append, clear_globs=False)
        assert test.examples and runner.failures == 0, "".join(output)
        made = kinds_reached(list(test.globs.values()))
        for name in names:
            of_class = inspect.isclass(getattr(granum, name)) and name in made
            if f"granum.{name}" not in text and not of_class:
                unseen.append(name)
    assert not unseen


def test_every_example_belongs_to_a_public_name():
    assert set(granum._granum._examples) == set(granum.__all__) - {"__version__"}


def test_every_public_name_has_a_page_with_its_docstring_and_example(source, tmp_path):
    pages = site(source, "python_pages")
    pages["write"](tmp_path / "pages")
    for name in set(granum.__all__) - {"__version__"}:
        page = (tmp_path / "pages" / f"python_{name}.md").read_text()
        assert page.startswith(f"# {name} (Python) {{#python_{name}}}\n")
        _, documentation = pages["signature"](name, getattr(granum, name))
        assert pages["escaped"](documentation.split()[0]) in page
        code = page.partition("**Examples**")[2]
        assert ">>> import granum\n" in code
        assert code.count(example_of(name).splitlines()[0].split("  # doctest")[0]) == 1
        for parameter in ("law", "pressure", "stiffness"):
            if f"\n{parameter} : " in documentation:
                assert f"<dt>{parameter} : " in page, (name, parameter)


def test_a_name_without_example_makes_no_site(source, tmp_path, monkeypatch):
    pages = site(source, "python_pages")

    def digby():
        """Nothing to try."""

    monkeypatch.setattr(granum, "digby", digby)
    with pytest.raises(SystemExit, match="digby"):
        pages["write"](tmp_path / "pages")


def test_notebooks_become_pages_with_their_pictures(source, tmp_path):
    site(source, "notebook_pages")["write"](source, tmp_path / "pages", tmp_path / "pictures")
    notebooks = sorted((source / "examples" / "notebooks").glob("*.ipynb"))
    assert len(list((tmp_path / "pages").glob("notebook_*.md"))) == len(notebooks) == 6
    assert len(list((tmp_path / "pictures").glob("*.png"))) >= 5
    first = (tmp_path / "pages" / f"notebook_{notebooks[0].stem}.md").read_text()
    assert "granum.packing_answer(" in first and first.count("<img") >= 1
