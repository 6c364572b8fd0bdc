// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyse_options.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/io/imported_packing.hpp>
#include <granum/io/vtk/paraview.hpp>

#include "analyse_stress.hpp"
#include "cli/frame/frame.hpp"
#include "cli/frame/help.hpp"
#include "cli/frame/messages.hpp"
#include "studies/analyse/axis.hpp"
#include "studies/analyse/grain_fields.hpp"
#include "studies/analyse/overlaps.hpp"

namespace granum::cli {

namespace {

namespace fs = std::filesystem;

/// Frames for ParaView, grains and contacts of each, and an index file with their times; for OVITO grains.
struct DrawnFrames {
  fs::path folder;
  io::Existing existing;
  bool paraview, xyz;
  std::optional<io::ImportedPacking> before = {}; ///< grains of the frame ahead
  std::vector<io::SeriesEntry> grains = {}, contacts = {};

  void add(const io::ImportedPacking& packing, FrameAnswer& frame) {
    if (!paraview && !xyz)
      return;
    auto& network = frame.measured.packing.network;
    const std::vector<io::GrainField> fields =
        studies::grain_fields(packing, network ? network->response.take_motions() : network::StrainMotions(),
                              before ? &*before : nullptr);
    before = {.assembly = {.cell = packing.assembly.cell,
                           .position = packing.assembly.position,
                           .radius = packing.assembly.radius,
                           .contacts = {}},
              .id = packing.id,
              .periodic = packing.periodic,
              .time = {},
              .notes = {}};
    if (xyz)
      write(fmt::format("grains-{}.xyz", frame.number),
            io::grains_xyz(packing.assembly, packing.periodic, fields, packing.id, packing.time));
    if (!paraview)
      return;
    const double time = packing.time.value_or(static_cast<double>(packing.step));
    write(grains.emplace_back(io::SeriesEntry{time, fmt::format("grains-{}.vtu", frame.number)}).file,
          io::grains_vtu(packing.assembly, packing.id, packing.time, fields));
    write(contacts.emplace_back(io::SeriesEntry{time, fmt::format("contacts-{}.vtp", frame.number)}).file,
          io::contacts_vtp(packing.assembly, packing.id, studies::known_forces(packing)));
  }
  void finish() const {
    if (!paraview)
      return;
    write("grains.pvd", io::pvd(grains));
    write("contacts.pvd", io::pvd(contacts));
  }
  void write(const std::string& name, const std::string& text) const {
    io::write_file(folder / name, text, existing);
  }
};

/// Largest number of frames of one run; all results are in memory until they are written.
constexpr std::size_t most_frames = 10'000;

/// `seen` is called with each selected frame and its answer.
template <class Seen>
std::vector<FrameAnswer> analyse_frames(io::PackingFiles& files, const FrameChoice& choice,
                                        const studies::MeasureOptions& options, studies::Axis axis,
                                        Seen seen) {
  std::vector<FrameAnswer> out;
  const auto take = [&](io::ImportedPacking read, std::size_t at) {
    analysis::Given given = options.given;
    given.materials = studies::materials_of(read, options.materials);
    const io::ImportedPacking packing =
        studies::about_axis(studies::with_overlap_contacts(std::move(read), given), axis);
    out.push_back(studies::answer_frame(packing, options));
    out.back().number = at;
    out.back().file = files.path().string();
    seen(packing, out.back());
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
            "only the first {} frames were read; select others with --frames, such as {}: or 0::10",
            most_frames, number));
        break;
      }
      take(std::move(*packing), number);
    }
  }
  if (kept)
    take(std::move(*kept), number - 1);
  if (out.empty())
    throw InvalidArgument(fmt::format("--frames selects none of the {} frames of the files", number));
  return out;
}

/// For a table of contacts without grains: directions and forces.
/// \throws   InvalidArgument for options that need grains
FrameAnswer analyse_contacts(io::PackingFile& file, const studies::MeasureOptions& options,
                             const io::PackingFileOptions& of_files, const AnalyseOptions& o) {
  for (const auto& [given, option] : {std::pair(of_files.box.has_value(), "--box"),
                                      {o.axis != "z", "--axis"},
                                      {options.window && !options.window->depth, "--window"},
                                      {options.window && options.window->depth, "--depth"},
                                      {options.profile.has_value(), "--profile"},
                                      {o.paraview, "--paraview"},
                                      {o.xyz, "--xyz"},
                                      {!o.hessian.empty(), "--hessian"},
                                      {o.modes.has_value(), "--modes"}})
    if (given)
      throw InvalidArgument(std::string(option) + " needs grains: " + file.path().string() +
                            " has contacts alone");
  if (const FrameChoice choice = parse_frames(o.frames); !choice.only_last && !choice.takes(0))
    throw InvalidArgument("--frames " + o.frames + " selects none of the 1 frames of the files");
  if (!of_files.columns.empty())
    throw InvalidArgument("--column-map is for dumps, and " + file.path().string() + " is none");
  const io::ContactTable table = file.kind().format->read_contacts(file.open(), of_files);
  return {.measured = studies::measure_frame(table, options.given, options.wanted)};
}

