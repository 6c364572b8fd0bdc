// SPDX-License-Identifier: GPL-3.0-or-later
// Laws of the small-strain shear modulus of sands against a table of tests that the user has.
//     sands <table.csv>
// Columns: sand (a number or name), C_u, p_kPa, e, G_MPa; D50_mm, e_min and e_max where they are known.
// Prints, for each law and each form of the pooled one, bias, root mean square of log10 and the share of
// tests within factors, each sand with the same weight; then the pooled law by sand, its constants fitted
// again, and forecasts from one test to another of one sand. Exit code 0 unless the table cannot be read.
#include <Eigen/Cholesky>
#include <granum/core/error.hpp>
#include <granum/io/csv/table.hpp>
#include <granum/sands/known_sands.hpp>
#include <granum/sands/pooled_law.hpp>

#include "../common.hpp"

namespace {

using namespace granum;

struct Test {
  std::string sand;
  sands::Sand known;
  double void_ratio, mean_stress, shear_modulus;
};

std::vector<Test> read_tests(const std::string& file) {
  const io::CsvTable table = io::read_csv(file);
  const auto number = [&](std::size_t row, const char* name, Dimension dimension) -> std::optional<double> {
    if (!table.has(name))
      return std::nullopt;
    const io::CsvTable::Place place = table.column(name, dimension);
    const auto value = parse_number(table.fields(row)[place.index]);
    return value ? std::optional(*value * place.factor) : std::nullopt;
  };
  std::size_t names = 0;
  while (names < table.headings().size() && table.headings()[names] != "sand")
    ++names;
  if (names == table.headings().size())
    throw FileError(file, 0, "has no column 'sand'");
  std::vector<Test> tests;
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    const auto p = number(row, "p", Dimension::pressure), G = number(row, "G", Dimension::pressure),
               e = number(row, "e", Dimension::dimensionless);
    if (!p || !G || !e)
      continue;
    tests.push_back({table.fields(row)[names],
                     {.uniformity = number(row, "C_u", Dimension::dimensionless),
                      .d50 = number(row, "D50", Dimension::length),
                      .least_void_ratio = number(row, "e_min", Dimension::dimensionless),
                      .largest_void_ratio = number(row, "e_max", Dimension::dimensionless)},
                     *e,
                     *p,
                     *G});
  }
  return tests;
}

/// Relative density between the limits of the sand.
double D_r_of(const Test& t) {
  return (*t.known.largest_void_ratio - t.void_ratio) /
         (*t.known.largest_void_ratio - *t.known.least_void_ratio);
}

/// The void ratio at which the library answers: of D_r and C_u alone it is that of usual limits.
double answered_void_ratio(const sands::Sand& sand, double void_ratio) {
  if (!sand.relative_density || sand.least_void_ratio || !sand.uniformity)
    return void_ratio;
  const sands::UsualLimits usual = sands::usual_limits(sand.uniformity);
  return usual.largest - *sand.relative_density * (usual.largest - usual.least);
}

/// log10 of estimate over measured, sand by sand.
using Misses = std::map<std::string, std::vector<double>>;

/// The mean of a function of the misses, each sand with the same weight.
template <class Of>
double mean(const Misses& misses, const Of& of) {
  double sum = 0;
  for (const auto& [sand, values] : misses)
    for (const double value : values)
      sum += of(value) / static_cast<double>(values.size());
  return sum / static_cast<double>(misses.size());
}
double bias_of(const Misses& misses) {
  return std::pow(10, mean(misses, [](double x) { return x; }));
}
double rms_of(const Misses& misses) {
  return std::sqrt(mean(misses, [](double x) { return x * x; }));
}
/// Share of values that are at most so large.
double covered_by(const Misses& misses, double largest) {
  return mean(misses, [=](double x) { return std::abs(x) <= largest ? 1 : 0; });
}
double covered(const Misses& misses, double factor) { return covered_by(misses, std::log10(factor)); }

void print(const char* name, const Misses& misses) {
  if (misses.empty())
    return;
  std::size_t tests = 0;
  for (const auto& [sand, values] : misses)
    tests += values.size();
  std::printf("  %-28s %3zu %5zu   %5.3f   %5.3f   %3.0f %% %3.0f %% %3.0f %%\n", name, misses.size(), tests,
              bias_of(misses), rms_of(misses), 100 * covered(misses, 1.15), 100 * covered(misses, 1.4),
              100 * covered(misses, 1.96));
}

/// \param    estimate   of a test; none: left out
Misses misses_of(const std::vector<Test>& tests,
                 const std::function<std::optional<double>(const Test&)>& estimate) {
  Misses misses;
  for (const Test& test : tests)
    if (const auto G = estimate(test))
      misses[test.sand].push_back(std::log10(*G / test.shear_modulus));
  return misses;
}

