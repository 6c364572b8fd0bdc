// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <memory>

#include <granum/io/imported_packing.hpp>

namespace granum::python {

/// A packing in Python, read or given. It is never modified, because arrays are views of its memory.
using Packing = io::ImportedPacking;
using SharedPacking = std::shared_ptr<Packing>;

} // namespace granum::python
