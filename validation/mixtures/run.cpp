// SPDX-License-Identifier: GPL-3.0-or-later
// Packings of spheres of two materials, made by LAMMPS: what the exchange of rung 3 is, and how far it errs.
//
//     mixtures record states.csv FOLDER   adds the packings that make.py made in FOLDER
//     mixtures table states.csv           the tables of README.md
//     mixtures check states.csv           exit code 0 if the library's coefficients are those of the fit and
//                                         packings that it has not seen lie within what is stated
#include <filesystem>

#include <boost/math/tools/minima.hpp>
#include <granum/analysis/measure.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/elastic/isotropic.hpp>
#include <granum/io/lammps/files.hpp>

#include "../common.hpp"
#include "../relaxation/recording.hpp"
#include "effective/mixture_kernel.hpp"

namespace {

using namespace granum;
using effective::PairShare;
using effective::kernel::Mixing;

constexpr double softest = 2e9, poisson_ratio = 0.2; // as make.py has them

// ---- the record

analysis::Measurement measured(const std::filesystem::path& folder, const std::string& state, double ratio) {
  const auto file = [&](const char* what) {
    return io::TextSource(folder / (what + ("." + state) + ".dump"));
  };
  io::LammpsDump dump(file("atoms"), file("contacts"));
  const io::ImportedPacking packing = dump.next().value();
  analysis::Given given;
  for (const long type : packing.type)
    given.materials.push_back({type == 1 ? softest : ratio * softest, poisson_ratio});
  analysis::Wanted wanted;
  wanted.closed_forms = true;
  wanted.network = network::ResponseOptions{};
  return analysis::measure(packing.assembly, given, wanted);
}

/// \param    name   "dense_10_0.5": dense, G_g 1:10, half of the grains stiff; "dense_10_large": large ones
void append(relaxation::Record& record, const std::string& name, const std::string& state,
            const std::filesystem::path& folder) {
  const std::size_t first = name.find('_'), last = name.rfind('_');
  const std::string ratio = name.substr(first + 1, last - first - 1);
  relaxation::Row row;
  row.add("preparation", name.substr(0, first));
  row.add("ratio", ratio);
  row.add("stiff", name.substr(last + 1));
  row.add("state", state);
  if (record.has(row))
    return;
  const analysis::Measurement m = measured(folder, state, std::stod(ratio));
  const effective::State& s = m.state.value();
  const elastic::Isotropic network = m.network.value().isotropic_relaxed();
  row.add({{"stress_v_Pa", s.stress_v},
           {"stress_h_Pa", s.stress_h},
           {"e", s.void_ratio},
           {"C_n", *s.coordination_number},
           {"z_star", *s.mechanical_coordination_number},
           {"a", s.fabric_anisotropy},
           {"Q", s.unevenness.value().value},
           {"radius_m", s.radius},
           {"branch", s.contacts.branch},
           {"branch_square", s.contacts.branch_square},
           {"pair_radius", s.contacts.pair_radius},
           {"grain_volume", s.contacts.grain_volume},
           {"G_g_Pa", s.law.grain().shear_modulus},
           {"nu_g", s.law.grain().poisson_ratio}});
  for (const PairShare& kind : s.pair_shares) {
    const std::string number = std::to_string(&kind - s.pair_shares.data() + 1);
    row.add({{"share_" + number, kind.share},
             {"stiffness_" + number, kind.stiffness},
             {"force_" + number, kind.force}});
  }
  row.add({{"G_network_Pa", network.shear_modulus()}, {"K_network_Pa", network.bulk_modulus()}});
  record.append(row);
}

void record(const std::string& path, const std::filesystem::path& folder) {
  relaxation::Record states(path, 4);
  std::vector<std::filesystem::path> packings;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (std::filesystem::exists(entry.path() / "done"))
      packings.push_back(entry.path());
  std::sort(packings.begin(), packings.end());
  for (const std::filesystem::path& packing : packings)
    for (const auto& deck : std::filesystem::directory_iterator(packing))
      if (deck.is_directory())
        for (const char* state : {"50kPa", "100kPa", "200kPa"})
          append(states, packing.filename().string(), state, deck.path());
}

// ---- its states

struct State {
  std::string preparation, stiff;
  double ratio;
  effective::State packing;
  double shear_modulus, bulk_modulus; ///< of the network [Pa]

