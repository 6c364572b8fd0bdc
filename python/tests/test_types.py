# SPDX-License-Identifier: GPL-3.0-or-later
"""The types that editors and checkers see are those of the package."""

import json
import os
import pathlib
import re
import subprocess
import sys

import granum


def run(*arguments, cwd):
    folder = str(pathlib.Path(granum.__file__).resolve().parents[1])
    # One cache for all tests, for the types of numpy take seconds to read.
    environment = {**os.environ, "MYPY_CACHE_DIR": str(cwd.parent / "types"), "PYTHONPATH": folder}
    done = subprocess.run(
        [sys.executable, "-m", *arguments], cwd=cwd, env=environment, capture_output=True, text=True
    )
    return done.returncode, done.stdout + done.stderr


def test_stubs_are_those_of_the_package(source, tmp_path):
    allowed = source / "python" / "tests" / "stubtest_allowed.txt"
    code, said = run("mypy.stubtest", "granum", "--allowlist", str(allowed), cwd=tmp_path)
    assert code == 0, said


def test_where_the_module_cannot_be_imported_any_use_passes(source, tmp_path):
    (tmp_path / "module").mkdir()
    made = subprocess.run(
        [sys.executable, source / "python" / "make_stub.py", source / "python" / "granum", "module", "made.pyi"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
    )
    assert made.returncode == 0 and "cannot be imported here" in made.stderr, made.stderr
    (tmp_path / "user.py").write_text("import made\nreveal_type(made.sphere(radius='any'))\n")
    code, said = run("mypy", "--strict", "user.py", cwd=tmp_path)
    assert code == 0 and 'Revealed type is "Any"' in said, said


def test_the_examples_have_the_right_types(source, tmp_path):
    examples = sorted((source / "examples" / "python").glob("*.py"))
    code, said = run("mypy", "--strict", *map(str, examples), cwd=tmp_path)
    assert code == 0 and f"{len(examples)} source files" in said, said
    wrong = tmp_path / "wrong.py"
    wrong.write_text(
        examples[1].read_text() + "granum.measure(1)\ngranum.sphere(poisson_ratio=0.1)\nfound.colour\n"
    )
    code, said = run("mypy", "--strict", str(wrong), cwd=tmp_path)
    assert code == 1 and said.count("error:") == 4, said


def test_numbers_give_floats_and_arrays_give_arrays(tmp_path):
    (tmp_path / "shapes.py").write_text(
        """
import granum

law = granum.sphere(shear_modulus=30e9, poisson_ratio=0.15, radius=5e-4)
beads = granum.packing_answer(law=law, radius=5e-4, void_ratio=0.6, pressure=1e5)
path = granum.packing_answer(law=law, radius=5e-4, void_ratio=0.6, pressure=[1e5, 2e5])
reveal_type(beads.shear_modulus.value)
reveal_type(path.shear_modulus.value)
reveal_type(law.force(1e-6))
reveal_type(law.force([1e-6]))
"""
    )
    code, said = run("mypy", "--strict", "shapes.py", cwd=tmp_path)
    revealed = re.findall(r'Revealed type is "([\w.]+)', said)
    assert code == 0 and revealed == ["builtins.float", "numpy.ndarray"] * 2, said


def test_a_sand_gives_a_sand_and_spheres_give_spheres(tmp_path):
    (tmp_path / "kinds.py").write_text(
        """
import granum

law = granum.sphere(shear_modulus=30e9, poisson_ratio=0.15, radius=5e-4)
reveal_type(granum.infer(law=law, radius=5e-4, void_ratio=0.6, pressure=1e5, G=1e8, relative_error=0.02))
reveal_type(
    granum.infer(law=law, radius=5e-4, void_ratio=0.6, pressure=1e5, G=1e8, relative_error=0.02, sand="toyoura")
)
reveal_type(
    granum.infer(law=law, radius=5e-4, void_ratio=0.6, pressure=1e5, G=1e8, relative_error=0.02, grain_shape="sand")
)
"""
    )
    code, said = run("mypy", "--strict", "kinds.py", cwd=tmp_path)
    revealed = re.findall(r'Revealed type is "granum\.(\w+)', said)
    assert code == 0 and revealed == ["Inference", "SandInference", "SandInference"], said


def test_the_notebooks_have_the_right_types(source, tmp_path):
    notebooks = sorted((source / "examples" / "notebooks").glob("*.ipynb"))
    for notebook in notebooks:
        cells = json.loads(notebook.read_text())["cells"]
        code = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]
        (tmp_path / f"notebook_{notebook.stem}.py").write_text("\n".join(code) + "\n")
    files = sorted(tmp_path.glob("notebook_*.py"))
    # matplotlib of Debian 12 comes without types
    code, said = run("mypy", "--strict", "--ignore-missing-imports", *map(str, files), cwd=tmp_path)
    assert code == 0 and f"{len(notebooks)} source files" in said, said
