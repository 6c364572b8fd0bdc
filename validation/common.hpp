// SPDX-License-Identifier: GPL-3.0-or-later
// What nearly every program of validation uses.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <granum/core/text.hpp>

#include "claims.hpp"
#include "errors.hpp"
#include "record.hpp"
