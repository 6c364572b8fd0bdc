// SPDX-License-Identifier: GPL-3.0-or-later
#include "path_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <system_error>
#include <utility>

#include <granum/core/error.hpp>
#include <granum/dem/specimen.hpp>
#include <granum/io/checkpoint/checkpoint.hpp>
#include <granum/triaxial/specimen.hpp>

#include "studies/running/outcome_text.hpp"

namespace granum::studies {

namespace {

/// Points of the curve between two frozen ones.
constexpr double curve_refinement = 5;

/// The checkpoint of one piece: its bytes, if there are any yet, and their writing. The file names its
/// piece, so that one that was renamed, or stored in another's place, is refused.
class Store {
 public:
  /// \param    stem   name of the piece: of the file without its ending, and its subject
  Store(const CheckpointFolder& checkpoints, std::string stem)
      : subject_(std::move(stem)), scene_text_(checkpoints.scene_text) {
    if (!checkpoints.folder.empty())
      path_ = checkpoints.folder / (subject_ + ".checkpoint");
  }

  [[nodiscard]] std::optional<std::string> bytes() const {
    std::error_code error;
    if (path_.empty() || !std::filesystem::exists(path_, error)) {
      if (error)
        throw FileError(name(), 0, "cannot be read: " + error.message());
      return std::nullopt;
    }
    io::Checkpoint checkpoint = io::read_checkpoint(path_);
    if (checkpoint.scene != scene_text_)
      throw FileError(name(), 0, "is the checkpoint of another scene");
    if (checkpoint.subject != subject_)
      throw FileError(name(), 0, "is the checkpoint of " + checkpoint.subject + ", not of " + subject_);
    return std::move(checkpoint.state);
  }
  [[nodiscard]] std::string name() const { return path_.string(); }
  void write(const ByteWriter& bytes) const {
    if (!path_.empty())
      io::write_checkpoint(path_, {.subject = subject_, .scene = scene_text_, .state = bytes.bytes()});
  }

 private:
  std::filesystem::path path_;
  std::string subject_, scene_text_;
};

std::string stem(const Piece& piece, const std::optional<stress::ShearPath>& path) {
  return std::string(name(piece.contact)) + "-" + std::string(name(piece.density)) + "-" +
         std::to_string(piece.seed) + "-" + path_in_file_names(path);
}

std::string title(const Piece& piece, const std::optional<stress::ShearPath>& path) {
  return std::string(name(piece.contact)) + " " + std::string(name(piece.density)) + " #" +
         std::to_string(piece.seed) + " " + std::string(name(path));
}

void put_text(ByteWriter& to, const std::string& text) {
  to.put_all(std::vector<char>(text.begin(), text.end()));
}

std::string get_text(ByteReader& from) {
  const std::vector<char> text = from.get_all<char>();
  return {text.begin(), text.end()};
}

/// All except the failure: a resumed run tries again.
void save_run(ByteWriter& to, const PathRun& run) {
  to.put_all(run.points);
  to.put_all(run.curve);
  to.put(static_cast<std::uint64_t>(run.loops.size()));
  for (const ShearLoop& loop : run.loops) {
    to.put(loop.eta);
    to.put(loop.amplitude);
    to.put_all(loop.points);
  }
  to.put(run.peak);
  to.put(run.path_error);
  to.put(run.largest_inertial_number);
  to.put(run.steps);
  to.put(static_cast<std::uint64_t>(run.notes.size()));
  for (const std::string& note : run.notes)
    put_text(to, note);
}

PathRun load_run(ByteReader& from, const std::optional<stress::ShearPath>& path) {
  PathRun run;
  run.path = path;
  run.points = from.get_all<StateRecord>();
  run.curve = from.get_all<triaxial::PathPoint>();
  for (auto loops = from.get<std::uint64_t>(); loops > 0; --loops) {
    ShearLoop loop{.eta = from.get<double>(), .amplitude = from.get<double>(), .points = {}};
    loop.points = from.get_all<triaxial::LoopPoint>();
    run.loops.push_back(std::move(loop));
  }
  run.peak = from.get<triaxial::PathPoint>();
  run.path_error = from.get<double>();
  run.largest_inertial_number = from.get<double>();
  run.steps = from.get<std::size_t>();
  for (auto notes = from.get<std::uint64_t>(); notes > 0; --notes)
    run.notes.push_back(get_text(from));
  return run;
}

/// A quantity's multiples, counted as they are passed for the first time.
struct Multiples {
  double step = 0;
  std::size_t next = 1;

