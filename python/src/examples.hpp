// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

/// An example for every public name of the package: the section Examples of its docstring, and of its page of
/// the site. Each begins behind `import granum` and `import numpy as np`, in the folder of the sources.
/// Checked by python/tests/test_documentation.py
namespace granum::python {

/// By name, from examples.inc, where a block is headed by the names that it is for.
[[nodiscard]] const std::map<std::string, std::string, std::less<>>& examples();

/// The section Examples, the last one of a docstring; empty for a name without an example.
[[nodiscard]] std::string examples_section(const std::string& name);

} // namespace granum::python
