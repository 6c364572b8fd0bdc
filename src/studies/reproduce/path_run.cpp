// SPDX-License-Identifier: GPL-3.0-or-later
#include "path_run.hpp"

#include <algorithm>
#include <cmath>
#include <system_error>
#include <utility>

#include <granum/core/error.hpp>
#include <granum/dem/specimen.hpp>
#include <granum/io/checkpoint/checkpoint.hpp>
#include <granum/triaxial/specimen.hpp>

#include "state_record.hpp"
#include "studies/running/outcome_text.hpp"

namespace granum::studies {

namespace {

/// Points of the curve between two frozen ones.
constexpr double curve_refinement = 5;

std::string lower_case(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return out;
}

/// The checkpoint of one piece: its bytes, if there are any yet, and their writing. The file says of which
/// piece it is, so that one that was renamed, or stored in another's place, is refused.
class Store {
 public:
  /// \param    stem   name of the piece: of the file without its ending, and its subject
  Store(const CheckpointFolder& checkpoints, const std::string& stem)
      : subject_(stem), scene_text_(checkpoints.scene_text) {
    if (!checkpoints.folder.empty())
      path_ = checkpoints.folder / (stem + ".checkpoint");
  }

  [[nodiscard]] std::optional<std::string> bytes() const {
    std::error_code error;
    if (path_.empty() || !std::filesystem::exists(path_, error)) {
      if (error)
        throw FileError(path_.string(), 0, "cannot be read: " + error.message());
      return std::nullopt;
    }
    io::Checkpoint checkpoint = io::read_checkpoint(path_);
    if (checkpoint.scene != scene_text_)
      throw FileError(path_.string(), 0, "is the checkpoint of another scene");
    if (checkpoint.subject != subject_)
      throw FileError(path_.string(), 0,
                      "is the checkpoint of " + checkpoint.subject + ", not of " + subject_);
    return std::move(checkpoint.state);
  }
  [[nodiscard]] std::string name() const { return path_.string(); }
  void write(const ByteWriter& bytes) const {
    if (!path_.empty())
      io::write_checkpoint(path_, {.subject = subject_, .scene = scene_text_, .state = bytes.bytes()});
  }

 private:
  std::filesystem::path path_;
  std::string subject_;
  std::string scene_text_;
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

/// When a specimen on a shear path is frozen.
struct Schedule {
  Multiples eta, strain, probe_eta;
  Multiples loop_eta{.step = 0.5};

  [[nodiscard]] bool same_steps(const Schedule& other) const {
    return eta.step == other.eta.step && strain.step == other.strain.step &&
           probe_eta.step == other.probe_eta.step && loop_eta.step == other.loop_eta.step;
  }

