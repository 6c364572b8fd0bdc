// SPDX-License-Identifier: GPL-3.0-or-later
// With w = C_n (1 - porosity) the mean force is 4 pi R^2 p/w, and K = c w (p/w)^b with c = k_n at the force
// 4 pi R^2 1 Pa over 6 pi R: one root a row. This file is compiled without math errno and trapping
// (CMakeLists.txt), which lets the loops become vector code; neither changes a result.
#include <granum/effective/batch.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numbers>

#include <granum/core/error.hpp>
#include <granum/core/stop.hpp>

#include "core/vector/power.hpp"
#include "core/vector/stream.hpp"

namespace granum::effective {

namespace {

constexpr double most_pressure = 1e200;
constexpr double most_contacts = 1e6;
/// Rows at a time: all arrays of one block stay in the first cache.
constexpr std::size_t block_size = 256;
struct alignas(64) Block : std::array<double, block_size> {};

/// Pressures are multiplied by 2^180 under the root, so that no product of small numbers is subnormal.
constexpr double lift = 0x1p180;

/// Inputs of one block of rows.
struct Inputs {
  const double* pressure;
  const double* coordination_number;
  const double* porosity;
  std::size_t count;
};

/// Results of one block of rows.
struct Results {
  double* bulk_modulus;
  double* shear_modulus;
  double shear_by_bulk;
};

/// Intermediate values of one block.
struct Work {
  Block x; ///< arguments of the root
  Block y;
  Block z;
};

/// A rule computes the stiffness of a block in three passes: argument() writes each row's argument of the
/// root to x (0 for a row without forces), the second takes the roots, and root() reads each row's root,
/// which is then multiplied by `factor`.
struct SphereRule {
  double factor; ///< c 2^-60
  GRANUM_INLINE static void argument(Work& work, std::size_t k, double w, double p, bool good) {
    const double x = w * w * (p * lift);
    work.x[k] = good ? x : 0.0;
    work.y[k] = inverse_cube_root_guess(work.x[k]);
  }
  GRANUM_INLINE static void pass(Work& work, std::size_t k) {
    work.y[k] = inverse_cube_root_step(work.x[k], work.y[k]);
  }
  GRANUM_INLINE double root(const Work& work, std::size_t k) const {
    return cube_root_from(work.x[k], work.y[k]);
  }
};
struct ConeRule {
  double factor; ///< c 2^-90
  GRANUM_INLINE static void argument(Work& work, std::size_t k, double w, double p, bool good) {
    const double x = w * (p * lift);
    work.x[k] = good ? x : 0.0;
  }
  GRANUM_INLINE static void pass(Work&, std::size_t) {}
  GRANUM_INLINE static double root(const Work& work, std::size_t k) { return std::sqrt(work.x[k]); }
};
struct FlatRule {
  double factor; ///< c
  GRANUM_INLINE static void argument(Work& work, std::size_t k, double w, double, bool good) {
    work.x[k] = good ? w : 0.0;
  }
  GRANUM_INLINE static void pass(Work&, std::size_t) {}
  GRANUM_INLINE static double root(const Work& work, std::size_t k) { return work.x[k]; }
};
struct GeneralRule {
  double factor; ///< c 2^(-180 b)
  SplitExponent b;
  GRANUM_INLINE static void argument(Work& work, std::size_t k, double w, double p, bool good) {
    const bool loaded = good & (p > 0) & (w > 0);
    const double ratio = p * lift / w;
    work.x[k] = loaded ? w : 0.0;
    work.y[k] = loaded ? ratio : 1.0;
  }
  GRANUM_INLINE static void pass(Work& work, std::size_t k) {
    const Log2 log2 = log2_of<always_fused>(work.y[k]);
    work.y[k] = log2.whole;
    work.z[k] = log2.part;
  }
  GRANUM_INLINE double root(const Work& work, std::size_t k) const {
    return work.x[k] * power_from<always_fused>({work.y[k], work.z[k]}, b);
  }
};

/// A law that is not a power of the force: k_n at each row's mean force.
struct AnyRule {
  double factor; ///< c/k_n
  double area;   ///< 4 pi R^2 [m^2]
  const contact::NormalLaw& law;
  GRANUM_INLINE static void argument(Work& work, std::size_t k, double w, double p, bool good) {
    const bool touch = good & (w > 0);
    work.x[k] = touch ? w : 0.0;
    work.y[k] = touch ? p / w : 0.0;
  }
  GRANUM_INLINE static void pass(Work&, std::size_t) {}
  GRANUM_INLINE double root(const Work& work, std::size_t k) const {
    return work.x[k] * law.stiffness_at_force(area * work.y[k]);
  }
};

/// NaN fails every comparison.
GRANUM_INLINE bool is_good(double p, double C, double n) {
  return (p >= 0) & (p <= most_pressure) & (C >= 0) & (C <= most_contacts) & (n > 0) & (n < 1);
}

/// Bad rows are computed as rows without forces, with moduli of 0. Returns whether all rows are good.
template <class Rule>
GRANUM_INLINE bool prepare_at_level(const Inputs& in, Work& work) {
  const double* const __restrict pressure = in.pressure;
  const double* const __restrict contacts = in.coordination_number;
  const double* const __restrict porosity = in.porosity;
  std::uint64_t passed = 0;
  for (std::size_t k = 0; k < in.count; ++k) {
    const double p = pressure[k], C = contacts[k], n = porosity[k];
    const bool good = is_good(p, C, n);
    Rule::argument(work, k, C * (1 - n), p, good);
    passed += static_cast<std::uint64_t>(good);
  }
  return passed == in.count;
}

template <class Rule>
GRANUM_INLINE void finish_at_level(const Rule& rule, Work& work, const Results& out, std::size_t count) {
  double* const __restrict bulk = out.bulk_modulus;
  double* const __restrict shear = out.shear_modulus;
  for (std::size_t k = 0; k < count; ++k)
    Rule::pass(work, k);
  for (std::size_t k = 0; k < count; ++k) {
    const double K = rule.factor * rule.root(work, k);
    bulk[k] = K;
    shear[k] = out.shear_by_bulk * K;
  }
}

template <class Rule>
bool prepare(const Rule&, VectorLevel level, const Inputs& in, Work& work) {
  bool good = false;
  at_vector_level(
      [&](auto) __attribute__((always_inline)) { good = prepare_at_level<Rule>(in, work); }, level);
  return good;
}

template <class Rule>
void finish(const Rule& rule, VectorLevel level, Work& work, const Results& out, std::size_t count) {
  at_vector_level(
      [&](auto) __attribute__((always_inline)) { finish_at_level(rule, work, out, count); }, level);
}

/// The rows of a column from `first` on: its own memory, or a block filled with its one value.
class Reader {
 public:
  Reader(const BatchInput& column, std::size_t rows) : column_(column) {
    if (!column.varies())
      std::fill_n(constant_.begin(), std::min(rows, block_size), column[0]);
  }
  [[nodiscard]] const double* from(std::size_t first) const {
    return column_.varies() ? column_.values().data() + first : constant_.data();
  }