void print_levels(const std::vector<Test>& tests) {
  using Known = std::optional<sands::Sand>;
  static const auto limited = [](const Test& t) {
    return t.known.least_void_ratio && t.known.largest_void_ratio;
  };
  const struct {
    const char* name;
    Known (*known)(const Test&);
  } levels[] = {
      {"pooled: e alone", [](const Test&) { return Known(sands::Sand{}); }},
      {"pooled: e, C_u", [](const Test& t) { return Known({.uniformity = t.known.uniformity}); }},
      {"pooled: D_r",
       [](const Test& t) {
         return limited(t) && D_r_of(t) >= 0 && D_r_of(t) <= 1.2 ? Known({.relative_density = D_r_of(t)})
                                                                 : Known();
       }},
      {"pooled: D_r, C_u",
       [](const Test& t) {
         return limited(t) && t.known.uniformity
                    ? Known({.uniformity = t.known.uniformity, .relative_density = D_r_of(t)})
                    : Known();
       }},
      {"pooled: e, e_min, e_max",
       [](const Test& t) {
         return limited(t) ? Known({.least_void_ratio = t.known.least_void_ratio,
                                    .largest_void_ratio = t.known.largest_void_ratio})
                           : Known();
       }},
      {"pooled: all of these", [](const Test& t) { return limited(t) ? Known(t.known) : Known(); }},
  };
  std::printf("                             sands tests    bias     rms   within 1.15, 1.4, 1.96\n");
  for (const auto& [name, known] : levels)
    print(name, misses_of(tests, [known = known](const Test& t) -> std::optional<double> {
            const Known sand = known(t);
            if (!sand)
              return {};
            return sands::extrapolated_shear_modulus(*sand, answered_void_ratio(*sand, t.void_ratio),
                                                     t.mean_stress);
          }));
  for (const sands::MeasuredLaw& law : sands::measured_laws())
    print(law.key, misses_of(tests, [&](const Test& t) {
            sands::SandState state{.void_ratio = t.void_ratio, .mean_stress = t.mean_stress};
            state.uniformity = t.known.uniformity.value_or(state.uniformity);
            state.d50 = t.known.d50.value_or(state.d50);
            return sands::shear_modulus(law, state).shear_modulus;
          }));
}

/// How many of the biases lie within a factor.
std::size_t within(const std::vector<double>& biases, double factor) {
  return static_cast<std::size_t>(std::count_if(
      biases.begin(), biases.end(), [factor](double bias) { return std::max(bias, 1 / bias) <= factor; }));
}

void print_sands(const std::vector<Test>& tests) {
  std::printf("\nby sand: bias and rms of log10, of e and C_u, and of all that is known\n");
  std::map<std::string, std::vector<Test>> by_sand;
  for (const Test& test : tests)
    by_sand[test.sand].push_back(test);
  std::vector<double> biases, best_biases;
  for (const auto& [name, of_sand] : by_sand) {
    const auto misses = [&, &tests_of_it = of_sand](bool all) {
      return misses_of(tests_of_it, [all](const Test& t) {
        const sands::Sand known = all ? t.known : sands::Sand{.uniformity = t.known.uniformity};
        return sands::pooled_shear_modulus(known, t.void_ratio, t.mean_stress);
      });
    };
    const Misses graded = misses(false), best = misses(true);
    biases.push_back(bias_of(graded));
    best_biases.push_back(bias_of(best));
    std::printf("  %-10s C_u %4.2f  %3zu tests  %5.3f  %5.3f   %5.3f  %5.3f\n", name.c_str(),
                of_sand.front().known.uniformity.value_or(0), of_sand.size(), bias_of(graded), rms_of(graded),
                bias_of(best), rms_of(best));
  }
  for (const double factor : {1.08, 1.15, 1.25, 1.4})
    std::printf("  bias within %.2f: %2zu, %2zu of %zu sands\n", factor, within(biases, factor),
                within(best_biases, factor), biases.size());
}

/// A form of the law: ln of G over void-ratio factor and growth is constant + sum of coefficients x terms.
struct Form {
  const char* name;
  bool by_void_ratio; ///< G/F(e) is fitted, else G
  std::vector<double> (*terms)(const Test& t);
};

Eigen::VectorXd row_of(const Form& form, const Test& t) {
  const std::vector<double> terms = form.terms(t);
  Eigen::VectorXd row(static_cast<Eigen::Index>(terms.size()) + 1);
  row[0] = 1;
  for (std::size_t k = 0; k < terms.size(); ++k)
    row[static_cast<Eigen::Index>(k) + 1] = terms[k];
  return row;
}

double target_of(const Form& form, const Test& t) {
  const sands::Sand grading{.uniformity = t.known.uniformity};
  const double factor = form.by_void_ratio ? sands::hardin_richart_factor(2.97, t.void_ratio) : 1;
  return std::log(t.shear_modulus / factor / sands::growth_factor(grading, t.mean_stress));
}