  struct Due {
    bool frozen = false;
    bool probed = false;
    bool cycled = false;
  };
  Due at(const triaxial::PathPoint& now, stress::ShearPath path) {
    const double ratio = now.stress.ratio() * (stress::is_compression(path) ? 1 : -1);
    const bool by_eta = eta.passes(ratio);
    const bool by_strain = strain.passes(std::abs(now.axial_strain));
    const bool probed = probe_eta.passes(ratio);
    const bool cycled = loop_eta.passes(ratio);
    return {by_eta || by_strain || probed || cycled, probed, cycled};
  }
};

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

bool holds(const std::vector<double>& values, double value) {
  return std::find(values.begin(), values.end(), value) != values.end();
}

} // namespace

std::string path_in_file_names(const std::optional<stress::ShearPath>& path) {
  return lower_case(name(path));
}

dem::Specimen packing(const Piece& piece) {
  const std::string name_of_packing =
      std::string(name(piece.contact)) + "-" + std::to_string(piece.seed) + "-packing";
  const Store store(piece.checkpoints, name_of_packing);
  if (const std::optional<std::string> bytes = store.bytes()) {
    ByteReader from(*bytes, store.name());
    piece.meter.found(packing_steps(piece.scene), name_of_packing);
    return dem::load_specimen(from);
  }
  dem::Specimen state = triaxial::frictionless_specimen(recipe(piece.scene, piece.contact, piece.seed),
                                                        piece.meter.stop_request())
                            .state;
  ByteWriter to;
  dem::save_specimen(to, state);
  store.write(to);
  piece.meter.add(packing_steps(piece.scene), name_of_packing);
  return state;
}

IsoRun isotropic_run(const Piece& piece, const dem::Specimen& packing) {
  const Scene& scene = piece.scene;
  const Store store(piece.checkpoints, stem(piece, std::nullopt));
  const triaxial::SpecimenRecipe specimen = recipe(scene, piece.contact, piece.seed);
  const double work = isotropic_steps(scene, piece.contact, piece.density) /
                      static_cast<double>(scene.study.pressures.size());
  IsoRun iso;
  Mat3 first_cell;
  if (const std::optional<std::string> bytes = store.bytes()) {
    ByteReader from(*bytes, store.name());
    iso.state = dem::load_specimen(from);
    first_cell = from.get<Mat3>();
    iso.run = load_run(from, std::nullopt);
    if (iso.run.points.size() > scene.study.pressures.size())
      from.fail("contains more states than the scene has pressures");
    piece.meter.found(work * static_cast<double>(iso.run.points.size()), title(piece, std::nullopt));
  } else {
    iso.state = triaxial::start_of_compression(packing, piece.density, specimen, piece.meter.stop_request());
  }
  dem::QuasistaticOptions options = triaxial::compression_options();
  options.stop_requested = piece.meter.stop_request();
  const auto visit = [&](const triaxial::Snapshot& snapshot) {
    iso.run.steps += snapshot.report.steps;
    if (!snapshot.report.converged()) {
      iso.run.failure = failure_of(snapshot);
      return false;
    }
    if (iso.run.points.empty())
      first_cell = snapshot.state.cell;
    iso.run.largest_inertial_number =
        std::max(iso.run.largest_inertial_number, snapshot.report.largest_inertial_number);
    iso.run.points.push_back(state_record(
        snapshot.state, specimen.material, isotropic_point(snapshot, first_cell),
        holds(scene.study.probe_pressures, snapshot.pressure), iso.run.notes, options.stop_requested));
    iso.state = snapshot.state;
    ByteWriter to;
    dem::save_specimen(to, iso.state);
    to.put(first_cell);
    save_run(to, iso.run);
    store.write(to);
    piece.meter.add(work, title(piece, std::nullopt));
    if (piece.meter.stopped() && iso.run.points.size() < scene.study.pressures.size())
      iso.run.failure = stopped_on_request;
    return iso.run.failure.empty();
  };
  const auto done = static_cast<std::ptrdiff_t>(iso.run.points.size());
  const std::vector<double> left(scene.study.pressures.begin() + done, scene.study.pressures.end());
  if (!triaxial::isotropic_path(iso.state, specimen.material, left, options, visit) &&
      iso.run.failure.empty())
    iso.run.failure = "the path ended early";
  return iso;
}

namespace {

/// A shear test with its record.
class ShearRecord {
 public:
  ShearRecord(const Piece& piece, const dem::Specimen& start, stress::ShearPath path)
      : piece_(piece), path_(path), store_(piece.checkpoints, stem(piece, path)),
        material_(recipe(piece.scene, piece.contact, piece.seed).material),
        work_(shear_steps(piece.scene, piece.contact, path)) {
    const Scene& scene = piece.scene;
    run_.path = path;
    schedule_ = {.eta = {scene.shear.eta_step},
                 .strain = {scene.shear.strain_step},
                 .probe_eta = {scene.shear.probe_eta_step}};
    if (const std::optional<std::string> bytes = store_.bytes()) {
      take_up(*bytes);
      return;
    }
    test_ = triaxial::ShearTest(start, material_,
                                {.path = path,
                                 .mean_stress = scene.study.pressures.back(),
                                 .inertial_number = scene.shear.inertial_number,
                                 .eta_step = scene.shear.eta_step / curve_refinement,
                                 .strain_step = scene.shear.strain_step / curve_refinement,
                                 .largest_strain = scene.shear.largest_strain,
                                 .stop_requested = piece.meter.stop_request()});
    run_.curve.push_back(test_->now());
    cycle();
  }

