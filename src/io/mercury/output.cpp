// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/mercury/output.hpp>

#include <algorithm>
#include <cmath>

#include <granum/core/text.hpp>
#include <granum/io/packing_files.hpp>

#include "io/later_run.hpp"
#include "io/packing_builder.hpp"
#include "io/text/row.hpp"

namespace granum::io {

namespace {

constexpr double same_time = 1e-5; // six digits are printed by default

struct DataFrame {
  double time = 0;
  long number = 0;
  Vec3 edges{};
  std::size_t line = 0;
  std::vector<GrainRow> grains;
  DigitWatch digits;
};

struct StatRow {
  long i = 0, j = 0;
  Vec3 point{}, normal{}, tangent{};
  double overlap = 0, normal_force = 0, tangential_force = 0;
  std::size_t line = 0;
};

struct StatFrame {
  double time = 0;
  std::vector<StatRow> rows;
  DigitWatch digits, force_digits;
};

/// Goes to the next line that is not blank, and splits it; false at the end.
bool next_row(TextSource& source, TextRow& row) {
  while (source.next()) {
    row.split();
    if (!row.empty())
      return true;
  }
  return false;
}

/// The last column, user-specified: the species of the grain unless a driver writes something else there.
std::optional<long> species(const TextRow& row) {
  constexpr double largest = 1e9;
  const double info = row.number(13, "info");
  if (!(std::abs(info) <= largest) || info != std::floor(info))
    return std::nullopt;
  return static_cast<long>(info);
}

std::optional<DataFrame> read_data(TextSource& source, long number) {
  TextRow row(source);
  if (!next_row(source, row))
    return std::nullopt;
  if (row.size() == 6)
    source.fail(
        "two-dimensional output (format 8) is not read; expected N time xmin ymin zmin xmax ymax zmax");
  row.require_size(8, "fields: N time xmin ymin zmin xmax ymax zmax");
  DataFrame frame;
  const std::size_t count = row.count(0, "grains");
  frame.time = row.number(1, "time");
  frame.edges = row.vector(5, "upper corner") - row.vector(2, "lower corner");
  frame.line = source.line_number();
  frame.number = number;
  while (frame.grains.size() < count) {
    if (!next_row(source, row))
      source.fail("expected " + std::to_string(count) + " grains, found " +
                  std::to_string(frame.grains.size()));
    row.require_size(14, "fields: x y z vx vy vz radius, three angles, three spins, info");
    for (std::size_t k = 0; k < 3; ++k)
      frame.digits.see(row[k]);
    frame.grains.push_back({static_cast<long>(frame.grains.size()), row.vector(0, "coordinate"),
                            row.number(6, "radius"), source.line_number(), species(row)});
  }
  return frame;
}

StatRow stat_row(const TextRow& row, std::size_t line) {
  return {.i = row.integer(1, "index of the first grain"),
          .j = row.integer(2, "index of the second grain"),
          .point = row.vector(3, "contact point"),
          .normal = row.vector(10, "normal"),
          .tangent = row.vector(13, "tangent"),
          .overlap = row.number(6, "overlap"),
          .normal_force = row.number(8, "normal force"),
          .tangential_force = row.number(9, "tangential force"),
          .line = line};
}

std::optional<StatFrame> read_stat(TextSource& source) {
  TextRow row(source);
  if (!next_row(source, row))
    return std::nullopt;
  StatFrame frame;
  for (int k = 0; k < 3; ++k) {
    if (k > 0 && !next_row(source, row))
      source.fail("the file ends within the three lines that begin a frame");
    if (row[0] != "#")
      source.fail("expected three lines that begin with #, found " + shown(source.line()));
    if (k == 0)
      frame.time = row.number(1, "time");
  }
  while (next_row(source, row)) {
    if (row[0].starts_with('#')) {
      source.hold();
      break;
    }
    row.require_size(16, "numbers: time i j x y z delta deltat fn ft nx ny nz tx ty tz");
    frame.digits.see(row[6]);
    frame.force_digits.see(row[8]);
    frame.rows.push_back(stat_row(row, source.line_number()));
  }
  return frame;
}

/// Puts the rows of one .fstat frame into a packing.
class StatJoin {
 public:
  explicit StatJoin(PackingBuilder& builder) : builder_(builder) {}

