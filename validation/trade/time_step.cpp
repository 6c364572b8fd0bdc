// SPDX-License-Identifier: GPL-3.0-or-later
// Does the time step change loose packings? Specimens of 1,000 spheres, each compressed from one start with
// two time steps: means of the differences and their standard errors.
//
//     trade_time_step [specimens, by default 64 [shares of the stability limit, by default 0.8 0.2]]
//
// Exit code: 0 if s is the same within three standard errors, 1 if not, 2 usage.
#include <granum/core/error.hpp>
#include <granum/elastic/isotropic.hpp>
#include <granum/network/linear_response.hpp>
#include <granum/packing/coordination.hpp>
#include <granum/triaxial/probe.hpp>
#include <granum/triaxial/specimen.hpp>

#include "../common.hpp"
#include "../relaxation/exponents.hpp"
#include "../relaxation/specimens.hpp"

namespace {

using namespace granum;
using relaxation::kPa;

constexpr std::array pressures{10 * kPa, 20 * kPa, 50 * kPa, 100 * kPa};

/// What the comparison is about: ln G and z* at each pressure, then s.
using Figures = std::array<double, 2 * pressures.size() + 1>;

relaxation::Preparation loose() {
  relaxation::Preparation preparation{.name = "loose",
                                      .friction_coefficient = relaxation::usual_friction(),
                                      .path = {},
                                      .grains = 1000,
                                      .max_steps = triaxial::compression_options().max_steps};
  for (const double pressure : pressures)
    preparation.path.push_back({pressure});
  return preparation;
}

/// Nothing if a state does not come to rest.
std::optional<Figures> compressed(dem::Specimen state, const dem::Material& material, double time_step) {
  relaxation::Preparation preparation = loose();
  preparation.time_step_fraction = time_step;
  Figures figures{};
  std::vector<hardin::MeasuredModulus> moduli;
  for (std::size_t k = 0; k < pressures.size(); ++k) {
    state = relaxation::at_stage(std::move(state), preparation, k, material);
    const triaxial::FrozenState frozen = triaxial::freeze_in_place(state, material);
    if (!relaxation::why_left_out(frozen, material).empty())
      return std::nullopt;
    const packing::Assembly network = dem::contact_network(frozen.state(), material);
    const double G =
        elastic::isotropic_projection(network::linear_response(network).relaxed()).shear_modulus();
    figures[2 * k] = std::log(G);
    figures[2 * k + 1] =
        mechanical_coordination(network, packing::ContactKind::frictional).coordination_number;
    moduli.push_back({G, {pressures[k], pressures[k], dem::void_ratio(frozen.state())}});
  }
  figures.back() = relaxation::fitted_exponent(moduli);
  return figures;
}

/// What the second share of the stability limit adds to the figures of the first.
std::vector<Figures> differences(std::uint64_t specimens, double first, double second) {
  const contact::PowerLaw law = contact::PowerLaw::sphere(relaxation::grain, 0.5e-3);
  std::vector<Figures> all;
  for (std::uint64_t seed = 1; seed <= specimens; ++seed) {
    const triaxial::SpecimenRecipe recipe = relaxation::recipe(law, 0.5e-3, loose(), seed);
    const dem::Specimen start =
        relaxation::start_of_path(triaxial::frictionless_specimen(recipe).state, loose(), recipe);
    const auto a = compressed(start, recipe.material, first), b = compressed(start, recipe.material, second);
    if (!a || !b)
      continue;
    all.emplace_back();
    for (std::size_t k = 0; k < all.back().size(); ++k)
      all.back()[k] = (*b)[k] - (*a)[k];
  }
  return all;
}

/// \return   whether s is the same within three standard errors
bool report(const std::vector<Figures>& differences) {
  const auto mean = [&](std::size_t k) {
    std::vector<double> values;
    for (const Figures& d : differences)
      values.push_back(d[k]);
    return mean_of(values);
  };
  for (std::size_t k = 0; k < pressures.size(); ++k) {
    const Mean G = mean(2 * k), z = mean(2 * k + 1);
    std::printf("  %4g kPa  G %+.2f +- %.2f %%  z* %+.4f +- %.4f\n", pressures[k] / kPa, 100 * G.value,
                100 * G.error, z.value, z.error);
  }
  const Mean s = mean(2 * pressures.size());
  std::printf("  s %+.4f +- %.4f\n", s.value, s.error);
  return std::abs(s.value) <= 3 * s.error;
}

} // namespace

int main(int argc, char** argv) {
  return program(
      argc, argv,
      {{"", "[specimens] [share-of-the-stability-limit] [another]", [](const Arguments& arguments) {
          const auto specimens = !arguments.empty() ? std::stoull(arguments[0]) : 64;
          const double first =
                           arguments.size() > 1 ? std::stod(arguments[1]) : dem::default_time_step_fraction,
                       second = arguments.size() > 2 ? std::stod(arguments[2]) : 0.2;
          if (specimens < 2 || !(first > 0 && first <= 1 && second > 0 && second <= 1))
            throw InvalidArgument("less than two specimens, or a share that is not in (0, 1]");
          const std::vector<Figures> found = differences(specimens, first, second);
          std::printf("%g of the stability limit less %g: %zu specimens of %llu\n", second, first,
                      found.size(), specimens);
          return report(found);
        }}});
}