  bool passes(double value) {
    const std::size_t before = next;
    if (step > 0)
      while (value >= static_cast<double>(next) * step)
        ++next;
    return next != before;
  }
};

/// When a specimen on a shear path is frozen: by eta, by axial strain, to be probed, and to be cycled.
using Schedule = std::array<Multiples, 4>;

triaxial::PathPoint isotropic_point(const triaxial::Snapshot& snapshot, const Mat3& first_cell) {
  const Mat3& stress = snapshot.report.stress();
  const Mat3& cell = snapshot.state.cell;
  return {.stress = {.v = stress(2, 2), .h = (stress(0, 0) + stress(1, 1)) / 2},
          .stress_difference = std::abs(stress(0, 0) - stress(1, 1)),
          .axial_strain = -std::log(cell(2, 2) / first_cell(2, 2)),
          .volumetric_strain = -std::log(determinant(cell) / determinant(first_cell)),
          .work = 0,
          .step = snapshot.report.steps};
}

} // namespace

std::string path_in_file_names(const std::optional<stress::ShearPath>& path) {
  std::string out(name(path));
  std::ranges::transform(out, out.begin(), [](char c) { return static_cast<char>(c - 'A' + 'a'); });
  return out;
}

dem::Specimen packing(const Piece& piece) {
  const std::string stem = std::string(name(piece.contact)) + "-" + std::to_string(piece.seed) + "-packing";
  const Store store(piece.checkpoints, stem);
  if (const std::optional<std::string> bytes = store.bytes()) {
    ByteReader from(*bytes, store.name());
    piece.meter.found(piece.work, stem);
    return dem::load_specimen(from);
  }
  dem::Specimen state = triaxial::frictionless_specimen(recipe(piece.scene, piece.contact, piece.seed),
                                                        piece.meter.stop_request())
                            .state;
  ByteWriter to;
  dem::save_specimen(to, state);
  store.write(to);
  piece.meter.add(piece.work, stem);
  return state;
}

PathRun isotropic_run(const Piece& piece, const dem::Specimen& packing, dem::Specimen& end) {
  const StudySection& study = piece.scene.study;
  const Store store(piece.checkpoints, stem(piece, std::nullopt));
  const std::string what = title(piece, std::nullopt);
  const triaxial::SpecimenRecipe specimen = recipe(piece.scene, piece.contact, piece.seed);
  const double work = piece.work / static_cast<double>(study.pressures.size());
  PathRun run;
  dem::Specimen state;
  Mat3 first_cell;
  if (const std::optional<std::string> bytes = store.bytes()) {
    ByteReader from(*bytes, store.name());
    state = dem::load_specimen(from);
    first_cell = from.get<Mat3>();
    run = load_run(from, std::nullopt);
    if (run.points.size() > study.pressures.size())
      from.fail("contains more states than the scene has pressures");
    piece.meter.found(work * static_cast<double>(run.points.size()), what);
  } else {
    state = triaxial::start_of_compression(packing, piece.density, specimen, piece.meter.stop_request());
  }
  dem::QuasistaticOptions options = triaxial::compression_options();
  options.stop_requested = piece.meter.stop_request();
  const auto visit = [&](const triaxial::Snapshot& snapshot) {
    run.steps += snapshot.report.steps;
    run.failure = failure_of(snapshot);
    if (!run.failure.empty())
      return false;
    if (run.points.empty())
      first_cell = snapshot.state.cell;
    run.largest_inertial_number =
        std::max(run.largest_inertial_number, snapshot.report.largest_inertial_number);
    const bool probed =
        std::ranges::find(study.probe_pressures, snapshot.pressure) != study.probe_pressures.end();
    run.points.push_back(state_record(snapshot.state, specimen.material,
                                      isotropic_point(snapshot, first_cell), probed, run.notes,
                                      options.stop_requested));
    state = snapshot.state;
    ByteWriter to;
    dem::save_specimen(to, state);
    to.put(first_cell);
    save_run(to, run);
    store.write(to);
    piece.meter.add(work, what);
    if (piece.meter.stopped() && run.points.size() < study.pressures.size())
      run.failure = stopped_on_request;
    return run.failure.empty();
  };
  const auto done = static_cast<std::ptrdiff_t>(run.points.size());
  const std::vector<double> left(study.pressures.begin() + done, study.pressures.end());
  if (!triaxial::isotropic_path(state, specimen.material, left, options, visit) && run.failure.empty())
    run.failure = "the path ended early";
  if (run.failure.empty())
    end = std::move(state);
  return run;
}

PathRun shear_run(const Piece& piece, const dem::Specimen& start, stress::ShearPath path) {
  const ShearSection& shear = piece.scene.shear;
  const Store store(piece.checkpoints, stem(piece, path));
  const dem::Material material = recipe(piece.scene, piece.contact, piece.seed).material;
  const StopRequest stop_requested = piece.meter.stop_request();
  PathRun run;
  run.path = path;
  Schedule schedule{{{shear.eta_step}, {shear.strain_step}, {shear.probe_eta_step}, {0.5}}};
  std::optional<triaxial::ShearTest> test; // empty when the path is finished
  double reported = 0;                     // share of the work
  const auto share = [&] {
    return test ? std::min(1.0, std::abs(test->now().axial_strain) / shear.largest_strain) : 1;
  };
  const auto save = [&] {
    ByteWriter to;
    to.put(test.has_value());
    to.put(schedule);
    save_run(to, run);
    if (test)
      test->save(to);
    store.write(to);
  };
  // The paper shows cycles of one specimen: the first contact shape, dense, on TXC.
  const auto cycle = [&] {
    if (shear.loop_strain > 0 && path == stress::ShearPath::txc &&
        piece.density == triaxial::Density::dense && piece.contact == piece.scene.study.contacts.front())
      run.loops.push_back(shear_loop(test->engine().state(), material, test->now().stress.ratio(),
                                     shear.loop_strain, stop_requested));
  };
  // A state that does not come to rest is left out with a note, and the path continues. A run that is stopped
  // here resumes from the checkpoint before.
  const auto freeze = [&](bool probed) {
    const std::string failure = failure_of([&] {
      run.points.push_back(
          state_record(test->engine().state(), material, test->now(), probed, run.notes, stop_requested));
    });
    if (!failure.empty())
      run.notes.push_back("not frozen at eta = " + std::to_string(test->now().stress.ratio()) + ": " +
                          failure);
  };
  if (const std::optional<std::string> bytes = store.bytes()) {
    ByteReader from(*bytes, store.name());
    const bool under_way = from.get<bool>();
    const Schedule planned = std::exchange(schedule, from.get<Schedule>());
    if (!std::ranges::equal(planned, schedule, {}, &Multiples::step, &Multiples::step))
      from.fail("was written for other distances between its states");
    run = load_run(from, path);
    if (under_way)
      test = triaxial::ShearTest::load(from, material, stop_requested);
    reported = share();
    piece.meter.found(reported * piece.work, title(piece, path));
  } else {
    test = triaxial::ShearTest(start, material,
                               {.path = path,
                                .mean_stress = piece.scene.study.pressures.back(),
                                .inertial_number = shear.inertial_number,
                                .eta_step = shear.eta_step / curve_refinement,
                                .strain_step = shear.strain_step / curve_refinement,
                                .largest_strain = shear.largest_strain,
                                .stop_requested = stop_requested});
    run.curve.push_back(test->now());
    cycle();
  }
  while (test && run.failure.empty()) {
    const triaxial::ShearEvent event = test->advance();
    run.peak = test->peak();
    run.path_error = test->path_error();
    run.largest_inertial_number = test->largest_inertial_number();
    run.steps = test->now().step;
    if (event == triaxial::ShearEvent::unstable) {
      run.failure = "the motion became unstable";
      break;
    }
    if (event == triaxial::ShearEvent::stopped) {
      save();
      run.failure = stopped_on_request;
      break;
    }
    run.curve.push_back(test->now());
    if (event == triaxial::ShearEvent::finished) {
      test.reset();
    } else {
      const double eta = test->now().stress.ratio() * (stress::is_compression(path) ? 1 : -1);
      const bool by_eta = schedule[0].passes(eta);
      const bool by_strain = schedule[1].passes(std::abs(test->now().axial_strain));
      const bool probed = schedule[2].passes(eta), cycled = schedule[3].passes(eta);
      if (!by_eta && !by_strain && !probed && !cycled)
        continue;
      freeze(probed);
      if (cycled)
        cycle();
    }
    save();
    const double now = std::max(reported, share());
    piece.meter.add((now - reported) * piece.work, title(piece, path));
    reported = now;
  }
  return run;
}

} // namespace granum::studies