  void add(const StatRow& row) {
    if (row.normal == Vec3{} && row.normal_force == 0 && row.tangential_force == 0)
      return builder_.skip_empty();
    if (std::abs(norm(row.normal) - 1) > 1e-3)
      builder_.fail_contact(row.line, "expected a unit vector as normal, found one of length " +
                                          short_text(norm(row.normal)));
    if (row.j < 0)
      add_wall(row);
    else
      add_pair(row);
  }

 private:
  void add_pair(const StatRow& row) {
    PairRow pair{.a = builder_.index(row.i, row.line),
                 .b = builder_.index(row.j, row.line),
                 .branch = {},
                 .overlap = row.overlap,
                 .normal_force = row.normal_force,
                 .tangential_force = -row.tangential_force * row.tangent,
                 .line = row.line};
    const double distance = builder_.radius_sum(pair.a, pair.b) - row.overlap;
    pair.branch = (-distance / norm(row.normal)) * row.normal;
    if (pair.a != pair.b)
      builder_.require_agreement(pair);
    builder_.add(pair);
  }

  void add_wall(const StatRow& row) {
    const std::uint32_t grain = builder_.index(row.i, row.line);
    const double side = dot(row.normal, row.point - builder_.position(grain)) < 0 ? -1 : 1;
    const double distance = builder_.radius(grain) - row.overlap;
    builder_.add_wall({.a = grain,
                       .branch = (side * distance / norm(row.normal)) * row.normal,
                       .overlap = row.overlap,
                       .normal_force = row.normal_force,
                       .tangential_force = side * row.tangential_force * row.tangent,
                       .line = row.line},
                      -(row.j + 1));
  }

  PackingBuilder& builder_;
};

ImportedPacking packing(const TextSource& data, DataFrame grains, const TextSource* fstat,
                        const StatFrame* stat, const PackingFileOptions& options) {
  PackingBuilder builder(data.name(), fstat ? fstat->name() : "", options);
  builder.set_cell(Mat3::diagonal(grains.edges.x, grains.edges.y, grains.edges.z), {true, true, true},
                   grains.line);
  std::vector<std::string> unused{"velocities", "angles", "spins"};
  if (std::ranges::any_of(grains.grains, [](const GrainRow& grain) { return !grain.type; }))
    unused.emplace_back("info");
  builder.set_grains(std::move(grains.grains));
  builder.note_unused(unused, "columns of the grains");
  builder.note_digits(grains.digits, "coordinates");
  builder.note(Finding::boundary_unknown,
               "MercuryDPM's files do not state which faces are periodic: all are assumed");
  builder.note(Finding::units_unknown, "no units in the files: taken as SI");
  builder.note(Finding::law_unknown, "contact law and grain material are not in the files");
  if (!stat) {
    builder.note(Finding::contacts_unknown, "no .fstat was given");
    return builder.finish(grains.number, grains.time);
  }
  builder.expect_both_sides();
  builder.note_unused({"deltat"}, "columns of the contacts");
  builder.note_overlap_digits(stat->digits, "overlaps");
  builder.note_force_digits(stat->force_digits);
  builder.note(Finding::stiffness_unknown, "stiffnesses are not in the files");
  builder.note(Finding::history_unknown, "the loading history of the contacts is not in the files");
  builder.note(Finding::viscous_forces, "forces include viscous damping where grains move");
  StatJoin join(builder);
  for (const StatRow& row : stat->rows)
    join.add(row);
  return builder.finish(grains.number, grains.time);
}

/// Whether a line consists of numbers, at least `fewest` of them.
bool all_numbers(std::string_view line, std::size_t fewest) {
  std::size_t count = 0;
  for (line = trimmed(line); !line.empty(); line = trimmed(line)) {
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    if (!parse_number(line.substr(0, end)))
      return false;
    ++count;
    line.remove_prefix(end);
  }
  return count >= fewest;
}

bool equal_times(double a, double b) {
  return std::abs(a - b) <= same_time * std::max(std::abs(a), std::abs(b));
}

} // namespace

struct MercuryOutput::Impl {
  /// A .data file. skip() returns the time of the frame.
  struct DataFile {
    TextSource text;
    explicit DataFile(TextSource file) : text(std::move(file)) {}
    [[nodiscard]] const TextSource& source() const { return text; }
    std::optional<double> skip() {
      TextRow row(text);
      if (!next_row(text, row))
        return std::nullopt;
      const std::size_t count = row.count(0, "grains");
      const double time = row.number(1, "time");
      for (std::size_t k = 0; k < count; ++k)
        if (!next_row(text, row))
          return ends_early(time);
      return time;
    }
  };

