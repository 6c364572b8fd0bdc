// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/estimate/inputs.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <iterator>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/estimate/input_values.hpp>
#include <granum/sizes/distribution.hpp>

namespace granum::estimate {

namespace {

constexpr Limits above_zero{.low = 0, .without_low = true};
constexpr Limits contacts_per_grain{.low = 0, .high = 100, .reason = "equal spheres have 12 at most"};
constexpr Limits compression{.low = 0, .reason = "compression is positive"};
/// Beyond these no formula of a void ratio means anything, and some overflow.
constexpr double least_void_ratio = 1e-6, largest_void_ratio = 1e6;
constexpr Limits part_of_volume{.low = 0, .high = 1, .without_low = true, .without_high = true};
constexpr Limits size_of_grains{
    .low = 0, .high = 1e3, .without_low = true, .without_high = true, .reason = "no grain is larger"};

const char* const table_1 = "as the grains of Chung et al. 2014, Table 1";

constexpr const char *words_for_diameter =
                         "d D diameter grainsize particlesize graindiameter meandiameter meansize",
                     *words_for_limits = "between 0.1 and 5, e_max larger than e_min by 0.05";

std::vector<InputRow> number_rows() {
  return {
      {.input = Input::grain_shear_modulus,
       .key = "grain_shear_modulus",
       .group = grains_group,
       .meaning = "Shear modulus G_g of the grain's material",
       .dimension = Dimension::pressure,
       .synonyms = {{"Gs gs"},
                    {"G g Gg gg mug modulus grainmodulus shearmodulus"},
                    {"E Eg Es youngmodulus youngsmodulus grainyoungmodulus",
                     "of Young's modulus it is G_g = E_g/(2(1 + nu_g))"}},
       .limits = above_zero,
       .by_default = 30e9,
       .read = [](const Question& q) -> std::optional<double> { return q.state.law.grain().shear_modulus; },
       .deviation =
           [](const InputValues& v) {
             return assumed_deviations.grain_shear_modulus * v.number(Input::grain_shear_modulus);
           },
       .origin = table_1},
      {.input = Input::grain_poisson_ratio,
       .key = "grain_poisson_ratio",
       .group = grains_group,
       .meaning = "Poisson's ratio nu_g of the grain's material",
       .synonyms = {{"nu nug v poisson poissonratio poissonsratio"}},
       .limits = {.low = -1, .high = 0.5, .without_low = true},
       .by_default = 0.15,
       .read = [](const Question& q) -> std::optional<double> { return q.state.law.grain().poisson_ratio; },
       .deviation = [](const InputValues&) { return assumed_deviations.grain_poisson_ratio; },
       .origin = table_1},
      {.input = Input::grain_bulk_modulus,
       .key = "grain_bulk_modulus",
       .group = grains_group,
       .meaning = "Bulk modulus K_g of the grain's material, instead of --grain-poisson-ratio",
       .dimension = Dimension::pressure,
       .synonyms = {{"K k Kg Ks kg ks bulkmodulus grainbulkmodulus"}},
       .limits = above_zero,
       .excludes = {{"grain_poisson_ratio", conflict::grain}}},
      {.input = Input::radius,
       .key = "radius",
       .group = sizes_group,
       .meaning = "Radius of the grains; mean by number if they are unequal",
       .dimension = Dimension::length,
       .synonyms = {{words_for_diameter}, {"r R grainradius particleradius"}},
       .limits = size_of_grains,
       .by_default = 0.5e-3,
       .excludes = {{"d50", conflict::size}},
       .read = [](const Question& q) -> std::optional<double> { return q.state.radius; },
       .origin = table_1},
      {.input = Input::d50,
       .key = "d50",
       .group = sizes_group,
       .meaning = "Median diameter by mass, instead of --radius",
       .dimension = Dimension::length,
       .synonyms = {{words_for_diameter}},
       .limits = size_of_grains,
       .read = [](const Question& q) -> std::optional<double> { return q.sand.d50; }},
      {.input = Input::tangential_ratio,
       .key = "tangential_ratio",
       .group = law_group,
       .meaning = "Tangential over normal contact stiffness, k_t/k_n; by default 2(1-nu_g)/(2-nu_g), no slip",
       .limits = {.low = 0, .high = 100},
       .implies = GrainShape::sphere,
       .read = [](const Question& q) -> std::optional<double> { return q.state.tangential_ratio; }},
      {.input = Input::rolling,
       .key = "rolling",
       .group = law_group,
       .meaning = "Rolling resistance k_r: rolling stiffness of the contacts over k_n R*^2, R* = "
                  "R_i R_j/(R_i + R_j)",
       .symbols = "k_r kr",
       .synonyms = {{"kr rollingstiffness rollingresistance rollingfriction"}},
       .limits = {.low = 0, .high = 1, .reason = "the fit ends there"},
       .by_default = 0,
       .implies = GrainShape::sphere,
       .read = [](const Question& q) -> std::optional<double> { return q.state.rolling; }},
      {.input = Input::void_ratio,
       .key = "void_ratio",
       .group = state_group,
       .meaning = "Volume of voids over that of grains",
       .symbols = "e",
       .synonyms = {{"e e0 voidratio"}, {"rho rhod density drydensity bulkdensity"}},
       .limits = {.low = least_void_ratio, .high = largest_void_ratio},
       .excludes = {{"porosity solid_fraction relative_density", conflict::density}},
       .read = [](const Question& q) -> std::optional<double> { return q.state.void_ratio; }},
      {.input = Input::porosity,
       .key = "porosity",
       .group = state_group,
       .meaning = "Volume fraction of voids, instead of --void-ratio",
       .share = true,
       .synonyms = {{"n phi"}},
       .limits = part_of_volume,
       .excludes = {{"solid_fraction relative_density", conflict::density}}},
      {.input = Input::solid_fraction,
       .key = "solid_fraction",
       .group = state_group,
       .meaning = "Volume fraction of grains, instead of --void-ratio",
       .share = true,
       .synonyms = {{"packingfraction volumefraction solidsfraction nu_s nus"}},
       .limits = part_of_volume,
       .excludes = {{"relative_density", conflict::density}}},
      {.input = Input::coordination_number,
       .key = "coordination_number",
       .group = contacts_group,
       .meaning =
           "C_n = 2 N_c/N, contacts per grain over all grains; by default estimated from void ratio and "
           "stress",
       .symbols = "C_n Cn",
       .synonyms = {{"z cn nc coordination contacts contactnumber"}},
       .limits = contacts_per_grain,
       .implies = GrainShape::sphere,
       .read = [](const Question& q) { return q.state.coordination_number; }},
      {.input = Input::mechanical_coordination_number,
       .key = "mechanical_coordination_number",
       .group = contacts_group,
       .meaning = "z*, contacts per grain without rattlers (grains that carry no load)",
       .symbols = "z_star z*",
       .synonyms = {{"z cn nc coordination contacts contactnumber zstar z* zm"}},
       .limits = contacts_per_grain,
       .implies = GrainShape::sphere,
       .read = [](const Question& q) { return q.state.mechanical_coordination_number; }},
      {.input = Input::rattler_fraction,
       .key = "rattler_fraction",
       .group = contacts_group,
       .meaning = "Share of rattlers (grains that carry no load); z* = C_n/(1 - share)",
       .share = true,
       .synonyms = {{"rattlers floaters"}},
       .limits = {.low = 0, .high = 1, .without_high = true},
       .implies = GrainShape::sphere,
       .read = [](const Question& q) { return q.rattler_fraction; }},
      {.input = Input::fabric,
       .key = "fabric",
       .group = contacts_group,
       .meaning = "a, anisotropy of the contact normals; > 0: more are vertical",
       .symbols = "a",
       .synonyms = {{"a anisotropy"}},
       .limits = {.low = -7.0 / 3, .high = 7.0 / 5, .without_low = true, .without_high = true},
       .by_default = 0,
       .read = [](const Question& q) -> std::optional<double> { return q.state.fabric_anisotropy; },
       .argument = "fabric_anisotropy",
       .deviation =
           [](const InputValues& v) {
             const stress::AxialStress stress = stresses_of(v);
             return assumed_fabric_deviation(stress.v, stress.h);
           },
       .origin = "isotropic contact directions"},
      {.input = Input::pressure,
       .key = "pressure",
       .group = state_group,
       .meaning = "Mean effective stress, the same in all directions",
       .dimension = Dimension::pressure,
       .symbols = "p p'",
       .synonyms = {{"p p0 pc p' pm sigma sigma0 sigma3 sigmac s3 stress confiningpressure confiningstress "
                     "confinement confining meanstress meaneffectivestress effectivestress cellpressure "
                     "isotropicstress"}},
       .limits = compression,
       .excludes = {{"stress_v stress_h", conflict::stress}}},
      {.input = Input::stress_v,
       .key = "stress_v",
       .group = state_group,
       .meaning = "Vertical effective stress, with --stress-h",
       .dimension = Dimension::pressure,
       .symbols = "sigma_v sigma'_v sigma_v' sigma'v sigmav s'_v",
       .synonyms = {{"sigmav sigma1 sigmaz sigmaa sv s1 verticalstress axialstress"},
                    {"depth z",
                     "the effective one there, with --k0; granum sweep --depth 0m..10m computes it"}},
       .limits = compression,
       .read = [](const Question& q) -> std::optional<double> { return q.state.stress_v; }},
      {.input = Input::stress_h,
       .key = "stress_h",
       .group = state_group,
       .meaning = "Horizontal effective stress, with --stress-v",
       .dimension = Dimension::pressure,
       .symbols = "sigma_h sigma'_h sigma_h' sigma'h sigmah s'_h",
       .synonyms = {{"sigmah sigmar sh horizontalstress radialstress"},
                    {"k0 ko stressratio", "sigma_h = K_0 sigma_v"}},
       .limits = compression,
       .read = [](const Question& q) -> std::optional<double> { return q.state.stress_h; }},
      {.input = Input::grain_density,
       .key = "grain_density",
       .group = grains_group,
       .meaning = "Density rho_s of the grain mineral, for wave speeds",
       .dimension = Dimension::density,
       .belongs = Belongs::to_answer,
       .symbols = "rho_s",
       .synonyms = {{"Gs gs", "a specific gravity of 2.65 is the density 2.65g/cm3"},
                    {"specificgravity rhos rhog soliddensity gamma gammad gammasat bulkunitweight"},
                    {"rho rhod density drydensity bulkdensity",
                     "rho_s of the solid; from the dry density of the packing, e = rho_s/rho_d - 1"}},
       .limits = above_zero,
       .by_default = 2650,
       .read = [](const Question& q) { return q.grain_density; },
       .deviation = [](const InputValues&) { return assumed_deviations.grain_density; }},
      {.input = Input::relative_density,
       .key = "relative_density",
       .group = state_group,
       .meaning =
           "Relative density D_r, such as 60%, instead of --void-ratio; more accurate with e_min and e_max, "
           "or --sand",
       .belongs = Belongs::to_answer,
       .share = true,
       .symbols = "D_r Dr I_D ID",
       .synonyms = {{"dr id rd densityindex"}},
       .limits = {.low = 0, .high = 1.2},
       .implies = GrainShape::sand,
       .read = [](const Question& q) { return q.sand.relative_density; }},
      {.input = Input::least_void_ratio,
       .key = "least_void_ratio",
       .group = state_group,
       .meaning = "Smallest void ratio e_min, for --relative-density; of beads also that of the same grains "
                  "packed without friction, up to 0.58: z* is then estimated from the void ratio above it",
       .belongs = Belongs::to_answer,
       .symbols = "e_min emin",
       .synonyms = {{"emin"}},
       .limits = {.low = 0.1, .high = 4.95, .reason = words_for_limits},
       .implies = GrainShape::sand,
       .read = [](const Question& q) { return q.sand.least_void_ratio; }},
      {.input = Input::largest_void_ratio,
       .key = "largest_void_ratio",
       .group = state_group,
       .meaning = "Largest void ratio e_max, for --relative-density",
       .belongs = Belongs::to_answer,
       .symbols = "e_max emax",
       .synonyms = {{"emax"}},
       .limits = {.low = 0.15, .high = 5, .reason = words_for_limits},
       .implies = GrainShape::sand,
       .read = [](const Question& q) { return q.sand.largest_void_ratio; }},
      {.input = Input::fines,
       .key = "fines",
       .group = sizes_group,
       .meaning = "Share of silt and clay by mass, finer than 0.063 mm; from 5% on the range is wider",
       .belongs = Belongs::to_answer,
       .share = true,
       .symbols = "FC",
       .synonyms = {{"fc finescontent silt siltcontent clay"}},
       .limits = {.low = 0, .high = sands::largest_fines, .reason = "with more it is silt or clay, no sand"},
       .implies = GrainShape::sand,
       .uncertain = false},
      {.input = Input::saturation,
       .key = "saturation",
       .group = state_group,
       .meaning = "Degree of saturation S_r; at 100% V_p follows Gassmann's equation, at 99% and less V_p is "
                  "nearly that of the dry packing",
       .belongs = Belongs::to_answer,
       .share = true,
       .symbols = "S_r Sr",
       .synonyms = {{"s sr"}},
       .limits = {.low = 0, .high = 1},
       .by_default = 0,
       .read = [](const Question& q) -> std::optional<double> { return q.saturation; }},
      {.input = Input::k0,
       .key = "k0",
       .group = state_group,
       .meaning = "K_0 = sigma_h/sigma_v, instead of --stress-h",
       .belongs = Belongs::to_state,
       .symbols = "K_0 K0",
       .synonyms = {{"k0 ko stressratio", "sigma_h = K_0 sigma_v"}},
       .limits = {.low = stress::least_stress_ratio,
                  .high = stress::largest_stress_ratio,
                  .reason = "friction of 70 degrees holds no other"}},
      {.input = Input::shear_strain,
       .key = "strain",
       .group = state_group,
       .meaning = "Shear strain for G of sands as well, such as 0.01%; small strain is 0.001% and less",
       .belongs = Belongs::to_state,
       .share = true,
       .symbols = "shear_strain gamma",
       .synonyms = {{"shearstrain"}},
       .limits = {.low = 0, .high = 0.05 * (1 + 1e-12), .without_low = true}, // 5 % in any unit
       .implies = GrainShape::sand,
       .read = [](const Question& q) { return q.shear_strain; },
       .argument = "shear_strain",
       .uncertain = false},
  };
}

template <class Items>
std::vector<std::string> keys_of(const Items& items) {
  std::vector<std::string> keys;
  for (const auto& item : items)
    keys.emplace_back(item.key);
  return keys;
}

InputRow contact_row() {
  InputRow row{.input = Input::contact,
               .key = "contact",
               .group = law_group,
               .meaning = "Shape of the grains near their contacts",
               .kind = Kind::word,
               .synonyms = {{"shape law model contactlaw contactmodel"}},
               .implies = GrainShape::sphere,
               .take = [](InputValues& values, const std::string& text) {
                 const std::optional<contact::Shape> shape = contact::find_shape(text);
                 if (!shape)
                   throw InvalidArgument("contact '" + text + "' is not one of " + contact::shape_names());
                 values.contact = *shape;
               }};
  for (const contact::LawRow& law : contact::laws()) {
    row.words.emplace_back(contact::name(law.shape));
    for (const std::string& other : law.synonyms)
      row.aliases.push_back({other, row.words.back()});
  }
  return row;
}

constexpr const char* words_for_sizes = "psd gsd sievecurve sizedistribution";

/// In the order of Input.
std::vector<InputRow> text_rows() {
  return {
      contact_row(),
      {.input = Input::preparation,
       .key = "preparation",
       .group = contacts_group,
       .meaning = "How the packing was made, which determines its contacts: dense (without friction), "
                  "dense:10kPa (without friction to 10 kPa, then with friction, as in DEM; G is then more "
                  "accurate), loose (friction 0.3 to 0.5), friction:0.3",
       .kind = Kind::word,
       .belongs = Belongs::to_answer,
       .synonyms = {{"mu friction frictioncoefficient"}},
       .words = {"dense", "dense:PRESSURE", "loose", "friction:NUMBER"},
       .take = [](InputValues& values,
                  const std::string& text) { values.preparation = effective::preparation_of(text); }},
      {.input = Input::grain,
       .key = "grain",
       .group = grains_group,
       .meaning = "Mineral of the grains: sets G_g, nu_g and density unless they are given; several, each "
                  "grain of one of them, by their shares of the volume: quartz:70%,calcite:30%",
       .kind = Kind::word,
       .belongs = Belongs::to_answer,
       .synonyms = {{"mineral material solid"}},
       .words = keys_of(contact::minerals()),
       .take = [](InputValues& values,
                  const std::string& text) { values.minerals = contact::mineral_shares(text); }},
      {.input = Input::sand,
       .key = "sand",
       .group = grains_group,
       .meaning = "A known sand: its mineral, d50, C_u, e_min and e_max, where they are published",
       .kind = Kind::word,
       .belongs = Belongs::to_answer,
       .implies = GrainShape::sand,
       .words = keys_of(sands::known_sands()),
       .take = [](InputValues& values,
                  const std::string& text) { values.known_sand = &sands::known_sand(text); }},
      {.input = Input::grain_shape,
       .key = "grain_shape",
       .group = grains_group,
       .meaning = "sand: result from laws measured on sands; sphere: result from the model of spheres; by "
                  "default as implied by other options, else both results",
       .kind = Kind::word,
       .belongs = Belongs::to_answer,
       .words = {"sphere", "sand"},
       .take = [](InputValues& values,
                  const std::string& text) { values.grain_shape = grain_shape_of(text); }},
      {.input = Input::sizes,
       .key = "sizes",
       .group = sizes_group,
       .meaning =
           "Grain-size distribution: " + sizes::distribution_forms() +
           ". Sizes are radii by number: RATIO, large over small; SHARE, of large grains (0.5 if left "
           "out); SIGMA, standard deviation of ln radius; EXPONENT, of a density radius^-EXPONENT; "
           "SIZE_RATIO, largest over smallest, where the distribution is cut. By mass: C_U, d60/d10 of a "
           "lognormal distribution; PASSING, share finer than the diameter D",
       .kind = Kind::distribution,
       .synonyms = {{words_for_sizes}},
       .excludes = {{"sieve uniformity", conflict::sizes}},
       .take = [](InputValues& values,
                  const std::string& text) { values.set_sizes(sizes::parse_distribution(text)); }},
      {.input = Input::sieve,
       .key = "sieve",
       .group = sizes_group,
       .meaning = "Sieve curve of the grains, a CSV file with columns d_mm and passing_%; sets --radius as "
                  "well",
       .kind = Kind::distribution,
       .synonyms = {{words_for_sizes}},
       .implies = GrainShape::sand,
       .excludes = {{"uniformity", conflict::sizes}}},
      {.input = Input::uniformity,
       .key = "uniformity",
       .group = sizes_group,
       .meaning = "Uniformity coefficient C_u = d60/d10 of grains that are lognormal by mass",
       .symbols = "C_u Cu",
       .synonyms = {{"cu uniformitycoefficient gradation"}},
       .implies = GrainShape::sand,
       .uncertain = false}};
}

/// "Cone: A_1, tangent of the flank angle".
std::string meaning_of(const contact::LawRow& law, const contact::LawParameter& parameter) {
  std::string shape(contact::name(law.shape));
  shape.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(shape.front())));
  return shape + ": " + parameter.symbol + ", " + parameter.help +
         (parameter.unit.empty() ? "" : "; in SI, " + parameter.unit);
}

