// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyse_options.hpp"

#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/elastic/isotropic.hpp>

#include "cli/frame/frame.hpp"
#include "studies/scene/scene.hpp"

namespace granum::cli {

namespace {

[[noreturn]] void refuse_frames(const std::string& text) {
  throw InvalidArgument(
      "--frames needs all, last, N, FIRST:LAST or FIRST:LAST:STRIDE, numbers from 0, not \"" + text + "\"");
}

std::size_t frame_number(const std::string& text, const std::string& all) {
  const auto value = parse_number(text);
  constexpr double largest = 1e15;
  if (!value || !(*value >= 0) || !(*value <= largest) || *value != std::floor(*value))
    refuse_frames(all);
  return static_cast<std::size_t>(*value);
}

/// The contact law that the options describe, for any material and radius.
analysis::LawFamily law_family(const InputValues& values) {
  return
      [values](const contact::GrainMaterial& grain, double radius) { return law_of(values, grain, radius); };
}

/// Quantities with their units between commas.
template <std::size_t count>
std::array<double, count> parse_list(const std::string& name, const std::string& text, Dimension dimension,
                                     const char* what) {
  const std::vector<std::string> parts = split_at(text, ',');
  if (parts.size() != count)
    throw InvalidArgument(fmt::format("{} takes {}, not \"{}\"", name, what, text));
  std::array<double, count> out{};
  for (std::size_t k = 0; k < count; ++k)
    out[k] = parse_quantity(name, parts[k], dimension);
  return out;
}

std::string formats_help() {
  std::string text = "Formats, plain or gzip, recognised by content, not by name:\n";
  for (const io::PackingFormat* format : io::packing_formats)
    text += fmt::format("  {:<30} {}\n", format->name, format->sign);
  return text;
}

} // namespace

FrameChoice parse_frames(const std::string& text) {
  if (text == "all")
    return {};
  if (text == "last")
    return {.only_last = true};
  const std::vector<std::string> parts = split_at(text, ':');
  FrameChoice choice;
  if (parts.size() > 3)
    refuse_frames(text);
  if (!parts[0].empty() || parts.size() == 1)
    choice.first = frame_number(parts[0], text);
  if (parts.size() == 1)
    choice.last = choice.first;
  else if (!parts[1].empty())
    choice.last = frame_number(parts[1], text);
  if (parts.size() == 3)
    choice.stride = frame_number(parts[2], text);
  if (choice.stride == 0 || choice.last < choice.first)
    throw InvalidArgument("--frames " + text + " selects no frame");
  return choice;
}

std::optional<io::CsvBox> parse_box(const std::string& text) {
  if (text.empty())
    return std::nullopt;
  const auto edges = parse_list<3>("--box", text, Dimension::length, "three lengths, LX,LY,LZ");
  for (const double edge : edges)
    require_positive("--box", edge, "m");
  return io::CsvBox{.cell = Mat3::diagonal(edges[0], edges[1], edges[2])};
}

studies::PrintedStress parse_stress(const std::string& text) {
  return parse_list<6>("--stress", text, Dimension::pressure, "six stresses, xx,yy,zz,xy,xz,yz");
}

namespace {

/// "a..b", either end may be left out.
std::array<std::optional<double>, 2> parse_range(const std::string& name, const std::string& text) {
  const auto ends = ends_of_range(text);
  if (!ends)
    throw InvalidArgument(fmt::format("{} takes ranges such as 1mm..3mm, not \"{}\"", name, text));
  std::array<std::optional<double>, 2> out;
  for (std::size_t k = 0; k < 2; ++k)
    if (!ends->at(k).empty())
      out[k] = parse_quantity(name, ends->at(k), Dimension::length);
  return out;
}

[[noreturn]] void refuse_material(const std::string& text) {
  throw InvalidArgument(fmt::format("--material takes TYPE:shear-modulus=30GPa,poisson-ratio=0.15, or "
                                    "bulk-modulus=33GPa for the ratio, not \"{}\"",
                                    text));
}

/// "shear-modulus=30GPa,poisson-ratio=0.15"
contact::GrainMaterial parse_material(const std::string& list, const std::string& whole) {
  std::optional<double> modulus, ratio, bulk;
  for (const std::string& item : split_at(list, ',')) {
    const std::size_t equals = item.find('=');
    const std::string key = item.substr(0, equals);
    const std::string value = equals == std::string::npos ? "" : item.substr(equals + 1);
    if (key == "shear-modulus" && !modulus)
      modulus =
          require_positive("--material shear-modulus",
                           parse_quantity("--material shear-modulus", value, Dimension::pressure), "Pa");
    else if (key == "bulk-modulus" && !bulk)
      bulk = require_positive("--material bulk-modulus",
                              parse_quantity("--material bulk-modulus", value, Dimension::pressure), "Pa");
    else if (key == "poisson-ratio" && !ratio)
      ratio = parse_quantity("--material poisson-ratio", value, Dimension::dimensionless);
    else
      refuse_material(whole);
  }
  if (!modulus || ratio.has_value() == bulk.has_value())
    refuse_material(whole);
  if (bulk)
    return {*modulus, elastic::Isotropic::from_bulk_and_shear(*bulk, *modulus).poisson_ratio()};
  require_poisson_ratio("--material poisson-ratio", *ratio);
  return {*modulus, *ratio};
}

} // namespace

std::optional<studies::WindowChoice> parse_window(const std::string& window, const std::string& depth) {
  if (window.empty() && depth.empty())
    return std::nullopt;
  studies::WindowChoice choice;
  if (!window.empty()) {
    const std::vector<std::string> axes = split_at(window, ',');
    if (axes.size() != 3)
      throw InvalidArgument(fmt::format(
          "--window takes three ranges, x0..x1,y0..y1,z0..z1, .. for a whole axis, not \"{}\"", window));
    for (std::size_t k = 0; k < 3; ++k) {
      const auto range = parse_range("--window", axes[k]);
      choice.low[k] = range[0];
      choice.high[k] = range[1];
    }
  }
  if (!depth.empty()) {
    const auto range = parse_range("--depth", depth);
    if (!range[0] || !range[1])
      throw InvalidArgument(fmt::format("--depth takes two depths, such as 1mm..3mm, not \"{}\"", depth));
    if (choice.low[2] || choice.high[2])
      throw InvalidArgument(
          "--depth and --window both give z: leave one out, as in --window 0mm..4mm,0mm..4mm,..");
    choice.depth = {require_non_negative("--depth", *range[0], "m"),
                    require_positive("--depth", *range[1], "m")};
  }
  return choice;
}

std::optional<studies::ProfileChoice> parse_profile(const std::string& text) {
  if (text.empty())
    return std::nullopt;
  constexpr double most = 10000;
  const std::size_t axis = text.find_first_of("xyz"), colon = text.find(':');
  const auto slices = colon == 1 ? parse_number(text.substr(2)) : std::nullopt;
  if (axis != 0 || !slices || *slices != std::floor(*slices) || !(*slices >= 1 && *slices <= most))
    throw InvalidArgument(
        fmt::format("--profile takes an axis and 1 to {:.0f} slices, such as z:20, not \"{}\"", most, text));
  return studies::ProfileChoice{.axis = text[0] - 'x', .slices = static_cast<std::size_t>(*slices)};
}

studies::MaterialsByType parse_materials(const std::vector<std::string>& texts) {
  constexpr double largest = 1e9;
  studies::MaterialsByType out;
  for (const std::string& text : texts) {
    const std::size_t colon = text.find(':');
    const auto type = parse_number(text.substr(0, colon));
    if (colon == std::string::npos || !type || *type != std::floor(*type) || !(std::abs(*type) <= largest))
      refuse_material(text);
    if (!out.emplace(static_cast<long>(*type), parse_material(text.substr(colon + 1), text)).second)
      throw InvalidArgument(fmt::format("--material is given twice for type {}", static_cast<long>(*type)));
  }
  return out;
}

std::optional<packing::TurningSpring> parse_turning(const std::string& name, const std::string& text) {
  using Of = packing::TurningSpring::Of;
  if (text.empty())
    return std::nullopt;
  if (text == "marshall")
    return packing::TurningSpring{.value = 0, .of = Of::marshall};
  const auto number = leading_number(trimmed(text));
  const std::string unit(number ? trimmed(number->rest) : "");
  static const std::map<std::string, std::pair<Of, double>> units = {{"", {Of::normal, 1}},
                                                                     {"N/m", {Of::displacement, 1}},
                                                                     {"kN/m", {Of::displacement, 1e3}},
                                                                     {"MN/m", {Of::displacement, 1e6}},
                                                                     {"Nm", {Of::angle, 1}},
                                                                     {"N*m", {Of::angle, 1}},
                                                                     {"Nmm", {Of::angle, 1e-3}},
                                                                     {"kNm", {Of::angle, 1e3}}};
  const auto found = units.find(unit);
  if (!number || !(number->value >= 0) || found == units.end())
    throw InvalidArgument(fmt::format("{} takes 2e4N/m (times R*^2, as LAMMPS' kroll), 1e-3Nm (per radian, "
                                      "as YADE's kr), a number (times k_n "
                                      "R*^2) or marshall, not \"{}\"",
                                      name, text));
  return packing::TurningSpring{.value = found->second.second * number->value, .of = found->second.first};
}

std::optional<contact::Adhesion> parse_adhesion(const std::string& text) {
  using enum contact::AdhesionModel;
  static const std::map<std::string, double> units = {{"J/m2", 1},     {"J/m^2", 1},     {"N/m", 1},
                                                      {"mJ/m2", 1e-3}, {"mJ/m^2", 1e-3}, {"mN/m", 1e-3}};
  if (text.empty())
    return std::nullopt;
  const std::size_t colon = text.find(':');
  const std::string model = text.substr(0, colon);
  const bool is_jkr = same_word(model, "jkr");
  const std::string_view energy = colon == std::string::npos ? "" : std::string_view(text).substr(colon + 1);
  const auto number = leading_number(trimmed(energy));
  const auto unit = units.find(number ? std::string(trimmed(number->rest)) : "");
  if (!(is_jkr || same_word(model, "dmt")) || !number || !(number->value >= 0) || unit == units.end())
    throw InvalidArgument(fmt::format("--adhesion takes jkr or dmt and the surface energy of the grains, not "
                                      "below 0, such as jkr:0.05J/m2 or dmt:50mJ/m2, not \"{}\"",
                                      text));
  return contact::Adhesion{.model = is_jkr ? jkr : dmt, .surface_energy = unit->second * number->value};
}

studies::MeasureOptions measure_options(const AnalyseOptions& o) {
  const InputValues& values = o.inputs;
  if (values.given(Input::grain_bulk_modulus) && !values.given(Input::grain_shear_modulus))
    throw InvalidArgument("--grain-bulk-modulus goes with --grain-shear-modulus");
  analysis::Given out{.law_family = law_family(values),
                      .grain_poisson_ratio = grain_of(values).poisson_ratio};
  out.grain_shear_modulus = values.if_given(Input::grain_shear_modulus);
  if (values.given(Input::grain_density))
    out.grain_density = values.within(Input::grain_density);
  out.tangential_ratio = values.if_given(Input::tangential_ratio);
  out.adhesion = parse_adhesion(o.adhesion);
  out.rolling = parse_turning("--rolling-stiffness", o.rolling_stiffness);
  out.twisting = parse_turning("--twisting-stiffness", o.twisting_stiffness);
  if (o.friction_angle.given())
    out.friction_coefficient = std::tan(o.friction_angle.value);
  if (!o.stiffness_from.empty())
    out.stiffness_from = o.stiffness_from == "force"     ? packing::StiffnessFrom::force
                         : o.stiffness_from == "overlap" ? packing::StiffnessFrom::overlap
                                                         : packing::StiffnessFrom::ratio;
  out.law_assumed = !values.given(Input::contact);
  analysis::Wanted wanted = analysis::everything();
  if (o.no_network)
    wanted.network.reset();
  else
    wanted.network->threads = studies::thread_count(o.threads.value_or(0));
  studies::MeasureOptions options{
      std::move(out), wanted, parse_materials(o.materials),
      parse_window(o.window == "auto" || o.window == "none" ? "" : o.window, o.depth)};
  options.choose_window = o.window != "none";
  options.profile = parse_profile(o.profile);
  if (o.modes)
    require_positive("--modes", static_cast<double>(*o.modes));
  options.modes = o.modes.value_or(0);
  if (options.wanted.network)
    options.wanted.network->motions = o.paraview || o.xyz;
  return options;
}

namespace {

Value spaced(Value value, std::optional<Dimension> dimension) {
  value.dimension = dimension;
  value.joins_units = true;
  return value;
}

void add_grain_options(Command& command, AnalyseOptions& o) {
  OptionRow density = input_option(o.inputs, Input::grain_density);
  density.value.by_default.clear();
  density.meaning =
      "Density rho_s of the grain mineral, such as 2650kg/m3; no default; needed for wave speeds";
  command.add(std::move(density));
  command.add(
      grains_group,
      {{.name = "--friction-angle",
        .value = number_without_default(o.friction_angle),
        .meaning = "Friction angle between grains, to find sliding contacts; by default from the forces",
        .synonyms = {{"phi mu friction frictioncoefficient"}}},
       {.name = "--material",
        .value = texts(o.materials, "TYPE:MATERIAL"),
        .meaning = "Moduli of a type of grains: 1:shear-modulus=30GPa,poisson-ratio=0.15; for files with "
                   "types, once for "
                   "each",
        .excludes =
            {{"--grain-shear-modulus --grain-poisson-ratio --grain-bulk-modulus",
              "--material replaces --grain-shear-modulus and --grain-poisson-ratio: leave these out"}},
        .belongs = {{"--contact", "sphere", "sphere", "--contact sphere"}},
        .synonyms = {{"mineral material solid"}}}});
}

void add_moment_options(Command& command, AnalyseOptions& o) {
  const auto row = [](const char* name, std::string& to, const char* what) {
    return OptionRow{.name = name,
                     .value = text(to, "STIFFNESS"),
                     .meaning = fmt::format("Stiffness of all contacts against {}, in one of four forms: "
                                            "2e4N/m, times R*^2 (LAMMPS' sds); 1e-3Nm, per radian "
                                            "(YADE's kr); a number, times k_n R*^2; marshall, which is k_t "
                                            "R* d/2. 1/R* = 1/R_i + 1/R_j, d is the overlap",
                                            what)};
  };
  command.add(law_group,
              {{.name = "--adhesion",
                .value = text(o.adhesion, "MODEL:ENERGY"),
                .meaning = "Contacts that attract, jkr or dmt, with the surface energy of each "
                           "grain, half of the work of adhesion: jkr:0.05J/m2; for k_n and k_t of "
                           "the network",
                .needs = {{"--grain-shear-modulus --material",
                           "--grain-shear-modulus or --material: the forces do not show the material"}},
                .belongs = {{"--contact", "sphere", "sphere", "--contact sphere"}},
                .synonyms = {{"cohesion surfaceenergy jkr dmt gamma"}}}});
  command.add(law_group, {row("--rolling-stiffness", o.rolling_stiffness, "rolling"),
                          row("--twisting-stiffness", o.twisting_stiffness, "twisting")});
}

void add_file_options(Command& command, AnalyseOptions& o) {
  command.add(
      "Files",
      {{.name = "--column-map",
        .value = text(o.column_map, "MAP"),
        .meaning = "Meaning of the columns of dumps, if granum cannot recognise them from their values: "
                   "id1=c_cl[1],id2=c_cl[2],force=c_cp[2]; of any format body=none, grains that are parts of "
                   "no rigid bodies, and shape=none, spheres whatever the columns say"},
       {.name = "--stress",
        .value = spaced(texts(o.stress, "PRESSURES|FILE"), Dimension::pressure),
        .meaning =
            "Stress reported by the code, to compare with: xx,yy,zz,xy,xz,yz, compression positive; once for "
            "each selected frame, or a CSV file with a row for each: columns xx_kPa or sigma_xx_Pa and so "
            "on (states.csv of an exported deck), and step to match frames by it"},
       {.name = "--probes",
        .value = path(o.probes),
        .meaning =
            "Moduli by probes of the code, to compare the network with: a CSV file, columns modulus (K, G, "
            "G_hh, G_vh, ...), value_Pa, and step or state (moduli.csv of an exported deck)"},
       {.name = "--box",
        .value = spaced(text(o.box, "LENGTHS"), Dimension::length),
        .meaning = "Edges of the periodic box, LX,LY,LZ, for files that do not contain it (CSV, VTK); other "
                   "files must agree with it"},
       {.name = "--units",
        .value = choice({"si"}, o.units),
        .meaning = "Units of numbers for which the files state none"},
       {.name = "--axis",
        .value = choice({"x", "y", "z", "principal"}, o.axis),
        .meaning = "Axis of the files about which the state is symmetric, axis 3 of the results; principal: "
                   "that of the stress"},
       {.name = "--frames",
        .value = text(o.frames),
        .meaning = "Frames to read, counted from 0: all, last, N, FIRST:LAST or FIRST:LAST:STRIDE"},
       {.name = "--series",
        .value = choice({"name", "all"}, o.series),
        .meaning =
            "Which frames are fitted together for exponents: name, those of files whose names differ only in "
            "numbers (dense_p50, dense_p100); all, every frame"}});
}

void add_measuring_options(Command& command, AnalyseOptions& o) {
  command.add(
      "Measurements",
      {{.name = "--stiffness-from",
        .value = choice({"overlap", "force", "force-over-overlap"}, o.stiffness_from),
        .meaning = "Source of k_n of the network; by default the overlaps, unless they are rounded; "
                   "force-over-overlap: 1.5 f/d, Hertz without a material"},
       {.name = "--window",
        .value = text(o.window, "RANGES"),
        .meaning = "Part of the packing used for e, C_n, z*, fabric and stress: x0..x1,y0..y1,z0..z1, "
                   "each end a length; .. is the whole axis; auto: an interior if there are walls or a free "
                   "surface; none: the whole packing"},
       {.name = "--depth",
        .value = text(o.depth, "RANGE"),
        .meaning = "Range of z of that part, by depth below the highest grain: 2mm..6mm",
        .synonyms = {{"z"}}},
       {.name = "--profile",
        .value = text(o.profile, "AXIS:SLICES"),
        .meaning =
            "Also solid fraction, contacts, stress and G by rung 3 of slices across an axis: z:20; of the "
            "window, if --window or --depth gives one"},
       {.name = "--no-network",
        .value = flag(o.no_network),
        .meaning =
            "Leave out the contact network (rung 4) and its 6x6 stiffness, which take most of the time"},
       {.name = "--modes",
        .value = count(o.modes),
        .meaning = "So many of the lowest frequencies of the network's free oscillations, with the share of "
                   "grains that take part",
        .needs = {{"--grain-density", "--grain-density, for the masses"}},
        .synonyms = {{"eigenmodes frequencies vibrations"}}},
       {.name = "--threads",
        .value = count(o.threads),
        .meaning =
            "Threads for the 6x6 stiffness, by default one for each core; the results do not depend on it",
        .synonyms = {{"j jobs nthreads cores"}}}});
}

} // namespace

void add_analyse_options(Command& command, AnalyseOptions& o) {
  command.notes = formats_help();
  command.add({.name = "files",
               .value = texts(o.files, "FILE"),
               .meaning = "Files with grains and, if available, contacts; all of one format",
               .required = true});
  command.options.back().value.several = true;
  add_law_options(command, o.inputs, "--law,--contact");
  command.row("--grain-shear-modulus").value.by_default = "from forces and overlaps";
  add_grain_options(command, o);
  add_input(command, o.inputs, Input::tangential_ratio);
  add_moment_options(command, o);
  add_file_options(command, o);
  add_measuring_options(command, o);
  command.add(
      output_group,
      {{.name = "--json", .value = flag(o.json), .meaning = "Print one JSON object, SI units"},
       {.name = "--strict", .value = flag(o.strict), .meaning = "Fail (exit code 4) if there is a warning"}});
  add_output_place(command, o.out, o.force, "DIR",
                   "Folder for CSV (frames, stiffness, rose, forces, profile), JSON and pictures",
                   "existing results");
  OptionRow& force = command.row("--force");
  force.needs = {{"--out --hessian", "--out or --hessian"}};
  force.meaning = "Let --out and --hessian replace existing files";
  command.add(
      output_group,
      {{.name = "--paraview",
        .value = flag(o.paraview),
        .meaning = "Also write grains and force chains for ParaView; stress and non-affine "
                   "displacements are point data",
        .needs = {{"--out"}}},
       {.name = "--xyz",
        .value = flag(o.xyz),
        .meaning = "Also write grains with the same data as extended XYZ, for OVITO",
        .needs = {{"--out"}},
        .synonyms = {{"ovito extxyz"}}},
       {.name = "--hessian",
        .value = path(o.hessian, "FILE.mtx"),
        .meaning = "Write the stiffness matrix of the network of the last frame, of displacements and "
                   "spins [N/m], to this file in MatrixMarket format",
        .synonyms = {{"dynamicalmatrix stiffnessmatrix mtx matrixmarket"}}}});
}

} // namespace granum::cli
