// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyse.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/elastic/projection.hpp>

#include "frame.hpp"
#include "packing_options.hpp"

namespace granum::cli {

namespace {

struct Options {
  std::vector<std::string> files;
  PackingOptions packing; ///< contact law and grains
  Number friction_angle{0, Dimension::angle};
  std::string column_map;
  std::string stress;
  std::string stiffness_from;
  bool no_network = false;
  OutputOptions output;
};

/// The contact law that the options describe, for any material and radius.
verify::LawFamily law_family(const PackingOptions& options) {
  return [options = options](const contact::GrainMaterial& grain, double radius) mutable {
    options.grain_shear_modulus.value = grain.shear_modulus;
    options.grain_poisson_ratio.value = grain.poisson_ratio;
    options.radius.value = radius;
    return resolve_law(options);
  };
}

verify::AnalysisOptions analysis_options(const Options& o) {
  verify::AnalysisOptions out{.law = law_family(o.packing),
                              .grain_poisson_ratio = o.packing.grain_poisson_ratio.value,
                              .solve_network = !o.no_network};
  if (o.packing.grain_shear_modulus.given())
    out.grain_shear_modulus = o.packing.grain_shear_modulus.value;
  if (o.packing.tangential_ratio.given())
    out.tangential_ratio = o.packing.tangential_ratio.value;
  if (o.friction_angle.given())
    out.friction_coefficient = std::tan(o.friction_angle.value);
  if (!o.stiffness_from.empty())
    out.stiffness_from = o.stiffness_from == "force" ? io::StiffnessFrom::force : io::StiffnessFrom::overlap;
  return out;
}

/// "49kPa,50kPa,51kPa,-0.3kPa,0.4kPa,-0.3kPa".
PrintedStress parse_stress(const std::string& text) {
  PrintedStress out{};
  std::size_t begin = 0;
  for (std::size_t k = 0; k < out.size(); ++k) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    if ((end == text.size()) != (k + 1 == out.size()))
      throw InvalidArgument("--stress takes six stresses, xx,yy,zz,xy,xz,yz, not \"" + text + "\"");
    out[k] = parse_quantity("--stress", text.substr(begin, end - begin), Dimension::pressure);
    begin = end + 1;
  }
  return out;
}

std::vector<ClosedForm> closed_forms(const verify::Analysis& analysis) {
  std::vector<ClosedForm> out;
  if (!analysis.state)
    return out;
  const Packing packing{*analysis.state, analysis.counts.mechanical.coordination_number};
  for (const Rung& rung : all_rungs()) {
    ClosedForm form{.rung = &rung, .answer = std::nullopt, .error = {}};
    try {
      form.answer = answer(rung, packing);
    } catch (const InvalidArgument& error) {
      form.error = error.what();
    }
    out.push_back(std::move(form));
  }
  return out;
}

FrameAnswer analyse_frame(const io::ImportedPacking& packing, const verify::AnalysisOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  FrameAnswer frame{.read = packing.notes, .analysis = verify::analyse(packing, options)};
  frame.closed = closed_forms(frame.analysis);
  frame.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return frame;
}

AnalyseAnswer answer_all(const Options& o) {
  const verify::AnalysisOptions options = analysis_options(o);
  io::PackingFiles files({o.files.begin(), o.files.end()},
                         {.columns = io::parse_column_map(o.column_map), .box = std::nullopt});
  AnalyseAnswer out{.files = o.files, .kinds = files.kinds(), .frames = {}, .skipped = 0};
  for (std::size_t number = 0; auto packing = files.next(); ++number) {
    out.frames.push_back(analyse_frame(*packing, options));
    out.frames.back().number = number;
  }
  out.skipped = files.skipped();
  return out;
}

/// Notes of all frames, each once.
Validity warnings_of(const AnalyseAnswer& answer) {
  Validity out;
  for (const FrameAnswer& frame : answer.frames) {
    for (const std::string& warning : frame.analysis.warnings)
      out.add(warning);
    for (const ClosedForm& form : frame.closed)
      if (form.answer)
        out.merge(form.answer->validity);
  }
  keep_each_once(out);
  return out;
}

ExitCode run(const Options& o) {
  AnalyseAnswer answer = answer_all(o);
  if (!o.stress.empty()) {
    if (answer.frames.size() != 1)
      throw InvalidArgument(fmt::format("--stress is that of one frame, not of {}", answer.frames.size()));
    answer.frames.front().code_stress = parse_stress(o.stress);
  }
  return deliver(o.output, analyse_table(answer), analyse_json(answer), warnings_of(answer));
}

} // namespace

PrintedStress printed(const ContactStress& stress) {
  const Mat3& s = stress.tensor; // f_i l_j
  return {s(0, 0), s(1, 1), s(2, 2), s(1, 0), s(2, 0), s(2, 1)};
}

Moduli moduli_of(const elastic::TransverselyIsotropic& c) {
  return {.K = c.bulk_modulus(),
          .G = (2 * c.C44 + c.C66()) / 5 + (2 * c.C11 + c.C33 - c.C12 - 2 * c.C13) / 15,
          .G_hh = c.G_hh(),
          .G_vh = c.G_vh(),
          .C11 = c.C11,
          .C33 = c.C33,
          .C12 = c.C12,
          .C13 = c.C13};
}

Moduli moduli_of(const elastic::VoigtStiffness& stiffness) {
  return moduli_of(elastic::transversely_isotropic_projection(stiffness));
}

bool says_what_is_missing(io::Finding finding) {
  using enum io::Finding;
  switch (finding) {
  case contacts_unknown:
  case forces_unknown:
  case tangential_unknown:
  case ids_assumed:
  case cell_unknown:
  case boundary_unknown:
  case units_unknown:
  case stiffness_unknown:
  case law_unknown:
  case history_unknown:
    return true;
  default:
    return false;
  }
}

Command add_analyse(CLI::App& program) {
  auto options = std::make_shared<Options>();
  Options& o = *options;
  CLI::App* command = program.add_subcommand(
      "analyse", "A packing that another code wrote: contacts, fabric, stress, contact law, every rung");
  command->add_option("files", o.files, "Grains, and contacts if there are any, of one format")
      ->required()
      ->type_name("FILE");
  add_law_options(*command, o.packing, "--law,--contact");
  command->get_option("--grain-shear-modulus")->default_str("from forces and overlaps");
  add_number_without_default(*command, "--tangential-ratio", o.packing.tangential_ratio,
                             "k_t/k_n of a contact; by default 2(1-nu_g)/(2-nu_g), no slip");
  add_number_without_default(
      *command, "--friction-angle", o.friction_angle,
      "Between grains, to tell which contacts slide; by default as the forces show it");
  command
      ->add_option("--column-map", o.column_map,
                   "What columns of dumps hold: id1=c_cl[1],id2=c_cl[2],force=c_cp[2]")
      ->type_name("MAP");
  command
      ->add_option("--stress", o.stress,
                   "The code's own stress to compare with: xx,yy,zz,xy,xz,yz, compression positive")
      ->type_name("PRESSURES");
  command
      ->add_option("--stiffness-from", o.stiffness_from,
                   "What k_n of the network is taken from; by default the overlaps, unless rounded")
      ->check(CLI::IsMember({"overlap", "force"}));
  command->add_flag("--no-network", o.no_network, "Leave rung 4 out, which takes the time");
  add_output_options(*command, o.output);
  return {command, [options] { return run(*options); }};
}

} // namespace granum::cli
