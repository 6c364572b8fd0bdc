// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyse_options.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <granum/core/check.hpp>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/elastic/projection.hpp>

#include "analyse_paraview.hpp"
#include "analyse_series.hpp"
#include "analyse_stress.hpp"
#include "cli/frame/frame.hpp"
#include "cli/frame/messages.hpp"
#include "studies/analyse/overlaps.hpp"

namespace granum::cli {

namespace {

/// Why rung 3 has no answer for a packing that is not rigid.
std::string declined(const analysis::Measurement& packing) {
  return fmt::format(
      "declines: z* = {:.4g} is not above {:.4g}, the isostatic point; nothing holds such a network",
      packing.microstructure().mechanical_coordination_number,
      effective::isostatic_coordination_number(packing.state->tangential_ratio));
}

void add_closed_forms(FrameAnswer& frame) {
  for (const analysis::ClosedForm& form : frame.measured.packing.closed_forms) {
    RungResult result{
        .name = form.rung->column, .title = effective::label(*form.rung), .error = form.refusal};
    if (form.answer && declines(*form.answer)) {
      result.error = declined(frame.measured.packing);
      frame.validity.merge(form.answer->validity);
    } else if (form.answer) {
      result.moduli = moduli_of(form.answer->stiffness);
      result.relative_error = form.answer->relative_error;
      frame.validity.merge(form.answer->validity);
    }
    frame.rungs.push_back(std::move(result));
  }
}

void add_network(FrameAnswer& frame) {
  if (!frame.measured.packing.network)
    return;
  const network::Response& response = frame.measured.packing.network->response;
  frame.rungs.push_back(
      {.name = "affine", .title = "this network, affine", .moduli = moduli_of(response.affine())});
  RungResult result{.name = network_name, .title = "rung 4, this network"};
  if (response.converged())
    result.moduli = moduli_of(response.relaxed());
  else
    result.error = "did not converge";
  frame.rungs.push_back(std::move(result));
}

FrameAnswer analyse_frame(const io::ImportedPacking& packing, const MeasureOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  analysis::Given given = options.given;
  analysis::Wanted wanted = options.wanted;
  given.materials = studies::materials_of(packing, options.materials);
  if (options.window)
    wanted.window = studies::window_in(packing, *options.window);
  FrameAnswer frame{.read = packing.notes, .measured = studies::measure_frame(packing, given, wanted)};
  frame.window = wanted.window;
  add_closed_forms(frame);
  add_network(frame);
  frame.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return frame;
}

/// Frames of one answer, all of which is in memory until it is written.
constexpr std::size_t most_frames = 10'000;

/// `seen` is called with each frame that is taken and its number.
template <class Seen>
std::vector<FrameAnswer> analyse_frames(io::PackingFiles& files, const FrameChoice& choice,
                                        const MeasureOptions& options, Seen seen) {
  std::vector<FrameAnswer> out;
  const auto take = [&](io::ImportedPacking read, std::size_t at) {
    analysis::Given given = options.given;
    given.materials = studies::materials_of(read, options.materials);
    const io::ImportedPacking packing = studies::with_overlap_contacts(std::move(read), given);
    out.push_back(analyse_frame(packing, options));
    out.back().number = at;
    out.back().file = files.path().string();
    seen(packing, at);
  };
  std::optional<io::ImportedPacking> kept;
  std::size_t number = 0;
  for (; number <= choice.last; ++number) {
    auto packing = files.next();
    if (!packing)
      break;
    if (choice.only_last) {
      kept = std::move(packing);
    } else if (choice.takes(number)) {
      if (out.size() == most_frames) {
        out.back().validity.add(fmt::format(
            "no frame behind the {}th was read; choose others with --frames, such as {}: or 0::10",
            most_frames, number));
        break;
      }
      take(std::move(*packing), number);
    }
  }
  if (kept)
    take(std::move(*kept), number - 1);
  if (out.empty())
    throw InvalidArgument(fmt::format("--frames takes none of the {} frames of the files", number));
  return out;
}

/// Of a table of contacts alone: directions and forces.
FrameAnswer analyse_contacts(io::PackingFile& file, const MeasureOptions& options) {
  const io::ContactTable table = file.kind().format->read_contacts(file.open());
  return {.measured = studies::measure_frame(table, options.given, options.wanted)};
}

io::Existing existing(const AnalyseOptions& o) {
  return o.force ? io::Existing::replace : io::Existing::keep;
}

AnalyseAnswer answer_all(const AnalyseOptions& o) {
  const FrameChoice choice = parse_frames(o.frames);
  const MeasureOptions options = measure_options(o);
  AnalyseAnswer out{.files = {}, .kinds = {}, .frames = {}, .series = {}, .skipped = 0};
  std::vector<io::PackingFile> given =
      io::files_of_series(std::vector<std::filesystem::path>(o.files.begin(), o.files.end()));
  for (const io::PackingFile& file : given) {
    out.files.push_back(file.path().string());
    out.kinds.push_back(file.kind());
  }
  const io::FileKind& first = out.kinds.front();
  if (given.size() == 1 && first.holds == io::Holds::contacts && first.format->read_contacts != nullptr) {
    if (o.paraview)
      throw InvalidArgument("--paraview needs grains: this file has contacts alone");
    out.frames.push_back(analyse_contacts(given.front(), options));
    return out;
  }
  io::PackingFiles files(std::move(given),
                         {.columns = io::parse_column_map(o.column_map), .box = parse_box(o.box)});
  ParaviewFrames pictures(o.out, existing(o));
  out.frames = analyse_frames(files, choice, options, [&](const auto& packing, std::size_t number) {
    if (!o.out.empty())
      out.chains = studies::force_chains(packing.assembly);
    if (o.paraview)
      pictures.add(packing, number);
  });
  if (o.paraview)
    pictures.finish();
  out.series = series_of(out.frames, o.series == "all" ? SeriesBy::all : SeriesBy::name);
  out.skipped = files.skipped();
  return out;
}

/// What all frames have to say against themselves, each once, with the frame where there are several.
Validity warnings_of(const AnalyseAnswer& answer) {
  Validity out;
  for (const FrameAnswer& frame : answer.frames) {
    const std::string where = answer.frames.size() > 1 ? fmt::format("frame {}: ", frame.number) : "";
    Validity own{frame.measured.warnings};
    own.merge(frame.validity);
    judge_code_stress(frame, own);
    own.keep_each_once();
    for (const std::string& note : own.notes)
      out.add(where + note);
  }
  return out;
}

/// What networks that were not solved come to, which is said.
ExitCode code_of_networks(const std::vector<FrameAnswer>& frames) {
  std::size_t networks = 0, unsolved = 0;
  for (const FrameAnswer& frame : frames)
    if (const auto& network = frame.measured.packing.network) {
      ++networks;
      unsolved += network->response.converged() ? 0U : 1U;
    }
  if (unsolved > 0)
    say("error", fmt::format("{} of {} networks not solved: no moduli of rung 4", unsolved, networks));
  return code_of_failed(unsolved, networks);
}

ExitCode run(const AnalyseOptions& o) {
  if (!o.out.empty())
    prepare_folder(o.out, analysis_files, o.force);
  AnalyseAnswer answer = answer_all(o);
  take_code_stress(o.stress, answer.frames);
  std::string table = o.json && o.out.empty() ? "" : analyse_table(answer);
  if (!o.out.empty()) {
    write_analysis(o.out, answer, table, existing(o));
    table += "\nreport.html, CSV, JSON and pictures in " + o.out + "\n";
  }
  const OutputOptions to_screen{.json = o.json, .strict = o.strict, .force = false, .out = {}};
  const ExitCode code = deliver(to_screen, table, analyse_json(answer), warnings_of(answer));
  const ExitCode of_networks = code_of_networks(answer.frames);
  return code == ExitCode::ok ? of_networks : code;
}

} // namespace

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

const RungResult* find_rung(const FrameAnswer& frame, const std::string& name) {
  const auto found = std::find_if(frame.rungs.begin(), frame.rungs.end(),
                                  [&](const RungResult& rung) { return rung.name == name && rung.moduli; });
  return found == frame.rungs.end() ? nullptr : &*found;
}

const Moduli* network_moduli(const FrameAnswer& frame) {
  const RungResult* network = find_rung(frame, network_name);
  return network == nullptr ? nullptr : &*network->moduli;
}

bool says_what_is_missing(io::Finding finding) {
  using enum io::Finding;
  switch (finding) {
  case contacts_unknown:
  case walls_unknown:
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
  auto options = std::make_shared<AnalyseOptions>();
  CLI::App* command = program.add_subcommand(
      "analyse", "A packing that another code wrote: contacts, fabric, stress, contact law, every rung");
  add_analyse_options(*command, *options);
  return {command, [options] { return run(*options); }};
}

} // namespace granum::cli
