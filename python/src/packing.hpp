// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <memory>

#include <granum/io/imported_packing.hpp>

namespace granum::python {

/// A packing of Python: what was read or given, which nobody changes any more, as arrays show its memory.
using Packing = io::ImportedPacking;
using SharedPacking = std::shared_ptr<Packing>;

} // namespace granum::python
