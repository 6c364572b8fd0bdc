# SPDX-License-Identifier: GPL-3.0-or-later
# The compiled part; its types are in __init__.pyi, under the names of the package.
from typing import Any

def __getattr__(name: str) -> Any: ...
