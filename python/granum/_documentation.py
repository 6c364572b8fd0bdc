# SPDX-License-Identifier: GPL-3.0-or-later
"""Examples in the docstrings of classes and of what is written in Python; the compiled functions have theirs."""

import inspect

from ._granum import _examples


def _attach(package):
    """Adds the section Examples to the docstrings of these names that have none."""
    for name, example in _examples.items():
        value = package[name]
        if value.__doc__ and "\nExamples\n" not in value.__doc__:
            value.__doc__ = f"{inspect.cleandoc(value.__doc__)}\n\nExamples\n--------\n{example}\n"