/// The numbers of all contact laws, those of the first law first.
std::vector<InputRow> law_rows() {
  std::vector<InputRow> rows;
  for (const contact::LawRow& law : contact::laws())
    for (const contact::LawParameter& parameter : law.parameters)
      rows.push_back({.input = static_cast<Input>(static_cast<std::size_t>(Input::of_laws) + rows.size()),
                      .key = parameter.name.c_str(),
                      .group = law_group,
                      .meaning = meaning_of(law, parameter),
                      .dimension = parameter.dimension,
                      .by_default = parameter.value,
                      .origin = parameter.origin,
                      .law = &law,
                      .parameter = &parameter});
  return rows;
}

std::vector<InputRow> input_rows() {
  std::vector<InputRow> rows = number_rows();
  for (const std::vector<InputRow>& more : {text_rows(), law_rows()})
    rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

} // namespace

bool Limits::contain(double value) const {
  return std::isfinite(value) && (without_low ? value > low : value >= low) &&
         (without_high ? value < high : value <= high);
}

std::string Limits::text(double refused) const {
  const char left = without_low || std::isinf(low) ? '(' : '[',
             right = without_high || std::isinf(high) ? ')' : ']';
  constexpr int all_digits = 17;
  std::string range;
  for (int digits = 6; range.empty() || (detail::contains(range, refused) && digits <= all_digits); ++digits)
    range = detail::formatted("%c%.*g, %.*g%c", left, digits, low, digits, high, right);
  return range + (*reason != '\0' ? ": " : "") + reason;
}

std::string InputRow::option() const {
  std::string text = key;
  std::replace(text.begin(), text.end(), '_', '-');
  return "--" + text;
}

std::span<const InputRow> inputs() {
  static const std::vector<InputRow> rows = input_rows();
  return rows;
}

const InputRow& row_of(Input input) { return inputs()[static_cast<std::size_t>(input)]; }

const InputRow* find_input(std::string_view key) {
  const auto found = std::find_if(inputs().begin(), inputs().end(),
                                  [&](const InputRow& row) { return row.key == key || row.name() == key; });
  return found == inputs().end() ? nullptr : &*found;
}

void require_within(const InputRow& row, double value, std::string_view name, bool signed_per_cent) {
  if (row.limits.contain(value))
    return;
  const double least = row.limits.high < 0.1 ? row.limits.high : 1; // 0.6 beyond 0.5 is no per cent
  const bool per_cent_left_out =
      row.share && !signed_per_cent && value > least && value <= 100 * row.limits.high;
  const std::string range = row.limits.text(value);
  throw InvalidArgument(std::string(name), value, std::string(si_symbol(row.dimension)),
                        per_cent_left_out ? range + "; write " + short_text(value) + "% for per cent"
                                          : range);
}

} // namespace granum::estimate
