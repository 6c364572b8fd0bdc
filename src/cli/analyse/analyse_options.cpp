// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyse_options.hpp"

#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <granum/core/check.hpp>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>

#include "cli/frame/frame.hpp"
#include "cli/frame/help.hpp"
#include "cli/options/study_options.hpp"
#include "studies/scene/scene.hpp"

namespace granum::cli {

namespace {

[[noreturn]] void refuse_frames(const std::string& text) {
  throw InvalidArgument(
      "--frames takes all, last, N, FIRST:LAST or FIRST:LAST:STRIDE, numbers from 0, not \"" + text + "\"");
}

std::size_t frame_number(const std::string& text, const std::string& all) {
  const auto value = parse_number(text);
  constexpr double largest = 1e15;
  if (!value || !(*value >= 0) || !(*value <= largest) || *value != std::floor(*value))
    refuse_frames(all);
  return static_cast<std::size_t>(*value);
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end = text.find(separator); end != std::string::npos; end = text.find(separator, begin)) {
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  parts.push_back(text.substr(begin));
  return parts;
}

/// The contact law that the options describe, for any material and radius.
analysis::LawFamily law_family(const PackingOptions& options) {
  return [options = options](const contact::GrainMaterial& grain, double radius) mutable {
    options.grain_shear_modulus.value = grain.shear_modulus;
    options.grain_poisson_ratio.value = grain.poisson_ratio;
    options.radius.value = radius;
    return resolve_law(options);
  };
}

/// Quantities with their units between commas.
template <std::size_t count>
std::array<double, count> parse_list(const std::string& name, const std::string& text, Dimension dimension,
                                     const char* what) {
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() != count)
    throw InvalidArgument(fmt::format("{} takes {}, not \"{}\"", name, what, text));
  std::array<double, count> out{};
  for (std::size_t k = 0; k < count; ++k)
    out[k] = parse_quantity(name, parts[k], dimension);
  return out;
}

std::string formats_help() {
  std::string text = "Formats, plain or gzip, and what they are told by, whatever the name:\n";
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
  const std::vector<std::string> parts = split(text, ':');
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
    throw InvalidArgument("--frames " + text + " takes no frame");
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
  throw InvalidArgument(
      fmt::format("--material takes TYPE:shear-modulus=30GPa,poisson-ratio=0.15, not \"{}\"", text));
}

/// "shear-modulus=30GPa,poisson-ratio=0.15"
contact::GrainMaterial parse_material(const std::string& list, const std::string& whole) {
  std::optional<double> modulus, ratio;
  for (const std::string& item : split(list, ',')) {
    const std::size_t equals = item.find('=');
    const std::string key = item.substr(0, equals);
    const std::string value = equals == std::string::npos ? "" : item.substr(equals + 1);
    if (key == "shear-modulus" && !modulus)
      modulus =
          require_positive("--material shear-modulus",
                           parse_quantity("--material shear-modulus", value, Dimension::pressure), "Pa");
    else if (key == "poisson-ratio" && !ratio)
      ratio = parse_quantity("--material poisson-ratio", value, Dimension::dimensionless);
    else
      refuse_material(whole);
  }
  if (!modulus || !ratio)
    refuse_material(whole);
  require_poisson_ratio("--material poisson-ratio", *ratio);
  return {*modulus, *ratio};
}

} // namespace

