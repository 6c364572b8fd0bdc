// SPDX-License-Identifier: GPL-3.0-or-later
// What nearly every test of the sources begins with.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <doctest/doctest.h>
#include <granum/core/error.hpp>

#include "relative.hpp"

using namespace granum;