  PathRun run() && {
    while (test_ && run_.failure.empty())
      advance();
    return std::move(run_);
  }

 private:
  void advance() {
    const triaxial::ShearEvent event = test_->advance();
    record();
    switch (event) {
    case triaxial::ShearEvent::snapshot:
      run_.curve.push_back(test_->now());
      if (const Schedule::Due due = schedule_.at(test_->now(), path_); due.frozen) {
        freeze(due.probed);
        if (due.cycled)
          cycle();
        save();
        report_progress();
      }
      return;
    case triaxial::ShearEvent::finished:
      run_.curve.push_back(test_->now());
      test_.reset();
      save();
      report_progress();
      return;
    case triaxial::ShearEvent::stopped:
      save();
      run_.failure = stopped_on_request;
      return;
    case triaxial::ShearEvent::unstable:
      break;
    }
    run_.failure = "the motion became unstable";
  }

  void record() {
    run_.peak = test_->peak();
    run_.path_error = test_->path_error();
    run_.largest_inertial_number = test_->largest_inertial_number();
    run_.steps = test_->now().step;
  }

  /// A state that does not come to rest is left out with a note, and the path continues. A run that is
  /// stopped here resumes from the checkpoint before.
  void freeze(bool probed) {
    const std::string failure = failure_of([&] {
      run_.points.push_back(state_record(test_->engine().state(), material_, test_->now(), probed, run_.notes,
                                         piece_.meter.stop_request()));
    });
    if (!failure.empty())
      run_.notes.push_back("not frozen at eta = " + std::to_string(test_->now().stress.ratio()) + ": " +
                           failure);
  }

  /// The paper shows cycles of one specimen: the first contact shape, dense, on TXC.
  void cycle() {
    const Scene& scene = piece_.scene;
    if (scene.shear.loop_strain > 0 && path_ == stress::ShearPath::txc &&
        piece_.density == triaxial::Density::dense && piece_.contact == scene.study.contacts.front())
      run_.loops.push_back(shear_loop(test_->engine().state(), material_, test_->now().stress.ratio(),
                                      scene.shear.loop_strain, piece_.meter.stop_request()));
  }

  void save() const {
    ByteWriter to;
    to.put(test_.has_value());
    to.put(schedule_);
    save_run(to, run_);
    if (test_)
      test_->save(to);
    store_.write(to);
  }

  void take_up(const std::string& bytes) {
    ByteReader from(bytes, store_.name());
    const bool under_way = from.get<bool>();
    const Schedule planned = std::exchange(schedule_, from.get<Schedule>());
    if (!planned.same_steps(schedule_))
      from.fail("was written for other distances between its states");
    run_ = load_run(from, path_);
    if (under_way)
      test_ = triaxial::ShearTest::load(from, material_, piece_.meter.stop_request());
    reported_ = share();
    piece_.meter.found(reported_ * work_, title(piece_, path_));
  }

  [[nodiscard]] double share() const {
    return test_ ? std::min(1.0, std::abs(test_->now().axial_strain) / piece_.scene.shear.largest_strain) : 1;
  }

  void report_progress() {
    const double now = std::max(reported_, share());
    piece_.meter.add((now - reported_) * work_, title(piece_, path_));
    reported_ = now;
  }

  const Piece& piece_;
  stress::ShearPath path_;
  Store store_;
  dem::Material material_;
  double work_;
  double reported_ = 0;
  PathRun run_;
  Schedule schedule_;
  std::optional<triaxial::ShearTest> test_; ///< empty when the path is finished
};

} // namespace

PathRun shear_run(const Piece& piece, const dem::Specimen& start, stress::ShearPath path) {
  return ShearRecord(piece, start, path).run();
}

} // namespace granum::studies