std::optional<studies::WindowChoice> parse_window(const std::string& window, const std::string& depth) {
  if (window.empty() && depth.empty())
    return std::nullopt;
  studies::WindowChoice choice;
  if (!window.empty()) {
    const std::vector<std::string> axes = split(window, ',');
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
          "--depth and --window both say z: leave one out, as in --window 0mm..4mm,0mm..4mm,..");
    choice.depth = {require_non_negative("--depth", *range[0], "m"),
                    require_positive("--depth", *range[1], "m")};
  }
  return choice;
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
  std::size_t end = text.find_first_not_of("0123456789.+-eE");
  end = end == std::string::npos ? text.size() : end;
  const auto value = parse_number(text.substr(0, end));
  const std::string unit = text.substr(std::min(text.find_first_not_of(' ', end), text.size()));
  static const std::map<std::string, std::pair<Of, double>> units = {{"", {Of::normal, 1}},
                                                                     {"N/m", {Of::displacement, 1}},
                                                                     {"kN/m", {Of::displacement, 1e3}},
                                                                     {"MN/m", {Of::displacement, 1e6}},
                                                                     {"Nm", {Of::angle, 1}},
                                                                     {"N*m", {Of::angle, 1}},
                                                                     {"Nmm", {Of::angle, 1e-3}},
                                                                     {"kNm", {Of::angle, 1e3}}};
  const auto found = units.find(unit);
  if (!value || !(*value >= 0) || found == units.end())
    throw InvalidArgument(fmt::format("{} takes 2e4N/m (times R*^2, as LAMMPS' kroll), 1e-3Nm (per radian, "
                                      "as YADE's kr), a number (times k_n "
                                      "R*^2) or marshall, not \"{}\"",
                                      name, text));
  return packing::TurningSpring{.value = found->second.second * *value, .of = found->second.first};
}

studies::MeasureOptions measure_options(const AnalyseOptions& o) {
  analysis::Given out{.law_family = law_family(o.packing),
                      .grain_poisson_ratio = o.packing.grain_poisson_ratio.value};
  if (o.packing.grain_shear_modulus.given())
    out.grain_shear_modulus = o.packing.grain_shear_modulus.value;
  if (o.grain_density.given())
    out.grain_density = require_positive("--grain-density", o.grain_density.value, "kg/m3");
  if (o.packing.tangential_ratio.given())
    out.tangential_ratio = o.packing.tangential_ratio.value;
  out.rolling = parse_turning("--rolling-stiffness", o.rolling_stiffness);
  out.twisting = parse_turning("--twisting-stiffness", o.twisting_stiffness);
  if (o.friction_angle.given())
    out.friction_coefficient = std::tan(o.friction_angle.value);
  if (!o.stiffness_from.empty())
    out.stiffness_from = o.stiffness_from == "force"     ? packing::StiffnessFrom::force
                         : o.stiffness_from == "overlap" ? packing::StiffnessFrom::overlap
                                                         : packing::StiffnessFrom::ratio;
  out.law_assumed = !o.packing.contact_given();
  analysis::Wanted wanted = analysis::everything();
  if (o.no_network)
    wanted.network.reset();
  else
    wanted.network->threads = studies::thread_count(o.threads.value_or(0));
  studies::MeasureOptions options{
      std::move(out), wanted, parse_materials(o.materials),
      parse_window(o.window == "auto" || o.window == "none" ? "" : o.window, o.depth)};
  options.choose_window = o.window != "none";
  return options;
}