 private:
  const BatchInput& column_;
  Block constant_;
};

void require_length(const char* name, const BatchInput& column, std::size_t rows) {
  if (column.varies() && column.size() != rows)
    throw InvalidArgument(std::string(name) + " has " + std::to_string(column.size()) +
                          " rows, the results have " + std::to_string(rows));
}

/// Error message of a refused row; returned and not thrown, because some targets cannot catch exceptions.
std::string complaint(double pressure, double coordination_number, double porosity) {
  const auto outside = [](const char* name, double value, const char* unit, const std::string& range) {
    return std::string(InvalidArgument(name, value, unit, range).what());
  };
  if (!(pressure >= 0 && pressure <= most_pressure))
    return outside("pressure", pressure, "Pa", detail::closed_range(0, most_pressure, pressure));
  if (!(coordination_number >= 0 && coordination_number <= most_contacts))
    return outside("coordination_number", coordination_number, "",
                   detail::closed_range(0, most_contacts, coordination_number));
  return outside("porosity", porosity, "", detail::open_range(0, 1, porosity));
}

/// Results that exceed the caches are written past them, which saves reading their old content first.
constexpr std::size_t rows_beyond_caches = std::size_t{1} << 17;

/// Counts the bad rows of a block and records the error messages of the first ones.
void report_bad_rows(const Inputs& in, std::size_t first, BatchReport& report) {
  for (std::size_t k = 0; k < in.count; ++k) {
    const double p = in.pressure[k], C = in.coordination_number[k], n = in.porosity[k];
    if (!is_good(p, C, n) && ++report.failed <= BatchReport::most_errors)
      report.errors.push_back({first + k, complaint(p, C, n)});
  }
}

template <class Rule>
BatchReport run(const Rule& rule, const PackingBatch& b, const ModuliColumns& moduli) {
  const double shear_by_bulk = 0.3 * (2 + 3 * b.tangential_ratio);
  const std::size_t rows = moduli.bulk_modulus.size();
  const Reader pressure(b.pressure, rows), contacts(b.coordination_number, rows), porosity(b.porosity, rows);
  const bool past_caches = rows >= rows_beyond_caches;
  const VectorLevel level = vector_level();
  BatchReport report;
  Work work;
  Block bulk, shear;
  for (std::size_t first = 0; first < rows; first += block_size) {
    stop_point(first / block_size);
    const std::size_t count = std::min(block_size, rows - first);
    const Inputs in{pressure.from(first), contacts.from(first), porosity.from(first), count};
    double* const K = moduli.bulk_modulus.data() + first;
    double* const G = moduli.shear_modulus.data() + first;
    if (!prepare(rule, level, in, work))
      report_bad_rows(in, first, report);
    if (!past_caches) {
      finish(rule, level, work, {K, G, shear_by_bulk}, count);
    } else {
      finish(rule, level, work, {bulk.data(), shear.data(), shear_by_bulk}, count);
      store_past_caches(bulk.data(), count, K);
      store_past_caches(shear.data(), count, G);
    }
  }
  if (past_caches)
    finish_stores();
  return report;
}

} // namespace

BatchReport uniform_strain(const PackingBatch& b, const ModuliColumns& moduli) {
  require_non_negative("tangential_ratio", b.tangential_ratio);
  require_positive("radius", b.radius, "m");
  sizes::require_valid(b.contacts);
  const std::size_t rows = moduli.bulk_modulus.size();
  if (moduli.shear_modulus.size() != rows)
    throw InvalidArgument("shear_modulus has " + std::to_string(moduli.shear_modulus.size()) +
                          " rows, bulk_modulus has " + std::to_string(rows));
  require_length("pressure", b.pressure, rows);
  require_length("coordination_number", b.coordination_number, rows);
  require_length("porosity", b.porosity, rows);

  const auto& [branch, branch_square, pair_radius, grain_volume] = b.contacts;
  const double area = 4 * std::numbers::pi * b.radius * b.radius * (grain_volume / branch);
  const double c =
      b.law.stiffness_at_force(area) / (6 * std::numbers::pi * b.radius) * (branch_square / grain_volume);
  const contact::PowerLaw* const power = b.law.power_law();
  if (power == nullptr)
    return run(AnyRule{c / b.law.stiffness_at_force(area), area, b.law}, b, moduli);
  if (power->alpha() == 2)
    return run(SphereRule{c * 0x1p-60}, b, moduli);
  if (power->alpha() == 1)
    return run(ConeRule{c * 0x1p-90}, b, moduli);
  const double exponent = power->stiffness_exponent();
  if (exponent == 0)
    return run(FlatRule{c}, b, moduli);
  return run(GeneralRule{c * std::exp2(-180 * exponent), SplitExponent(exponent)}, b, moduli);
}

} // namespace granum::effective
