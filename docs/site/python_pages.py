# SPDX-License-Identifier: GPL-3.0-or-later
"""Pages of the site about the package of Python: one a name, with its docstring, in groups.

    python3 docs/site/python_pages.py <folder>   # of the pages; the package has to be importable

Checked by python/tests/test_documentation.py
"""

import inspect
import pathlib
import re
import sys
import textwrap

import granum

GROUPS = {
    "Contact laws and minerals": """sphere cone flat_punch power_law rough_sphere contact_law NormalLaw minerals Mineral
        mindlin_stiffness_ratio pair_radius""",
    "Closed forms": """uniform_strain uniform_stress free_spin relaxed answer rungs exponents uniform_strain_moduli
        uniform_strain_kinematic uniform_stress_kinematic Estimate ModulusErrors Exponents Moduli Rung""",
    "The answer and its range": """packing_answer estimate contact_prior carried_contacts PackingAnswer Range Ladder
        RungAssessment ContactPrior ContactCounts CarriedContacts Measured""",
    "From measurements": "infer fit hardin Inference SandInference MeasuredRows Fit",
    "Ground, sands and water": """ground_stress stress_on_path failure_ratio known_sands measured_laws
        sand_shear_modulus void_ratio_of_relative_density saturated
        water_and_air_bulk_modulus bulk_density GroundStress KnownSand MeasuredLaw
        references Reference""",
    "Rock physics": """hertz_mindlin walton_uniaxial walton_uniaxial_stress norris_johnson norris_johnson_stress digby
        jenkins_shear_modulus soft_sand stiff_sand cement_at_contacts cement_in_surface_layer
        murphy_coordination_number IsotropicModuli AxialStress""",
    "Packings": """read frames formats write_vtk packing overlap_contacts from_lammps from_yade measure profile d2min stiffness_matrix
        lowest_modes Packing Contacts Frames
        Measurement Interior Counts Microstructure Fabric RoseBin ContactStress Forces Network Modes Sizes LawCheck""",
    "Fabric and sizes": """fabric_density fabric_cumulative_probability fabric_polar_cosine_quantile fabric_measures
        sample_normals rose estimate_anisotropy estimate_anisotropy_by_likelihood isotropy_p_value Distribution
        gradation expected_contact_means FabricMeasures AnisotropyEstimate LikelihoodEstimate Gradation
        ContactMeans""",
    "Elasticity": """isotropic isotropic_projection transversely_isotropic_projection isotropic_averages
        engineering_moduli rotate plane_waves thomsen_parameters symmetry_distances Isotropic IsotropicAverages
        EngineeringModuli PlaneWaves ThomsenParameters SymmetryDistances""",
    "The verifier": """specimen compress probe shear verify Specimen Compression State ProbeResult Shearing PathPoint
        Study Verdict""",
    "Errors and records": "Error InvalidArgument FileError NotConverged Stopped Record",
}


def escaped(text):
    """Words of a docstring as doxygen's Markdown reads them."""
    text = text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
    text = re.sub(r"([*@#%|])", r"\\\1", text)
    return re.sub(r"(?<!\w)_(\w)", r"\\_\1", text)


def linked(text):
    """The same, with names of the package that lead to their pages."""
    return re.sub(
        r"(?<![\w.:/])(" + "|".join(sorted(granum.__all__, key=len, reverse=True)) + r")(?=\(\))",
        r"[\1](@ref python_\1)",
        escaped(text),
    )


def entries(lines):
    """A section of entries, "name : type" and what is said of it below, as a list of definitions."""
    out, inside = [], False
    for line in lines:
        if line and not line.startswith(" "):
            out += ["</dd>"] if inside else []
            out.append(f"<dt>{kind_of(line)}</dt><dd>")
            inside = True
        elif line:
            out.append(linked(line.strip()))
    return ["<dl>", *out, "</dd></dl>"] if inside else []


def kind_of(line):
    """The head of an entry, whose type leads to its page where it is a class of the package."""
    return re.sub(r"\b([A-Z]\w+)\b", lambda m: ref(m[1]) if m[1] in granum.__all__ else m[1], escaped(line))