/// The constants of a form by least squares, each sand with the same weight, without one of the sands.
Eigen::VectorXd fitted(const Form& form, const std::vector<Test>& tests, const std::string& without) {
  std::map<std::string, double> counts;
  for (const Test& t : tests)
    ++counts[t.sand];
  const auto n = static_cast<Eigen::Index>(form.terms(tests.front()).size()) + 1;
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  for (const Test& t : tests) {
    if (t.sand == without)
      continue;
    const Eigen::VectorXd row = row_of(form, t);
    normal += row * row.transpose() / counts[t.sand];
    right += row * target_of(form, t) / counts[t.sand];
  }
  return normal.ldlt().solve(right);
}

/// The fits of the pooled law, with its exponent of stress, repeated on these tests.
void print_fits(const std::vector<Test>& tests) {
  const Form forms[] = {
      {"e", true, [](const Test&) { return std::vector<double>{}; }},
      {"e, C_u", true, [](const Test& t) { return std::vector{std::log(*t.known.uniformity)}; }},
      {"D_r", false, [](const Test& t) { return std::vector{D_r_of(t)}; }},
      {"D_r, e_min", false,
       [](const Test& t) {
         return std::vector{D_r_of(t), *t.known.least_void_ratio};
       }},
  };
  std::vector<Test> known;
  for (const Test& t : tests)
    if (t.known.uniformity && t.known.least_void_ratio && t.known.largest_void_ratio)
      known.push_back(t);
  std::set<std::string> names;
  for (const Test& t : known)
    names.insert(t.sand);
  constexpr std::size_t needed = 6; // sands, so that a fit without one of them is determined
  if (names.size() < needed)
    return;
  std::printf(
      "\nfits of these tests: G at 100 kPa [MPa], coefficients; rms of log10 with whole sands left out\n");
  for (const Form& form : forms) {
    const Eigen::VectorXd all = fitted(form, known, "");
    std::map<std::string, Eigen::VectorXd> others;
    const Misses misses = misses_of(known, [&](const Test& t) -> std::optional<double> {
      if (!others.contains(t.sand))
        others[t.sand] = fitted(form, known, t.sand);
      const double off = row_of(form, t).dot(others[t.sand]) - target_of(form, t);
      return t.shear_modulus * std::exp(off);
    });
    std::printf("  %-12s %6.1f", form.name, std::exp(all[0]) / 1e6);
    for (Eigen::Index k = 1; k < all.size(); ++k)
      std::printf("  %+.3f", form.by_void_ratio ? all[k] : all[k] / std::log(10.0));
    std::printf("   rms %.3f\n", rms_of(misses));
  }
}

/// From each test of a sand to each other at nearly the same void ratio.
void print_forecasts(const std::vector<Test>& tests) {
  constexpr double edges[] = {1.4, 2.1, 3.3, 6, 33}, same = 0.01;
  std::printf("\nforecasts from one pressure to another of one sand at one void ratio\n"
              "  p ratio      pairs   rms of log10, stated, rms over stated, within one, two\n");
  for (std::size_t k = 0; k + 1 < std::size(edges); ++k) {
    Misses misses;
    std::map<std::string, double> stated;
    Misses deviations; // in units of the stated one
    std::size_t pairs = 0;
    for (const Test& from : tests)
      for (const Test& to : tests) {
        const double ratio = std::max(to.mean_stress / from.mean_stress, from.mean_stress / to.mean_stress);
        if (from.sand != to.sand || std::abs(from.void_ratio - to.void_ratio) > same || ratio < edges[k] ||
            ratio >= edges[k + 1])
          continue;
        const sands::Sand sand{.uniformity = from.known.uniformity};
        const double G = from.shear_modulus * sands::growth_factor(sand, to.mean_stress) /
                         sands::growth_factor(sand, from.mean_stress);
        misses[from.sand].push_back(std::log10(G / to.shear_modulus));
        const double variance = sands::forecast_variance(sand, from.mean_stress, to.mean_stress);
        stated[from.sand] += variance;
        deviations[from.sand].push_back(misses[from.sand].back() * std::log(10.0) / std::sqrt(variance));
        ++pairs;
      }
    if (misses.empty())
      continue;
    double variance = 0;
    for (const auto& [sand, sum] : stated)
      variance += sum / static_cast<double>(misses[sand].size());
    const double error = std::sqrt(variance / static_cast<double>(stated.size())) / std::log(10.0);
    const double rms = rms_of(misses);
    std::printf("  %4.1f to %-4.1f %6zu   %5.3f  %5.3f  %4.2f  %3.0f %% %3.0f %%\n", edges[k], edges[k + 1],
                pairs, rms, error, rms / error, 100 * covered_by(deviations, 1),
                100 * covered_by(deviations, 2));
  }
}

} // namespace

int main(int argc, char** argv) {
  return program(argc, argv, {{"", "table.csv", [](const Arguments& files) {
                                 const std::vector<Test> tests = read_tests(files[0]);
                                 if (tests.empty())
                                   throw FileError(files[0], 0, "holds no test with p, e and G");
                                 print_levels(tests);
                                 print_sands(tests);
                                 print_fits(tests);
                                 print_forecasts(tests);
                               }}});
}
