// SPDX-License-Identifier: GPL-3.0-or-later
#include "suggest.hpp"

#include <algorithm>
#include <cmath>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <granum/core/error.hpp>
#include <granum/core/near_miss.hpp>
#include <granum/core/number.hpp>

#include "contradictions.hpp"
#include "help.hpp"
#include "studies/scene/scene_keys.hpp"

namespace granum::cli {

namespace {

using Names = std::vector<std::string>;

/// What people call an input, without hyphens and in small letters unless they tell: the options that it may
/// be, of which a command has some.
struct Symbol {
  std::vector<std::string> names;
  std::vector<std::string> options;
  std::string remark = {};
};

const std::vector<Symbol>& symbols() {
  static const std::vector<Symbol> table = {
      {{"e", "e0", "voidratio"}, {"--void-ratio"}},
      {{"n", "phi"}, {"--porosity", "--friction-angle"}},
      {{"packingfraction", "volumefraction", "solidsfraction", "nu_s"}, {"--solid-fraction"}},
      {{"p",
        "p0",
        "pc",
        "p'",
        "pm",
        "sigma",
        "sigma0",
        "sigma3",
        "sigmac",
        "s3",
        "stress",
        "confiningpressure",
        "confiningstress",
        "confinement",
        "confining",
        "meanstress",
        "meaneffectivestress",
        "effectivestress",
        "cellpressure",
        "isotropicstress"},
       {"--from", "--pressure"}},
      {{"nu", "nug", "v", "poisson", "poissonratio", "poissonsratio"}, {"--grain-poisson-ratio"}},
      {{"Gs", "gs"},
       {"--grain-density", "--grain-shear-modulus"},
       "a specific gravity of 2.65 is the density 2.65g/cm3"},
      {{"specificgravity", "rhos", "rhog", "soliddensity"}, {"--grain-density"}},
      {{"rho", "rhod", "density", "drydensity", "bulkdensity"},
       {"--grain-density", "--void-ratio"},
       "of the solid rho_s; with the dry density of the packing e = rho_s/rho_d - 1"},
      {{"gamma", "gammad", "gammasat", "bulkunitweight"}, {"--unit-weight", "--grain-density"}},
      {{"G", "g", "Gg", "gg", "mug", "modulus", "grainmodulus", "shearmodulus"},
       {"--shear-modulus", "--grain-shear-modulus"}},
      {{"E", "Eg", "Es", "youngmodulus", "youngsmodulus", "grainyoungmodulus"},
       {"--grain-shear-modulus"},
       "of Young's modulus it is G_g = E_g/(2(1 + nu_g))"},
      {{"G0", "g0", "Gmax", "gmax"}, {"--shear-modulus"}},
      {{"K", "k", "bulk"}, {"--bulk-modulus"}},
      {{"v_s", "Vs", "shearwave"}, {"--vs"}},
      {{"v_p", "Vp", "pwave"}, {"--vp"}},
      {{"d", "D", "diameter", "grainsize", "particlesize", "graindiameter", "meandiameter", "meansize"},
       {"--d50", "--radius"}},
      {{"r", "R", "grainradius", "particleradius"}, {"--radius"}},
      {{"cu", "uniformitycoefficient", "gradation"}, {"--uniformity"}},
      {{"psd", "gsd", "sievecurve", "sizedistribution"}, {"--sieve", "--sizes"}},
      {{"z", "cn", "nc", "coordination", "contacts", "contactnumber"},
       {"--depth", "--mechanical-coordination-number", "--coordination-number"}},
      {{"zstar", "z*", "zm"}, {"--mechanical-coordination-number"}},
      {{"rattlers", "floaters"}, {"--rattler-fraction"}},
      {{"k0", "ko"}, {"--k0", "--predict-stress-ratio", "--stress-h"}, "sigma_h = K_0 sigma_v"},
      {{"stressratio"}, {"--predict-stress-ratio", "--eta"}},
      {{"q"}, {"--eta"}},
      {{"dr", "id", "rd", "densityindex"}, {"--relative-density"}},
      {{"emin"}, {"--least-void-ratio"}},
      {{"emax"}, {"--largest-void-ratio"}},
      {{"s", "sr"}, {"--saturation"}},
      {{"sigmav", "sigma1", "sigmaz", "sigmaa", "sv", "s1", "verticalstress", "axialstress"}, {"--stress-v"}},
      {{"sigmah", "sigmar", "sh", "horizontalstress", "radialstress"}, {"--stress-h"}},
      {{"mu", "friction", "frictioncoefficient"}, {"--friction-angle", "--preparation"}},
      {{"a", "anisotropy"}, {"--fabric"}},
      {{"shape", "law", "model", "contactlaw", "contactmodel"}, {"--contact"}},
      {{"mineral", "material", "solid"}, {"--grain", "--material"}},
      {{"gwt", "waterlevel", "groundwater"}, {"--water-table"}},
      {{"fines", "finescontent", "fc"}, {}, "fines are not modelled: the laws are of clean sands"},
      {{"ocr", "overconsolidation", "age", "ageing"},
       {},
       "overconsolidation and age are not modelled; granum infer takes a measured speed of the ground"},
      {{"cement", "cementation", "bond"},
       {},
       "cement is not modelled here; the library and Python have contact cement and stiff and soft sand, "
       "rock_physics"},
      {{"pa", "patm", "pref", "referencepressure"}, {"--atmospheric-pressure"}},
      {{"o", "output", "outfile"}, {"--out"}},
      {{"f", "overwrite"}, {"--force"}},
      {{"plot", "figure", "svg", "chart", "graph"}, {"--picture"}},
      {{"csv", "file", "input", "data"}, {"--table"}},
      {{"config", "c"}, {"--scene"}},
      {{"particles", "ngrains", "numberofgrains"}, {"--grains"}},
      {{"j", "jobs", "nthreads", "cores"}, {"--threads"}},
      {{"verbose", "silent", "quiet"}, {"--quiet"}},
      {{"v", "version"}, {"--version"}},
  };
  return table;
}

/// Other programs' and other people's words for the commands.
const std::vector<Symbol>& other_command_names() {
  static const std::vector<Symbol> table = {
      {{"analyze", "analysis", "read", "import", "postprocess"}, {"analyse"}},
      {{"calc", "calculate", "compute", "modulus", "stiffness", "gmax"}, {"estimate"}},
      {{"inverse", "invert", "calibrate"}, {"infer"}},
      {{"profile", "depth", "path", "table", "plot"}, {"sweep"}},
      {{"regress", "hardin"}, {"fit"}},
      {{"run", "simulate", "dem", "check"}, {"verify"}},
      {{"lammps", "write"}, {"export"}},
  };
  return table;
}

/// "--Void_Ratio" as "VoidRatio".
std::string bare(std::string_view word) {
  std::string text(word);
  std::erase_if(text, [](char c) { return c == '-' || c == '_'; });
  return text;
}

/// "--void-ratio" as "void-ratio".
std::string without_hyphens(const std::string& word) {
  return word.substr(std::min(word.find_first_not_of('-'), word.size()));
}

const Symbol* find_symbol(const std::vector<Symbol>& table, const std::string& name) {
  for (const std::string& wanted : {name, in_small_letters(name)})
    for (const Symbol& symbol : table)
      if (std::find(symbol.names.begin(), symbol.names.end(), wanted) != symbol.names.end())
        return &symbol;
  return nullptr;
}

/// Without their hyphens.
Names long_options(const CLI::App& command) {
  Names names;
  for (const CLI::Option* option : command.get_options())
    names.insert(names.end(), option->get_lnames().begin(), option->get_lnames().end());
  return names;
}

std::vector<const CLI::App*> commands_within(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

/// All that take options.
std::vector<const CLI::App*> all_commands(const CLI::App& program) {
  std::vector<const CLI::App*> found;
  for (const CLI::App* command : commands_within(program)) {
    const std::vector<const CLI::App*> inner = commands_within(*command);
    found.insert(found.end(), inner.begin(), inner.end());
    if (inner.empty())
      found.push_back(command);
  }
  return found;
}

Names those_of(const CLI::App& command, const Names& wanted) {
  Names known;
  for (const std::string& name : wanted)
    if (command.get_option_no_throw(name) != nullptr)
      known.push_back(name);
  return known;
}

/// The commands that take one of the options, the first of which they take.
std::string of_other_commands(const CLI::App& program, const Names& wanted) {
  for (const std::string& name : wanted) {
    Names takers;
    for (const CLI::App* command : all_commands(program))
      if (command->get_option_no_throw(name) != nullptr)
        takers.push_back(full_name(*command));
    if (!takers.empty())
      return fmt::format("{} is for {}", name, fmt::join(takers, ", "));
  }
  return {};
}

/// Keys of the scene, for a command that takes one.
Names near_scene_keys(const CLI::App& command, const std::string& name) {
  if (command.get_option_no_throw("--set") == nullptr)
    return {};
  Names keys;
  for (const studies::SceneKey& key : studies::scene_keys())
    keys.push_back(key.name);
  return near_misses(name, keys);
}

/// What an option was meant to be, as the end of a sentence; empty if nobody knows.
std::string meant_option(const CLI::App& program, const CLI::App& command, const std::string& typed) {
  const Symbol* symbol = find_symbol(symbols(), bare(typed));
  if (symbol != nullptr && symbol->options.empty())
    return ": " + symbol->remark;
  if (symbol != nullptr)
    if (const Names known = those_of(command, symbol->options); !known.empty())
      return fmt::format("; did you mean {}?{}", fmt::join(known, " or "),
                         symbol->remark.empty() ? "" : " (" + symbol->remark + ")");
  const std::string name = without_hyphens(typed);
  const Names near = near_misses(name, long_options(command));
  if (!near.empty() && near.size() <= 3)
    return fmt::format("; did you mean --{}?", fmt::join(near, " or --"));
  if (const Names keys = near_scene_keys(command, name); !keys.empty() && keys.size() <= 3)
    return fmt::format("; did you mean --set {}?", fmt::join(keys, " or --set "));
  if (const std::string exactly = of_other_commands(program, {typed}); !exactly.empty())
    return "; " + exactly;
  const std::string elsewhere =
      symbol != nullptr ? of_other_commands(program, symbol->options) : std::string();
  return elsewhere.empty() ? fmt::format("; {} --help lists what there is", full_name(command))
                           : "; " + elsewhere;
}

/// A word that begins with a dash of a text processor, with hyphens instead; empty for other words.
std::string with_hyphens(const std::string& word) {
  constexpr std::string_view dashes[] = {"-", "\u2010", "\u2011", "\u2013", "\u2014", "\u2212"};
  std::string_view rest = word;
  for (auto dash = std::begin(dashes); dash != std::end(dashes);)
    if (rest.starts_with(*dash)) {
      rest.remove_prefix(dash->size());
      dash = std::begin(dashes);
    } else
      ++dash;
  return rest.size() == word.size() || word[0] == '-' ? std::string() : "--" + std::string(rest);
}

std::string stray_word(const CLI::App& program, const CLI::App& command, const std::string& word) {
  const std::string said = fmt::format("{} does not know what '{}' is", full_name(command), word);
  if (const std::string mended = with_hyphens(word); !mended.empty())
    return fmt::format("'{}' begins with a dash, not with hyphens: write {}", word, mended);
  const std::string key = word.substr(0, word.find('='));
  if (key.size() < word.size()) {
    const std::string option = "--" + key;
    if (command.get_option_no_throw(option) != nullptr)
      return fmt::format("{}: write {} {}", said, option, word.substr(key.size() + 1));
    return said + meant_option(program, command, option);
  }
  if (command.get_option_no_throw("--" + word) != nullptr)
    return fmt::format("{}: write --{}", said, word);
  return said + ": the name of an option stands before each value, as in --out FILE";
}

bool looks_like_option(const std::string& word) {
  return word.size() > 1 && word[0] == '-' && word != "--" && !leading_number(word);
}

/// A text as a number with its unit; empty, or what is wrong.
std::string fault_of_quantity(const std::string& name, const std::string& text, Dimension dimension) {
  try {
    (void)parse_quantity(name, text, dimension);
  } catch (const InvalidArgument& error) {
    const std::string what = error.what();
    const bool several = what.find("several values") != std::string::npos;
    return several ? what + "; granum sweep takes a path or a table of states" : what;
  }
  return {};
}

/// The same of a number without a unit, where the parser takes one.
std::string fault_of_number(const std::string& name, const std::string& text, const std::string& type) {
  const std::optional<double> number = parse_number(text);
  const bool whole = type == "UINT" || type == "INT" || type == "N";
  if ((!whole && type != "FLOAT") || (number && (!whole || *number == std::floor(*number))))
    return {};
  return fmt::format("{} = '{}': expected a {}number", name, text, whole ? "whole " : "");
}

/// What is wrong with one of the values of an option.
std::string fault_of_one(const TypedArgument& typed, const std::string& value) {
  const CLI::Option& option = *typed.option;
  const std::string full = option.get_type_name(), type = full.substr(0, full.find(':'));
  if (const auto dimension = dimension_of(option); dimension && type == type_name(*dimension))
    if (const std::string fault = fault_of_quantity(typed.word, value, *dimension); !fault.empty())
      return fault;
  if (const std::string fault = fault_of_number(typed.word, value, type); !fault.empty())
    return fault;
  const std::string complaint = checked(option, value).complaint;
  return complaint.empty() ? complaint : fmt::format("{}: {}", typed.word, complaint);
}

/// The first thing that is wrong with an option that the command knows; empty if nothing is.
std::string fault_of_value(const TypedArgument& typed) {
  const CLI::Option& option = *typed.option;
  if (option.get_items_expected_min() > 0 && typed.values.empty())
    return typed.word + " has no value";
  for (const std::string& given : typed.values) {
    const char delimiter = option.get_delimiter();
    for (const std::string& value : delimiter == '\0' ? Names{given} : CLI::detail::split(given, delimiter))
      if (const std::string fault = fault_of_one(typed, value); !fault.empty())
        return fault;
  }
  return {};
}

} // namespace

std::vector<std::string> faults_of(const CLI::App& program, const CLI::App& command,
                                   const std::vector<TypedArgument>& arguments) {
  const bool positionals =
      !command.get_options([](const CLI::Option* o) { return o->get_positional(); }).empty();
  std::vector<std::string> faults;
  std::vector<const CLI::Option*> before;
  Contradictions contradictions(command, arguments);
  bool of_unknown = false; // the word before is an option that nobody knows: this one may be its value
  for (std::size_t k = 0; k < arguments.size(); ++k) {
    const TypedArgument& typed = arguments[k];
    std::string fault;
    const bool unknown = typed.option == nullptr && looks_like_option(typed.word);
    const bool once = typed.option != nullptr && typed.option->get_items_expected_max() == 1;
    if (once && std::find(before.begin(), before.end(), typed.option) != before.end())
      fault = typed.word + " is given twice";
    else if (typed.option != nullptr)
      fault = fault_of_value(typed);
    else if (unknown)
      fault = fmt::format("{} has no option {}{}", full_name(command), typed.word,
                          meant_option(program, command, typed.word));
    else if (!positionals && !of_unknown)
      fault = stray_word(program, command, typed.word);
    if (!fault.empty())
      faults.push_back(fault);
    if (const std::string contradiction = contradictions.of(k); !contradiction.empty())
      faults.push_back(contradiction);
    before.push_back(typed.option);
    of_unknown = unknown || (of_unknown && typed.option == nullptr);
  }
  return faults;
}

std::string unknown_command(const CLI::App& program, const std::vector<std::string>& words) {
  const std::string& word = words.front();
  Names names;
  for (const CLI::App* command : commands_within(program))
    names.push_back(command->get_name());
  if (looks_like_option(word)) {
    const Names near = near_misses(without_hyphens(word), long_options(program));
    if (!near.empty())
      return fmt::format("{} has no option {}; did you mean --{}?", full_name(program), word, near.front());
    const std::string takers = of_other_commands(program, {word.substr(0, word.find('='))});
    return fmt::format("the first word is the command, one of {}{}", fmt::join(names, ", "),
                       takers.empty() ? "" : "; " + takers);
  }
  const std::string said = fmt::format("there is no command '{}'", word);
  const Symbol* symbol = find_symbol(other_command_names(), word);
  if (symbol != nullptr && std::find(names.begin(), names.end(), symbol->options.front()) != names.end())
    return fmt::format("{}; did you mean {}?", said, symbol->options.front());
  const std::string near = did_you_mean(word, names);
  return said + (near.empty() ? fmt::format("; there are {}", fmt::join(names, ", ")) : near);
}

} // namespace granum::cli