void add_analyse_options(CLI::App& command, AnalyseOptions& o) {
  command.footer(formats_help());
  command.add_option("files", o.files, "Grains, and contacts if there are any, of one format")
      ->required()
      ->type_name("FILE");
  add_law_options(command, o.packing, "--law,--contact");
  command.get_option("--grain-shear-modulus")->default_str("from forces and overlaps");
  add_number_without_default(command, "--grain-density", o.grain_density,
                             "rho_s of the grains' solid, 2650kg/m3; without it no wave speeds");
  add_number_without_default(command, "--tangential-ratio", o.packing.tangential_ratio,
                             "k_t/k_n of a contact; by default 2(1-nu_g)/(2-nu_g), no slip");
  for (const auto& [name, text, what] :
       {std::tuple{"--rolling-stiffness", &o.rolling_stiffness, "rolling"},
        std::tuple{"--twisting-stiffness", &o.twisting_stiffness, "twisting"}})
    command
        .add_option(
            name, *text,
            fmt::format("Of all contacts against {}: 2e4N/m, times R*^2 (LAMMPS' sds); 1e-3Nm, per radian "
                        "(YADE's kr); a number, times k_n R*^2; marshall, k_t R* d/2",
                        what))
        ->type_name("STIFFNESS");
  add_number_without_default(
      command, "--friction-angle", o.friction_angle,
      "Between grains, to tell which contacts slide; by default as the forces show it");
  command
      .add_option("--column-map", o.column_map,
                  "What columns of dumps hold, where their values do not tell it: "
                  "id1=c_cl[1],id2=c_cl[2],force=c_cp[2]")
      ->type_name("MAP");
  command
      .add_option(
          "--stress", o.stress,
          "The code's own stress to compare with: xx,yy,zz,xy,xz,yz, compression positive; once for "
          "each frame that is taken, or a CSV file with a row for each, columns xx_kPa or "
          "sigma_xx_Pa and so on (states.csv of an exported deck), and step if they are to be matched by it")
      ->type_name("PRESSURES|FILE")
      ->allow_extra_args(false);
  command
      .add_option("--stiffness-from", o.stiffness_from,
                  "What k_n of the network is taken from; by default the overlaps, unless rounded; "
                  "force-over-overlap: 1.5 f/d, Hertz without a material")
      ->transform(one_of({"overlap", "force", "force-over-overlap"}));
  command
      .add_option("--material", o.materials,
                  "Of grains of a type, for files with types: 1:shear-modulus=30GPa,poisson-ratio=0.15; once "
                  "for each")
      ->type_name("TYPE:MATERIAL")
      ->allow_extra_args(false);
  command
      .add_option(
          "--window", o.window,
          "The part whose e, C_n, z*, fabric and stress the closed forms take: "
          "x0..x1,y0..y1,z0..z1, lengths, .. for a whole axis; auto: two to three grains from walls and "
          "free surfaces; none: the whole")
      ->capture_default_str()
      ->type_name("RANGES");
  command.add_option("--depth", o.depth, "The same by depth below the highest grain: 2mm..6mm")
      ->type_name("RANGE");
  command.add_option("--box", o.box, "Edges of the periodic box, LX,LY,LZ, for CSV files, which hold none")
      ->type_name("LENGTHS");
  command.add_option("--frames", o.frames, "all, last, N, FIRST:LAST or FIRST:LAST:STRIDE, from 0")
      ->capture_default_str();
  command
      .add_option(
          "--series", o.series,
          "Which frames have exponents of their own: name, those of files whose names differ in numbers "
          "alone (dense_p50, dense_p100); or all")
      ->transform(one_of({"name", "all"}))
      ->capture_default_str();
  command.add_flag("--no-network", o.no_network, "Leave rung 4 and its 6x6 out, which take the time");
  add_count(command, "--threads", o.threads,
            "That solve the 6x6, by default one for each core; the results do not depend on it");
  command.add_flag("--json", o.json, "Print one JSON object, SI units");
  command.add_flag("--strict", o.strict, "Fail (exit code 4) if there is a warning");
  auto* out =
      add_path(command, "--out", o.out, "Folder for CSV (frames, stiffness, rose, forces), JSON and pictures")
          ->type_name("DIR");
  command.add_flag("--force", o.force, "Let --out replace existing results")->needs(out);
  command.add_flag("--paraview", o.paraview, "Also put grains and force chains there for ParaView")
      ->needs(out);
  in_group(command, grains_group, {"--grain-density", "--friction-angle", "--material"});
  in_group(command, law_group, {"--tangential-ratio", "--rolling-stiffness", "--twisting-stiffness"});
  in_group(command, "Files", {"--frames", "--series", "--column-map", "--box", "--stress"});
  in_group(command, "What is measured",
           {"--window", "--depth", "--no-network", "--threads", "--stiffness-from"});
  in_group(command, output_group, {"--json", "--strict", "--out", "--force", "--paraview"});
}

} // namespace granum::cli