def ref(name):
    return f"[{name}](@ref python_{name})"


def example(lines):
    """The section Examples as code that can be copied as a whole."""
    text = re.sub(r"  # doctest: \+SKIP", "", "\n".join(lines).strip())
    imports = ">>> import granum\n" + (">>> import numpy as np\n" if "np." in text else "")
    return ["```py", imports + text, "```"]


def prose(lines):
    return [linked(line) for line in textwrap.dedent("\n".join(lines)).splitlines()]


def documentation(text):
    """A docstring in the format of numpydoc as Markdown."""
    out, title, section = [], None, []
    lines = [*text.splitlines(), ""]

    def close():
        while section and not section[-1]:
            section.pop()
        if title:
            out.append(f"\n**{title}**\n")
        has_entries = title in ("Parameters", "Returns", "Raises", "Attributes")
        out.extend(entries(section) if has_entries else example(section) if title == "Examples" else prose(section))

    for line, below in zip(lines, [*lines[1:], ""]):
        if below and set(below) == {"-"} and len(below) == len(line):
            close()
            title, section = line, []
        elif not (line and set(line) == {"-"}):
            section.append(line)
    close()
    return "\n".join(out)


def signature(name, value):
    """The lines of a call, and the docstring."""
    text = inspect.getdoc(value) or ""
    if inspect.isclass(value):
        return None, text
    call = f"granum.{name}{inspect.signature(value)}"
    return textwrap.fill(call, 100, subsequent_indent=" " * 4, break_long_words=False), text


def members(kind):
    """The public members of a class: names and what is said of them."""
    lines = []
    for member in dir(kind):
        value = getattr(kind, member)
        if member.startswith("_") or member in ("args", "with_traceback", "add_note") or value is None:
            continue
        if not (callable(value) or isinstance(value, property)):
            continue
        said = inspect.getdoc(value) or ""
        said = re.sub(r"^\w+\(.*\) -> .*\n*", "", said).split("\n\n")[0]
        call = "()" if callable(value) else ""
        lines.append(f"<dt>{escaped(member)}{call}</dt><dd>{linked(said)}</dd>")
    return ["", "**Members**", "", "<dl>", *lines, "</dl>"] if lines else []


def page(name):
    value = getattr(granum, name)
    lines = [f"# {name} (Python) {{#python_{name}}}", ""]
    is_class = inspect.isclass(value)
    call, text = signature(name, value)
    if call:
        lines += ["```py", call, "```", ""]
    lines += [documentation(text)]
    if is_class:
        lines += members(value)
    return "\n".join([*lines, ""])


def write(folder):
    listed = [name for names in GROUPS.values() for name in names.split()]
    public = {name for name in granum.__all__ if not name.startswith("__")}
    if sorted(listed) != sorted(public):
        sys.exit(f"docs/site/python_pages.py: names without one place: {sorted(set(listed) ^ public)}")
    without = [name for name in sorted(public) if "\nExamples\n" not in (inspect.getdoc(getattr(granum, name)) or "")]
    if without:
        sys.exit(f"python/src/examples.inc: names without an example: {without}")
    folder.mkdir(parents=True, exist_ok=True)
    index = ["# Python API {#python_api}", "", "Every public name of granum; the guide: \\ref python.", ""]
    for title, names in GROUPS.items():
        label = "python_of_" + re.sub(r"\W+", "_", title.lower())
        index.append(f"- \\subpage {label}")
        lines = [f"# {title} (Python) {{#{label}}}", "", "| | |", "| --- | --- |"]
        for name in names.split():
            summary = signature(name, getattr(granum, name))[1].strip().splitlines()[0]
            lines.append(f"| \\subpage python_{name} \"{name}\" | {escaped(summary)} |")
            (folder / f"python_{name}.md").write_text(page(name) + "\n")
        (folder / f"{label}.md").write_text("\n".join(lines) + "\n")
    (folder / "python_api.md").write_text("\n".join(index) + "\n")


if __name__ == "__main__":
    write(pathlib.Path(sys.argv[1]))
