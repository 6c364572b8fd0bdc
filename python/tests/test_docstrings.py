# SPDX-License-Identifier: GPL-3.0-or-later
"""Every public function says what it takes, gives and refuses, in the format of numpydoc, and where it comes from."""

import inspect
import re

import granum
import pytest

SECTIONS = ["Parameters", "Returns", "Raises", "See Also", "Notes", "Examples"]
FUNCTIONS = sorted(name for name in granum.__all__ if inspect.isroutine(getattr(granum, name)))
CLASSES = sorted(name for name in granum.__all__ if inspect.isclass(getattr(granum, name)))


def signature_of(name):
    """Names of the parameters."""
    return [parameter.name for parameter in inspect.signature(getattr(granum, name)).parameters.values()]


def sections_of(name):
    """The summary and the sections of a docstring."""
    lines = inspect.getdoc(getattr(granum, name)).splitlines()
    sections, title = {"Summary": []}, "Summary"
    for line, below in zip(lines, [*lines[1:], ""]):
        if below and set(below) == {"-"}:
            assert len(below) == len(line), f"{name}: the line below {line}"
            title = line
            sections[title] = []
        elif not (line and set(line) == {"-"}):
            sections[title].append(line)
    return sections


def entries_of(lines):
    """Names and type of each entry of a section, with what is said of it."""
    found = []
    for line in lines:
        if line and not line.startswith(" "):
            found.append([line, []])
        elif line:
            found[-1][1].append(line.strip())
    return [(head, " ".join(text)) for head, text in found]


@pytest.mark.parametrize("name", FUNCTIONS)
def test_sections_are_in_order(name):
    sections = sections_of(name)
    summary = sections.pop("Summary")
    assert summary[0].endswith("."), "the summary is a sentence of one line"
    assert len(summary[0]) <= 110
    assert list(sections) == [title for title in SECTIONS if title in sections]
    assert {"Returns", "Notes", "Examples"} <= set(sections)
    if signature_of(name):
        assert {"Parameters", "Raises"} <= set(sections)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_parameters_are_those_of_the_signature_and_have_units(name):
    documented = []
    for head, text in entries_of(sections_of(name).get("Parameters", [])):
        names, kind = head.split(" : ")
        documented += [one.lstrip("*") for one in names.split(", ")]
        assert text.endswith((".", "]", "}")) or "::" in text or text, head
        numbers = re.search(r"\b(float|array_like)\b", kind) and "int" not in kind and "bool" not in kind
        assert text, f"{head}: nothing is said of it"
        assert not numbers or "[" in text, f"{head}: no unit in brackets"
    assert sorted(documented) == sorted(signature_of(name))


@pytest.mark.parametrize("name", FUNCTIONS)
def test_errors_are_those_of_the_package_or_of_python(name):
    for head, text in entries_of(sections_of(name).get("Raises", [])):
        error = getattr(granum, head, None) or getattr(__builtins__, head, None) or __builtins__.get(head)
        assert issubclass(error, Exception)
        assert text.startswith(("For", "Unless", "If", "Where", "Without", "Naming", "By", "With")), text


@pytest.mark.parametrize("name", FUNCTIONS)
def test_notes_name_a_source_that_is_there(name, source):
    notes = " ".join(sections_of(name)["Notes"])
    bibliography = (source / "validation" / "references.bib").read_text()
    for key in re.findall(r"\[([A-Z]\w*\d{4}[a-z]?)[],]", notes):
        assert "{" + key + "," in bibliography, key
    for paper, year in re.findall(r"\b([A-Z][a-z]+) (\d{4})\)", " ".join(sections_of(name)["Summary"])):
        assert re.search(rf"\[\w*{paper}{year}\]", notes), f"{paper} {year} is no key in the notes"
    called = re.search(r"In C\+\+: granum::([\w:]+) of granum/(\S+\.hpp)\.", notes)
    if name == "verify":  # the rooms of the commands are no part of the installed library
        assert "not installed" in notes
        return
    header = source / "include" / "granum" / called.group(2)
    assert re.search(rf"\b{called.group(1).split('::')[-1]}\b", header.read_text()), called.group(0)


@pytest.mark.parametrize("name", CLASSES)
def test_members_of_classes_are_documented(name):
    kind = getattr(granum, name)
    assert inspect.getdoc(kind)
    for member in dir(kind):
        if not member.startswith("_") and not issubclass(kind, BaseException):
            said = inspect.getdoc(getattr(kind, member)) or ""
            said = re.sub(r"^\w+\(.*\) -> .*\n*", "", said)
            assert said.strip(), f"{name}.{member} says nothing"


def test_there_are_functions_to_look_at():
    assert len(FUNCTIONS) > 60 and len(CLASSES) > 50


def test_sources_of_laws_minerals_and_sands_are_typeset_references():
    sources = granum.references()
    for table in (granum.known_sands(), granum.measured_laws(), granum.minerals()):
        for key in {key for row in table.values() for key in row.source.split("; ")}:
            assert not set("\\{}$") & set(sources[key].text + sources[key].remark)
    assert sources["Hertz1882"].link == "https://doi.org/10.1515/crll.1882.92.156"