AnalyseAnswer answer_all(const AnalyseOptions& o) {
  const FrameChoice choice = parse_frames(o.frames);
  const studies::MeasureOptions options = measure_options(o);
  const io::PackingFileOptions of_files{
      .columns = io::parse_column_map(o.column_map), .box = parse_box(o.box), .si = o.units == "si"};
  const studies::Axis axis = studies::parse_axis(o.axis).value();
  if (axis != studies::Axis::z && !o.stress.empty())
    throw InvalidArgument("--stress is in the axes of the files: leave out --axis " + o.axis);
  AnalyseAnswer out{.files = {}, .kinds = {}, .frames = {}, .series = {}, .skipped = 0};
  std::vector<io::PackingFile> given =
      io::files_of_series(std::vector<std::filesystem::path>(o.files.begin(), o.files.end()));
  for (const io::PackingFile& file : given) {
    out.files.push_back(file.path().string());
    out.kinds.push_back(file.kind());
  }
  const io::FileKind& first = out.kinds.front();
  if (given.size() == 1 && first.holds == io::Holds::contacts && first.format->read_contacts != nullptr) {
    out.frames.push_back(analyse_contacts(given.front(), options, of_files, o));
    return out;
  }
  io::PackingFiles files(std::move(given), of_files);
  DrawnFrames drawn{o.out, existing(o.force), o.paraview, o.xyz};
  std::optional<io::ImportedPacking> last;
  out.frames = analyse_frames(files, choice, options, axis, [&](const auto& packing, FrameAnswer& frame) {
    if (!o.out.empty())
      out.chains = studies::force_chains(packing.assembly);
    drawn.add(packing, frame);
    if (!o.hessian.empty())
      last = packing;
  });
  drawn.finish();
  if (last)
    io::write_file(o.hessian, stiffness_file(*last, options), existing(o.force));
  out.series =
      studies::series_of(out.frames, o.series == "all" ? studies::SeriesBy::all : studies::SeriesBy::name);
  out.skipped = files.skipped();
  out.cut = files.cut();
  out.replaced = files.replaced();
  return out;
}

/// "frame 3: ", "2 of 7 frames (0, 4): "
std::string frames_text(const std::vector<std::size_t>& frames, std::size_t all) {
  constexpr std::size_t most = 5;
  if (frames.size() == 1)
    return fmt::format("frame {}: ", frames.front());
  if (frames.size() == all)
    return fmt::format("all {} frames: ", all);
  std::string list;
  for (std::size_t k = 0; k < std::min(most, frames.size()); ++k)
    list += (k > 0 ? ", " : "") + std::to_string(frames[k]);
  return fmt::format("{} of {} frames ({}{}): ", frames.size(), all, list,
                     frames.size() > most ? ", ..." : "");
}

/// The warnings of all frames, each once, with the numbers of their frames if there are several.
Validity warnings_of(const AnalyseAnswer& answer) {
  Validity out;
  std::vector<std::pair<std::string, std::vector<std::size_t>>> found; // each warning, and its frames
  for (const FrameAnswer& frame : answer.frames) {
    Validity own{frame.measured.warnings};
    own.merge(frame.validity);
    judge_code_stress(frame, own);
    own.keep_each_once();
    for (const std::string& note : own.notes) {
      const auto known =
          std::find_if(found.begin(), found.end(), [&](const auto& f) { return f.first == note; });
      (known == found.end() ? found.emplace_back(note, std::vector<std::size_t>{}) : *known)
          .second.push_back(frame.number);
    }
  }
  for (const auto& [note, frames] : found)
    out.add(answer.frames.size() > 1 ? frames_text(frames, answer.frames.size()) + note : note);
  for (const std::string& text : answer.replaced)
    out.add(text);
  if (!answer.cut.empty())
    out.add("the last frame is cut off and was left out: " + answer.cut);
  return out;
}

/// Exit code for networks that did not converge, with a message.
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
  require_free({.json = false, .strict = false, .force = o.force, .out = o.hessian}, "");
  AnalyseAnswer answer = answer_all(o);
  take_code_stress(o.stress, answer.frames);
  take_probes(o.probes, answer.frames);
  Document document = analysed(answer);
  document.warnings = warnings_of(answer);
  std::string text = o.json && o.out.empty() ? "" : screen(document, true);
  if (!o.out.empty()) {
    write_analysis(o.out, answer, document, existing(o.force));
    text += within_width("\nreport.html, CSV, JSON and pictures in " + o.out + "\n");
  }
  const OutputOptions to_screen{.json = o.json, .strict = o.strict, .force = false, .out = {}};
  const ExitCode code = deliver(to_screen, text, json(document), document.warnings);
  const ExitCode of_networks = code_of_networks(answer.frames);
  return code == ExitCode::ok ? of_networks : code;
}

} // namespace

bool says_what_is_missing(io::Finding finding) {
  using enum io::Finding;
  constexpr io::Finding missing[] = {contacts_unknown,  walls_unknown, forces_unknown,   tangential_unknown,
                                     ids_assumed,       cell_unknown,  boundary_unknown, units_unknown,
                                     stiffness_unknown, law_unknown,   history_unknown};
  return std::ranges::find(missing, finding) != std::end(missing);
}

Command make_analyse() {
  auto options = std::make_shared<AnalyseOptions>();
  Command command{
      .name = "analyse",
      .meaning =
          "Packings of DEM codes: contacts, fabric, stress, contact law, and stiffness by each estimate",
      .run = [options] { return run(*options); }};
  add_analyse_options(command, *options);
  return command;
}

} // namespace granum::cli
