# SPDX-License-Identifier: GPL-3.0-or-later
# The compiled part; its types stand in __init__.pyi, under the names that the package gives them.
from typing import Any

def __getattr__(name: str) -> Any: ...