  [[nodiscard]] bool equal_sizes() const { return stiff.find('.') != std::string::npos; }
  /// The packings that the coefficients are fitted to: one half of equal grains is stiff.
  [[nodiscard]] bool fitted() const { return stiff == "0.5"; }
};

std::vector<State> read(const std::string& path) {
  std::vector<State> states;
  for (const Entry& row : read_record(path)) {
    const contact::GrainMaterial grain{row("G_g_Pa"), row("nu_g")};
    effective::State s{.law = contact::PowerLaw::sphere(grain, row("radius_m") * row("pair_radius")),
                       .tangential_ratio = contact::mindlin_stiffness_ratio(grain.poisson_ratio),
                       .radius = row("radius_m"),
                       .void_ratio = row("e"),
                       .coordination_number = row("C_n"),
                       .mechanical_coordination_number = row("z_star"),
                       .fabric_anisotropy = row("a"),
                       .stress_v = row("stress_v_Pa"),
                       .stress_h = row("stress_h_Pa"),
                       .contacts = {.branch = row("branch"),
                                    .branch_square = row("branch_square"),
                                    .pair_radius = row("pair_radius"),
                                    .grain_volume = row("grain_volume")},
                       .unevenness = effective::Unevenness{.value = row("Q")}};
    for (const std::string kind : {"1", "2", "3"})
      s.pair_shares.push_back({.share = row("share_" + kind),
                               .stiffness = row("stiffness_" + kind),
                               .force = row("force_" + kind)});
    states.push_back({row.text("preparation"), row.text("stiff"), row("ratio"), s, row("G_network_Pa"),
                      row("K_network_Pa")});
  }
  return states;
}

using Moduli = std::pair<double, double>; // G and K

/// Of rung 3 [Pa].
Moduli moduli(const effective::State& s) {
  const elastic::TransverselyIsotropic c = effective::relaxed(s, *s.mechanical_coordination_number).stiffness;
  return {elastic::projected_shear_modulus(c), c.bulk_modulus()};
}

/// With the exchange, and with the mean stiffness of the contacts.
struct Judged {
  ErrorsOfBoth mixed, mean;
};

using Choice = bool (*)(const State&);
Judged judge(const std::vector<State>& states, Choice chosen, bool forces_known, double least_ratio = 0) {
  Judged out;
  for (const State& s : states) {
    if (!chosen(s) || s.ratio < least_ratio)
      continue;
    effective::State mixed = s.packing;
    if (!forces_known) {
      mixed.unevenness.reset();
      for (PairShare& kind : mixed.pair_shares)
        kind.force = 1;
    }
    const auto [G, K] = moduli(mixed);
    const effective::ModulusErrors stated =
        effective::relaxed(mixed, *mixed.mechanical_coordination_number).relative_error;
    out.mixed.G.add(G / s.shear_modulus - 1, stated.G_vh);
    out.mixed.K.add(K / s.bulk_modulus - 1, stated.bulk_modulus);
    mixed.pair_shares.clear();
    const auto [mean_G, mean_K] = moduli(mixed);
    out.mean.G.add(mean_G / s.shear_modulus - 1);
    out.mean.K.add(mean_K / s.bulk_modulus - 1);
  }
  return out;
}

// ---- the fit

/// The coefficient of an exchange for which the squared errors of ln of the modulus are least.
double fitted_exchange(const std::vector<State>& states, const Mixing& like, bool of_shear) {
  const auto squares = [&](double coefficient) {
    double sum = 0;
    for (const State& s : states) {
      if (!s.fitted())
        continue;
      const double z = *s.packing.mechanical_coordination_number;
      effective::State mean = s.packing;
      mean.pair_shares.clear();
      const auto [shear, bulk] = moduli(mean);
      const Mixing trial{
          .exchange = coefficient, .power = like.power, .error = 0, .size_error = 0, .by_forces = false};
      const double left = effective::kernel::left_by_mixing(s.packing.pair_shares, z, trial).left,
                   error = of_shear ? std::log(shear * left / s.shear_modulus)
                                    : std::log(bulk * left / s.bulk_modulus);
      sum += error * error;
    }
    return sum;
  };
  return boost::math::tools::brent_find_minima(squares, 0.2, 1.0, 26).first;
}

struct Group {
  const char* name;
  Choice holds;
};
constexpr Choice unfitted = [](const State& s) { return s.equal_sizes() && !s.fitted(); };
constexpr Group groups[] = {
    {"fitted: half of the grains stiff", [](const State& s) { return s.fitted(); }},
    {"a quarter or three quarters stiff", unfitted},
    {"- dense", [](const State& s) { return unfitted(s) && s.preparation == "dense"; }},
    {"- loose", [](const State& s) { return unfitted(s) && s.preparation == "loose"; }},
    {"- 1:3", [](const State& s) { return unfitted(s) && s.ratio == 3; }},
    {"- 1:10", [](const State& s) { return unfitted(s) && s.ratio == 10; }},
    {"- 1:30", [](const State& s) { return unfitted(s) && s.ratio == 30; }},
    {"- 1:100", [](const State& s) { return unfitted(s) && s.ratio == 100; }},
    {"two sizes, 1:10", [](const State& s) { return !s.equal_sizes() && s.ratio == 10; }},
    {"two sizes, 1:100", [](const State& s) { return !s.equal_sizes() && s.ratio == 100; }},
};

void print_table(const std::vector<State>& states) {
  for (const bool forces_known : {true, false}) {
    std::printf("| %s | states | G: rms, worst | within one, two stated | K: rms, worst | within one, two | "
                "mean of the contacts: G, K |\n| --- | --- | --- | --- | --- | --- | --- |\n",
                forces_known ? "forces known" : "forces unknown");
    for (const Group& group : groups) {
      const auto [mixed, mean] = judge(states, group.holds, forces_known);
      const auto& [G, K] = mixed;
      if (G.count() > 0)
        std::printf("| %s | %d | %.1f, %.1f | %.0f, %.0f | %.1f, %.1f | %.0f, %.0f | %.1f, %.1f |\n",
                    group.name, G.count(), 100 * G.rms(), 100 * G.worst(), 100 * G.one(), 100 * G.two(),
                    100 * K.rms(), 100 * K.worst(), 100 * K.one(), 100 * K.two(), 100 * mean.G.rms(),
                    100 * mean.K.rms());
    }
  }
}

int check(const std::vector<State>& states) {
  using effective::kernel::bulk_mixing;
  using effective::kernel::shear_mixing;
  Claims claims;
  for (const Mixing* mixing : {&shear_mixing, &bulk_mixing}) {
    const double fitted = fitted_exchange(states, *mixing, mixing == &shear_mixing);
    claims.require(std::abs(fitted - mixing->exchange) < 5e-4,
                   detail::formatted("the exchange %.4g of the library is that of the fit, %.4g",
                                     mixing->exchange, fitted));
  }
  const auto require_covered = [&](const ErrorsOfBoth& e, const std::string& of) {
    claims.require_covered(e.G, "G of " + of, 0.5, 0.88);
    claims.require_covered(e.K, "K of " + of, 0.5, 0.88);
  };
  for (const bool forces_known : {true, false}) {
    const auto& [G, K] = judge(states, unfitted, forces_known).mixed;
    const std::string of =
        forces_known ? "mixtures not fitted, forces known" : "mixtures not fitted, forces unknown";
    claims.require(G.count() > 0 && G.rms() < 0.06,
                   detail::formatted("6 %% rms or less in G of %s: %.1f", of.c_str(), 100 * G.rms()));
    claims.require(K.rms() < 0.10,
                   detail::formatted("10 %% rms or less in K of %s: %.1f", of.c_str(), 100 * K.rms()));
    // At 1:3 the mean of the contacts errs as much: that is rung 3 itself, where the forces are unknown.
    require_covered(judge(states, unfitted, forces_known, forces_known ? 3 : 10).mixed, of);
  }
  require_covered(judge(
                      states, [](const State& s) { return !s.equal_sizes(); }, false)
                      .mixed,
                  "two sizes");
  return claims.exit_code();
}

} // namespace

int main(int argc, char** argv) {
  return program(argc, argv,
                 {
                     {"record", "states.csv FOLDER",
                      [](const Arguments& arguments) { record(arguments[0], arguments[1]); }},
                     {"table", "states.csv", [](const Arguments& files) { print_table(read(files[0])); }},
                     {"check", "states.csv", [](const Arguments& files) { return check(read(files[0])); }},
                 });
}
