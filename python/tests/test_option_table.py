# SPDX-License-Identifier: GPL-3.0-or-later
"""Every option of estimate, infer, sweep and analyse is an argument in Python, or stands here with the reason.

The options are those that help lists, which the program makes of its table of options.
"""

import inspect
import os
import re
import subprocess

import granum
import pytest

# The function of each command, whose arguments are its options in Python.
OWN = {"estimate": "packing_answer", "infer": "infer", "sweep": "packing_answer", "analyse": "measure"}
COMMANDS = tuple(OWN)

# What says in Python what an option says that is no such argument: function.argument, of methods
# Class.method.argument. Options of one name mean the same in all commands, unless the command stands before them.
ARGUMENTS = {
    "strain": "packing_answer.shear_strain",
    "profile": "profile.slices",
    "fabric": "packing_answer.fabric_anisotropy",
    "grain-shear-modulus": "sphere.shear_modulus",
    "grain-poisson-ratio": "sphere.poisson_ratio",
    "grain-bulk-modulus": "sphere.bulk_modulus",
    "grain": "minerals",
    "contact": "packing_answer.law",
    "slope": "cone.slope",
    "punch-radius": "flat_punch.punch_radius",
    "alpha": "power_law.alpha",
    "profile-constant": "power_law.profile_constant",
    "roughness": "rough_sphere.roughness",
    "sizes": "packing_answer.contact_means",
    "sieve": "Distribution",
    "bounds": "uniform_stress",
    "tolerance": "estimate.tolerance",
    "strict": "packing_answer.strict",
    "cement": "cement_at_contacts.cement_saturation",
    "shear-modulus": "infer.G",
    "shear-modulus-hh": "infer.G_hh",
    "bulk-modulus": "infer.K",
    "shear-wave-speed": "infer.V_s",
    "shear-wave-speed-hh": "infer.V_s_hh",
    "compression-wave-speed": "infer.V_p",
    "compression-wave-speed-h": "infer.V_p_h",
    "measurement-error": "infer.relative_error",
    "predict-pressure": "Inference.predict.pressure",
    "predict-void-ratio": "Inference.predict.void_ratio",
    "predict-stress-ratio": "Inference.predict.stress_h",
    "path": "stress_on_path.path",
    "from": "stress_on_path.pressure",
    "eta": "stress_on_path.eta",
    "friction-angle": "failure_ratio.friction_angle",
    "analyse friction-angle": "measure.friction_coefficient",
    "depth": "ground_stress.depth",
    "analyse depth": "measure.window",
    "unit-weight": "ground_stress.unit_weight",
    "saturated-unit-weight": "ground_stress.saturated_unit_weight",
    "water-table": "ground_stress.water_table",
    "water-unit-weight": "ground_stress.water_unit_weight",
    "k0": "ground_stress.earth_pressure_at_rest",
    "surcharge": "ground_stress.surcharge",
    "rungs": "answer.rung",
    "laws": "sand_shear_modulus.law",
    "material": "measure.materials",
    "column-map": "read.columns",
    "box": "read.box",
    "units": "read.units",
    "frames": "frames.files",
    "no-network": "measure.network",
    "series": "fit.shear_modulus",
    "modes": "lowest_modes.count",
    "hessian": "stiffness_matrix",
}

_WORDS = "another word for the void ratio, a line of arithmetic"
_FILES = "files are Python's own; results go to pandas by to_columns()"
_ARRAYS = "numpy makes arrays of states"
EXCEPTIONS = {
    "densest": "specimen(kind=\"dense\").void_ratio makes one; least_void_ratio takes it",
    "porosity": _WORDS,
    "solid-fraction": _WORDS,
    "json": _FILES,
    "out": _FILES,
    "force": _FILES,
    "report": _FILES,
    "full": "how much the program prints; Python has every number",
    "columns": _FILES,
    "picture": "results have plot(), or matplotlib draws their arrays",
    "picture-of": "results have plot(), or matplotlib draws their arrays",
    "paraview": "ParaView's files are written by the program alone",
    "xyz": "OVITO's files are written by the program alone",
    "table": _ARRAYS,
    "layers": _ARRAYS,
    "for": "packing_answer at a strain; numpy makes the curve, and pystrata takes its arrays",
    "units": _FILES,
    "to": _ARRAYS,
    "spacing": _ARRAYS,
    "points": _ARRAYS,
    "axis": "arrays of another order turn a packing",
    "stress": "compared by hand with stress.tensor of a Measurement",
    "probes": "compared by hand with network.relaxed of a Measurement",
    "threads": "the network takes all cores; results do not depend on it",
    "help": "help() of Python",
}


def options_of(command):
    """Names of a command's options without dashes, the first of those that mean the same."""
    text = subprocess.run(
        [os.environ["GRANUM_PROGRAM"], command, "--help"], capture_output=True, text=True, check=True
    ).stdout
    return re.findall(r"^  (?:-\w, )?--([\w-]+)", text, re.M)


def is_there(target):
    """Whether the package has this function or class, and the function this argument."""
    name, *parts = target.split(".")
    value = getattr(granum, name, None)
    if len(parts) == 2:
        value = getattr(value, parts.pop(0), None)
    if value is None or not parts:
        return value is not None
    return parts[0] in inspect.signature(value).parameters


@pytest.mark.parametrize("command", COMMANDS)
def test_every_option_is_in_python(command):
    options = options_of(command)
    assert len(options) > 20
    for option in options:
        if is_there(f"{OWN[command]}.{option.replace('-', '_')}"):
            continue
        keys = [key for key in (f"{command} {option}", option) if key in ARGUMENTS or key in EXCEPTIONS]
        assert keys, f"--{option} of {command} is neither an argument in Python nor an exception with its reason"
        assert keys[0] in EXCEPTIONS or is_there(ARGUMENTS[keys[0]]), (option, ARGUMENTS[keys[0]])


def test_the_tables_name_options_of_the_program():
    known = {f"{command} {option}" for command in COMMANDS for option in options_of(command)}
    plain = {key.split(" ", 1)[1] for key in known}
    for key in [*ARGUMENTS, *EXCEPTIONS]:
        assert key in (known if " " in key else plain), f"no command has the option {key}"
    assert not is_there("infer.colour") and not is_there("colour") and not is_there("Inference.predict.colour")
