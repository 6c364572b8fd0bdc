// SPDX-License-Identifier: GPL-3.0-or-later
// With w = C_n (1 - porosity) the mean force is 4 pi R^2 p/w, and K = c w (p/w)^b with c = k_n at the force
// 4 pi R^2 1 Pa over 6 pi R: one root a row. This file is compiled without math errno and trapping
// (CMakeLists.txt), which lets the loops become vector code; neither changes a result.
#include <granum/effective/batch.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numbers>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include <granum/core/check.hpp>
#include <granum/core/error.hpp>

#include "vector_math.hpp"

// Same source for each vector level, chosen when the program starts; x86-64-v3 stands for AVX2 with FMA.
// Sanitized builds take the plain one: their runtime starts after the choice is made.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define GRANUM_VECTOR_LEVELS __attribute__((target_clones("avx512f", "arch=x86-64-v3", "default")))
#else
#define GRANUM_VECTOR_LEVELS
#endif

namespace granum::effective {

namespace {

constexpr double most_pressure = 1e200;
constexpr double most_contacts = 1e6;
/// Rows at a time: five arrays of them stay in the first cache.
constexpr std::size_t block_size = 256;
using Block = std::array<double, block_size>;

/// Pressures are multiplied by 2^180 under the root, so that no product of small numbers is subnormal.
constexpr double lift = 0x1p180;

struct SphereRule {
  double factor; ///< c 2^-60
  [[gnu::always_inline]] double operator()(double w, double p) const {
    return factor * vector_math::cube_root(w * w * (p * lift));
  }
};
struct ConeRule {
  double factor; ///< c 2^-90
  [[gnu::always_inline]] double operator()(double w, double p) const {
    return factor * std::sqrt(w * (p * lift));
  }
};
struct FlatRule {
  double factor; ///< c
  [[gnu::always_inline]] double operator()(double w, double) const { return factor * w; }
};
struct GeneralRule {
  double factor; ///< c 2^(-180 b)
  vector_math::Exponent b;
  [[gnu::always_inline]] double operator()(double w, double p) const {
    const double K = factor * w * vector_math::power(p * lift / w, b);
    return (p > 0) & (w > 0) ? K : 0.0;
  }
};

/// Inputs and results of one block of rows.
struct Rows {
  const double* pressure;
  const double* coordination_number;
  const double* porosity;
  double* bulk_modulus;
  double* shear_modulus;
  std::size_t count;
};

/// Results of good rows, zeros for bad ones; whether there are bad ones. NaN fails every comparison.
template <class Rule>
[[gnu::always_inline]] inline bool sweep(const Rule& rule, double shear_by_bulk, const Rows& rows) {
  const double* const __restrict pressure = rows.pressure;
  const double* const __restrict contacts = rows.coordination_number;
  const double* const __restrict porosity = rows.porosity;
  double* const __restrict bulk = rows.bulk_modulus;
  double* const __restrict shear = rows.shear_modulus;
  std::uint64_t bad = 0;
  for (std::size_t k = 0; k < rows.count; ++k) {
    const double p = pressure[k], C = contacts[k], n = porosity[k];
    const bool good = (p >= 0) & (p <= most_pressure) & (C >= 0) & (C <= most_contacts) & (n > 0) & (n < 1);
    const double value = rule(C * (1 - n), p);
    const double K = good ? value : 0.0;
    bulk[k] = K;
    shear[k] = shear_by_bulk * K;
    bad += static_cast<std::uint64_t>(!good);
  }
  return bad != 0;
}

GRANUM_VECTOR_LEVELS bool sweep_of(const SphereRule& rule, double shear_by_bulk, const Rows& rows) {
  return sweep(rule, shear_by_bulk, rows);
}
GRANUM_VECTOR_LEVELS bool sweep_of(const ConeRule& rule, double shear_by_bulk, const Rows& rows) {
  return sweep(rule, shear_by_bulk, rows);
}
GRANUM_VECTOR_LEVELS bool sweep_of(const FlatRule& rule, double shear_by_bulk, const Rows& rows) {
  return sweep(rule, shear_by_bulk, rows);
}
GRANUM_VECTOR_LEVELS bool sweep_of(const GeneralRule& rule, double shear_by_bulk, const Rows& rows) {
  return sweep(rule, shear_by_bulk, rows);
}

/// The rows of a column from `first` on: its own memory, or a block filled with its one value.
class Reader {
 public:
  explicit Reader(const Column& column) : column_(column) {
    if (!column.varies())
      constant_.fill(column[0]);
  }
  [[nodiscard]] const double* from(std::size_t first) const {
    return column_.varies() ? column_.values().data() + first : constant_.data();
  }

