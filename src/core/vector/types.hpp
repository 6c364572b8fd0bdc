// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src. Vectors of numbers, of the compiler's own kind: a level with narrower registers works them
// out in parts.
#pragma once

namespace granum {

using Two = double __attribute__((vector_size(2 * sizeof(double))));
using Four = double __attribute__((vector_size(4 * sizeof(double))));
using Eight = double __attribute__((vector_size(8 * sizeof(double))));

/// To read and write them where single numbers are stored.
using TwoInMemory __attribute__((may_alias)) = Two;
using FourInMemory __attribute__((may_alias)) = Four;
using EightInMemory __attribute__((may_alias)) = Eight;

} // namespace granum