  /// A .fstat file, in which a frame ends where the next begins.
  struct StatFile {
    TextSource text;
    explicit StatFile(TextSource file) : text(std::move(file)) {}
    [[nodiscard]] const TextSource& source() const { return text; }
    std::optional<double> skip() {
      TextRow row(text);
      if (!next_row(text, row))
        return std::nullopt;
      const double time = row.number(1, "time");
      for (int k = 1; next_row(text, row); ++k)
        if (k > 2 && row[0].starts_with('#')) {
          text.hold();
          break;
        }
      return time;
    }
  };

  LaterRun<DataFile> data;
  std::optional<LaterRun<StatFile>> fstat;
  PackingFileOptions options;
  std::size_t skipped = 0, matched = 0;

  std::optional<DataFrame> next_data() {
    TextSource& source = data.next().text;
    return read_data(source, data.number());
  }
};

MercuryOutput::MercuryOutput(TextSource data, std::optional<TextSource> fstat, PackingFileOptions options)
    : impl_(new Impl{LaterRun<Impl::DataFile>(std::move(data)), std::nullopt, std::move(options)}) {
  if (fstat)
    impl_->fstat.emplace(std::move(*fstat));
}
MercuryOutput::MercuryOutput(MercuryOutput&&) noexcept = default;
MercuryOutput& MercuryOutput::operator=(MercuryOutput&&) noexcept = default;
MercuryOutput::~MercuryOutput() = default;

std::optional<ImportedPacking> MercuryOutput::next() {
  auto grains = impl_->next_data();
  if (!impl_->fstat) {
    if (!grains && impl_->matched == 0)
      impl_->data.file().text.fail("contains no frame; expected N time xmin ymin zmin xmax ymax zmax");
    ++impl_->matched;
    if (!grains)
      return std::nullopt;
    return packing(impl_->data.file().text, std::move(*grains), nullptr, nullptr, impl_->options);
  }
  auto stat = read_stat(impl_->fstat->next().text);
  while (grains && stat && !equal_times(grains->time, stat->time)) {
    ++impl_->skipped;
    if (grains->time < stat->time)
      grains = impl_->next_data();
    else
      stat = read_stat(impl_->fstat->next().text);
  }
  if (grains && stat) {
    ++impl_->matched;
    return packing(impl_->data.file().text, std::move(*grains), &impl_->fstat->file().text, &*stat,
                   impl_->options);
  }
  if (impl_->matched == 0)
    impl_->fstat->file().text.fail("contains no time of " + impl_->data.file().text.name());
  if (grains || stat)
    ++impl_->skipped;
  return std::nullopt;
}

std::size_t MercuryOutput::skipped() const { return impl_->skipped; }
const std::vector<double>& MercuryOutput::moments() const { return impl_->data.moments(); }

const PackingFormat mercury_format{
    .name = "MercuryDPM's .data and .fstat",
    .sign = "a first line of numbers only, after a # in .fstat",
    .grains = "a MercuryDPM .data file",
    .contacts = "a MercuryDPM .fstat file",
    .recognise = [](TextSource& source) -> std::optional<Holds> {
      constexpr std::size_t numbers_of_data = 6; // N, time and a box in two dimensions
      if (!source.next())
        return std::nullopt;
      if (source.line().starts_with('#') && all_numbers(source.line().substr(1), 2))
        return Holds::contacts;
      return all_numbers(source.line(), numbers_of_data) ? std::optional(Holds::grains) : std::nullopt;
    },
    .read =
        [](TextSource grains, std::optional<TextSource> contacts, const PackingFileOptions& options) {
          return frames_of(MercuryOutput(std::move(grains), std::move(contacts), options));
        }};

} // namespace granum::io