 private:
  const Column& column_;
  Block constant_;
};

void require_length(const char* name, const Column& column, std::size_t rows) {
  if (column.varies() && column.size() != rows)
    throw InvalidArgument(std::string(name) + " has " + std::to_string(column.size()) +
                          " rows, the results have " + std::to_string(rows));
}

/// What is wrong with a row that was refused.
std::string complaint(double pressure, double coordination_number, double porosity) {
  try {
    require_closed("pressure", pressure, 0, most_pressure, "Pa");
    require_closed("coordination_number", coordination_number, 0, most_contacts);
    require_open("porosity", porosity, 0, 1);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return {};
}

/// Results that exceed the caches are written past them, which saves reading their old content first.
constexpr std::size_t rows_beyond_caches = std::size_t{1} << 17;

void store(const Block& from, std::size_t count, double* to, bool past_caches) {
#if defined(__SSE2__)
  if (past_caches && reinterpret_cast<std::uintptr_t>(to) % 16 == 0 && count % 2 == 0) {
    for (std::size_t k = 0; k < count; k += 2)
      _mm_stream_pd(to + k, _mm_loadu_pd(from.data() + k));
    return;
  }
#endif
  (void)past_caches;
  std::copy_n(from.data(), count, to);
}

/// Orders the stores of store() before all that follows.
void finish_stores() {
#if defined(__SSE2__)
  _mm_sfence();
#endif
}

template <class Rule>
BatchReport run(const Rule& rule, const PackingBatch& b, const ModuliColumns& moduli) {
  const double shear_by_bulk = 0.3 * (2 + 3 * b.tangential_ratio);
  const Reader pressure(b.pressure), contacts(b.coordination_number), porosity(b.porosity);
  const bool past_caches = moduli.bulk_modulus.size() >= rows_beyond_caches;
  BatchReport report;
  Block bulk, shear;
  for (std::size_t first = 0; first < moduli.bulk_modulus.size(); first += block_size) {
    const std::size_t count = std::min(block_size, moduli.bulk_modulus.size() - first);
    Rows rows{pressure.from(first), contacts.from(first), porosity.from(first),
              bulk.data(),          shear.data(),         count};
    if (sweep_of(rule, shear_by_bulk, rows))
      for (std::size_t k = 0; k < count; ++k) {
        std::string text = complaint(rows.pressure[k], rows.coordination_number[k], rows.porosity[k]);
        if (text.empty())
          continue;
        if (++report.failed <= BatchReport::most_errors)
          report.errors.push_back({first + k, std::move(text)});
      }
    store(bulk, count, moduli.bulk_modulus.data() + first, past_caches);
    store(shear, count, moduli.shear_modulus.data() + first, past_caches);
  }
  finish_stores();
  return report;
}

} // namespace

BatchReport uniform_strain(const PackingBatch& b, const ModuliColumns& moduli) {
  require_non_negative("tangential_ratio", b.tangential_ratio);
  require_positive("radius", b.radius, "m");
  const std::size_t rows = moduli.bulk_modulus.size();
  if (moduli.shear_modulus.size() != rows)
    throw InvalidArgument("shear_modulus has " + std::to_string(moduli.shear_modulus.size()) +
                          " rows, bulk_modulus has " + std::to_string(rows));
  require_length("pressure", b.pressure, rows);
  require_length("coordination_number", b.coordination_number, rows);
  require_length("porosity", b.porosity, rows);

  const double area = 4 * std::numbers::pi * b.radius * b.radius;
  const double c = b.law.stiffness_at_force(area) / (6 * std::numbers::pi * b.radius);
  if (b.law.alpha() == 2)
    return run(SphereRule{c * 0x1p-60}, b, moduli);
  if (b.law.alpha() == 1)
    return run(ConeRule{c * 0x1p-90}, b, moduli);
  const double exponent = b.law.stiffness_exponent();
  if (exponent == 0)
    return run(FlatRule{c}, b, moduli);
  return run(GeneralRule{c * std::exp2(-180 * exponent), vector_math::exponent(exponent)}, b, moduli);
}

} // namespace granum::effective
