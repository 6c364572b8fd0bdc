// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/lammps/files.hpp>

#include <algorithm>
#include <cmath>

#include <granum/core/error.hpp>
#include <granum/io/packing_files.hpp>

#include "contact_rows.hpp"
#include "dump_file.hpp"
#include "io/packing_builder.hpp"

namespace granum::io {

namespace {

/// A grain at a wall, as `fix wall/gran ... contacts` of LAMMPS states it.
struct WallRow {
  long id = 0;
  std::size_t wall = 0; ///< number of the fix among those of the dump
  double mark = 0;      ///< 1, or the id of the grain in older versions
  Vec3 force{};         ///< of the wall on the grain
  Vec3 point{};         ///< on the wall
  double radius = 0;
  std::size_t line = 0;
};

/// Whether a row belongs to the contact of a wall with its grain, within 0.01 for radii and points of six
/// digits.
bool is_of_wall(const WallRow& row, const PackingBuilder& builder, double unit) {
  constexpr double few_digits = 1e-2;
  const auto grain = builder.find(row.id);
  if (!grain || (row.mark != 1 && row.mark != static_cast<double>(row.id)))
    return false;
  const double radius = builder.radius(*grain);
  const double distance = norm(builder.nearest(unit * row.point - builder.position(*grain)));
  return std::abs(unit * row.radius - radius) <= few_digits * radius && distance > 0 &&
         distance <= (1 + few_digits) * radius;
}

PairRow contact_of(const WallRow& row, const PackingBuilder& builder, const DumpUnits& units) {
  PairRow contact{.a = builder.index(row.id, row.line), .line = row.line};
  contact.branch = builder.nearest(units.length * row.point - builder.position(contact.a));
  const double distance = norm(contact.branch);
  const Vec3 n = (1 / distance) * contact.branch, on_wall = -units.force * row.force;
  contact.overlap = builder.radius(contact.a) - distance;
  contact.normal_force = dot(on_wall, n);
  contact.tangential_force = on_wall + -contact.normal_force * n;
  return contact;
}

/// Groups of columns f_name[1] ... f_name[8] or more, which fixes of walls write.
std::vector<ColumnGroup> wall_columns(const std::vector<std::string>& columns) {
  constexpr std::size_t width = 8;
  std::vector<ColumnGroup> groups = column_groups(columns, "f_");
  std::erase_if(groups, [](const ColumnGroup& group) { return group.size() < width; });
  return groups;
}

/// Appends the contact with each wall that the grain of a row touches, from the columns of walls.
/// \throws   FileError for text where a number should be
void read_walls(const TextRow& row, long id, std::size_t line, const std::vector<ColumnGroup>& walls,
                std::vector<WallRow>& out) {
  for (std::size_t wall = 0; wall < walls.size(); ++wall) {
    const auto value = [&](std::size_t k) { return row.number(walls[wall][k], "value of a fix"); };
    const double mark = value(0);
    if (mark != 0)
      out.push_back({.id = id,
                     .wall = wall,
                     .mark = mark,
                     .force = {value(1), value(2), value(3)},
                     .point = {value(4), value(5), value(6)},
                     .radius = value(7),
                     .line = line});
  }
}

/// Adds the contacts of those fixes whose rows agree with the grains: the radius is the grain's, the point
/// lies within it and the mark is 1 or its id. Columns of other fixes are passed over.
/// \throws   FileError as PackingBuilder::add_wall
void join_walls(PackingBuilder& builder, const std::vector<WallRow>& rows, const DumpUnits& units) {
  std::vector<bool> other; // fixes that are no walls
  for (const WallRow& row : rows) {
    other.resize(std::max(other.size(), row.wall + 1));
    other[row.wall] = other[row.wall] || !is_of_wall(row, builder, units.length);
  }
  for (const WallRow& row : rows)
    if (!other[row.wall])
      builder.add_wall(contact_of(row, builder, units), static_cast<long>(row.wall));
}

/// Indices of the quantities of a grain in its row.
struct GrainLayout {
  std::size_t id = 0, radius = 0;
  double radius_factor = 1; ///< 1/2 for a diameter
  ColumnTriple position{};
  std::optional<std::size_t> type, body;
  std::optional<ColumnTriple> force; ///< sum of all forces
  std::vector<std::string> unused;
  bool scaled = false; ///< positions are fractions of the box
};

GrainLayout find_grain_layout(const std::vector<std::string>& columns, const PackingFileOptions& options,
                              const TextSource& source) {
  const ColumnMap& map = options.columns;
  const auto find = [&](const std::string& quantity) {
    const auto entry = map.find(quantity);
    const auto column = find_column(columns, entry == map.end() ? quantity : entry->second);
    if (!column && entry != map.end())
      source.fail("expected a column " + shown(entry->second) + " for " + quantity);
    return column;
  };
  GrainLayout layout;
  const auto id = find("id");
  if (!id)
    source.fail("expected a column 'id'");
  layout.id = *id;
  layout.type = find_column(columns, "type");
  if (!options.none("body"))
    layout.body = map.contains("body") ? find("body") : find_column(columns, "mol");
  const auto fx = find_column(columns, "fx"), fy = find_column(columns, "fy"),
             fz = find_column(columns, "fz");
  if (fx && fy && fz)
    layout.force = {*fx, *fy, *fz};
  const auto radius = find("radius"), diameter = find("diameter");
  if (!radius && !diameter)
    source.fail("expected a column 'radius' or 'diameter'");
  layout.radius = radius ? *radius : *diameter;
  layout.radius_factor = radius ? 1 : 0.5;
  struct Kind {
    const char *x, *y, *z;
    bool scaled;
  };
  for (const Kind& kind : {Kind{"x", "y", "z", false}, Kind{"xu", "yu", "zu", false},
                           Kind{"xs", "ys", "zs", true}, Kind{"xsu", "ysu", "zsu", true}}) {
    const auto x = find(kind.x), y = find(kind.y), z = find(kind.z);
    if (x && y && z) {
      layout.position = {*x, *y, *z};
      layout.scaled = kind.scaled;
      return layout;
    }
  }
  source.fail("expected columns x y z, xu yu zu, xs ys zs or xsu ysu zsu");
}

/// The columns that a row of grains uses, and the names of the others.
GrainLayout grain_layout(const std::vector<std::string>& columns, const PackingFileOptions& options,
                         const TextSource& source) {
  GrainLayout layout = find_grain_layout(columns, options, source);
  std::vector<std::size_t> used{layout.id, layout.radius};
  used.insert(used.end(), layout.position.begin(), layout.position.end());
  for (const auto& one : {layout.type, layout.body})
    if (one)
      used.push_back(*one);
  if (layout.force)
    used.insert(used.end(), layout.force->begin(), layout.force->end());
  for (const ColumnGroup& wall : wall_columns(columns))
    used.insert(used.end(), wall.begin(), wall.end());
  for (std::size_t k = 0; k < columns.size(); ++k)
    if (std::ranges::find(used, k) == used.end())
      layout.unused.push_back(columns[k]);
  return layout;
}

struct AtomFrame {
  DumpFrame frame;
  std::vector<std::string> unused; ///< columns
  std::vector<GrainRow> grains;
  std::vector<WallRow> walls;
  bool scaled = false;
  DigitWatch digits;
};

Vec3 vector(const TextRow& row, const ColumnTriple& at, const char* what) {
  return {row.number(at[0], what), row.number(at[1], what), row.number(at[2], what)};
}

std::optional<AtomFrame> read_atoms(DumpFile& file, const PackingFileOptions& options) {
  AtomFrame atoms;
  GrainLayout layout;
  TableSink sink;
  std::vector<ColumnGroup> walls;
  sink.heading = [&](const std::vector<std::string>& columns, std::size_t rows) {
    layout = grain_layout(columns, options, file.source());
    walls = wall_columns(columns);
    atoms.grains.reserve(rows);
  };
  sink.row = [&](const TextRow& row, std::size_t line) {
    for (const std::size_t k : layout.position)
      atoms.digits.see(row[k]);
    atoms.grains.push_back({row.integer(layout.id, "id"), vector(row, layout.position, "coordinate"),
                            layout.radius_factor * row.number(layout.radius, "radius"), line});
    if (layout.type)
      atoms.grains.back().type = row.integer(*layout.type, "type");
    if (layout.body)
      atoms.grains.back().body = row.integer(*layout.body, "number of the body");
    if (layout.force)
      atoms.grains.back().force = vector(row, *layout.force, "force");
    if (!walls.empty())
      read_walls(row, atoms.grains.back().id, line, walls, atoms.walls);
  };
  auto frame = file.next(sink);
  if (!frame)
    return std::nullopt;
  atoms.frame = *frame;
  atoms.scaled = layout.scaled;
  atoms.unused = std::move(layout.unused);
  const double unit = file.units().length;
  for (GrainRow& grain : atoms.grains) {
    if (layout.scaled)
      grain.position = frame->box->origin + frame->box->edges * grain.position;
    grain.position *= unit;
    grain.radius *= unit;
    if (grain.force)
      *grain.force *= file.units().force;
  }
  return atoms;
}

void note_unknown(PackingBuilder& builder, const DumpFile& atoms, const DumpBox& box,
                  const LocalFrame* locals) {
  if (!box.boundary_known)
    builder.note(Finding::boundary_unknown, "the box has no boundary flags: taken as periodic");
  if (!atoms.units().stated)
    builder.note(Finding::units_unknown, "no ITEM: UNITS: taken as SI");
  note_unknown_contacts(builder, locals, "in a dump");
}

/// \throws   FileError if the boxes of grains and contacts differ by more than 1e-4 of the longest edge
void require_same_box(const DumpBox& box, double unit, const DumpFile& contacts, const LocalFrame& locals) {
  constexpr double rounding = 1e-4;
  const double other = contacts.units().stated ? contacts.units().length : unit;
  double longest = 0, apart = 0;
  for (int k = 0; k < 3; ++k) {
    const Vec3 edge = unit * column(box.edges, k);
    longest = std::max(longest, norm(edge));
    apart = std::max(apart, norm(edge - other * column(locals.frame.box->edges, k)));
  }
  if (apart > rounding * longest)
    throw FileError(contacts.source().name(), locals.frame.box->line,
                    "the box is not that of the grains: are both files of the same state?");
}

/// The packing of one frame; units stated in one of the two files apply to both.
ImportedPacking packing(const DumpFile& atom_file, AtomFrame atoms, const DumpFile* local_file,
                        LocalFrame* locals, const PackingFileOptions& options) {
  PackingBuilder builder(atom_file.source().name(), local_file ? local_file->source().name() : "", options);
  const DumpBox& box = *atoms.frame.box;
  const DumpUnits& units = atom_file.units();
  if (options.si && units.stated && (units.length != 1 || units.force != 1))
    throw InvalidArgument("units: si is given, but " + atom_file.source().name() + " states others");
  builder.set_cell(units.length * box.edges, box.periodic, box.line);
  builder.set_grains(std::move(atoms.grains));
  const double widest =
      std::max({norm(column(box.edges, 0)), norm(column(box.edges, 1)), norm(column(box.edges, 2))});
  builder.note_digits(atoms.digits, "coordinates", units.length * (atoms.scaled ? widest : 1));
  join_walls(builder, atoms.walls, units);
  if (locals) {
    const DumpUnits& other = local_file->units();
    if (other.stated && units.stated && (other.length != units.length || other.force != units.force))
      builder.note(Finding::units_differ,
                   "ITEM: UNITS of the two files differ: each file was read in its own units");
    require_same_box(box, units.length, *local_file, *locals);
    join(builder, *locals, local_file->units().stated ? local_file->units() : units);
  }
  note_unknown(builder, atom_file, box, locals);
  builder.note_unused(atoms.unused, "columns of the grains");
  std::optional<double> time = atoms.frame.time;
  if (time)
    *time *= units.time;
  return builder.finish(*atoms.frame.step, time);
}

/// Steps never go back, but in a file of a restarted job, where LaterRun leaves out what was written twice.
void require_forward(const DumpFile& file, std::optional<long>& last, const DumpFrame& frame) {
  if (last && *frame.step < *last)
    file.source().fail("time step " + std::to_string(*frame.step) + " follows " + std::to_string(*last) +
                       ": expected steps that do not decrease (a pipe cannot be read twice: give the file)");
  last = frame.step;
}

} // namespace

struct LammpsDump::Impl {
  LaterRun<DumpFile> atoms;
  std::optional<LaterRun<DumpFile>> contacts;
  PackingFileOptions options;
  std::optional<long> atom_step, contact_step;
  std::size_t skipped = 0, matched = 0;

  std::optional<AtomFrame> next_atoms() {
    auto frame = read_atoms(atoms.next(), options);
    if (frame)
      require_forward(atoms.file(), atom_step, frame->frame);
    return frame;
  }
  std::optional<LocalFrame> next_locals() {
    auto frame = read_locals(contacts->next(), options.columns);
    if (frame)
      require_forward(contacts->file(), contact_step, frame->frame);
    return frame;
  }

  /// The next two frames of one time step.
  std::optional<ImportedPacking> next_joined() {
    auto grains = next_atoms();
    auto pairs = next_locals();
    while (grains && pairs && grains->frame.step != pairs->frame.step) {
      ++skipped;
      if (*grains->frame.step < *pairs->frame.step)
        grains = next_atoms();
      else
        pairs = next_locals();
    }
    if (grains && pairs) {
      ++matched;
      return packing(atoms.file(), std::move(*grains), &contacts->file(), &*pairs, options);
    }
    if (grains || pairs)
      ++skipped;
    if (matched == 0)
      contacts->file().source().fail("contains no time step of " + atoms.file().source().name());
    return std::nullopt;
  }
};

LammpsDump::LammpsDump(TextSource atoms, std::optional<TextSource> contacts, PackingFileOptions options)
    : impl_(new Impl{LaterRun<DumpFile>(std::move(atoms)), std::nullopt, std::move(options), {}, {}, 0, 0}) {
  if (contacts)
    impl_->contacts.emplace(std::move(*contacts));
}

LammpsDump::LammpsDump(LammpsDump&&) noexcept = default;
LammpsDump& LammpsDump::operator=(LammpsDump&&) noexcept = default;
LammpsDump::~LammpsDump() = default;

std::optional<ImportedPacking> LammpsDump::next() {
  if (impl_->contacts)
    return impl_->next_joined();
  auto grains = impl_->next_atoms();
  if (!grains) {
    if (impl_->matched == 0)
      impl_->atoms.file().source().fail("contains no frame; expected ITEM: TIMESTEP");
    return std::nullopt;
  }
  ++impl_->matched;
  return packing(impl_->atoms.file(), std::move(*grains), nullptr, nullptr, impl_->options);
}

std::size_t LammpsDump::skipped() const { return impl_->skipped; }
const std::vector<double>& LammpsDump::moments() const { return impl_->atoms.moments(); }

const PackingFormat lammps_dump_format{
    .name = "LAMMPS or LIGGGHTS dumps",
    .sign = "ITEM: lines of dump custom (grains) and dump local (contacts)",
    .grains = "a LAMMPS dump of grains",
    .contacts = "a LAMMPS dump of contacts",
    .recognise = [](TextSource& source) -> std::optional<Holds> {
      if (!source.next() || !source.line().starts_with("ITEM:"))
        return std::nullopt;
      source.hold();
      for (int k = 0; k < lines_looked_at && source.next(); ++k) {
        if (source.line().starts_with("ITEM: NUMBER OF ATOMS"))
          return Holds::grains;
        if (source.line().starts_with("ITEM: NUMBER OF "))
          return Holds::contacts;
      }
      source.fail("a dump without ITEM: NUMBER OF ATOMS or ENTRIES");
    },
    .read =
        [](TextSource grains, std::optional<TextSource> contacts, const PackingFileOptions& options) {
          return frames_of(LammpsDump(std::move(grains), std::move(contacts), options));
        }};

} // namespace granum::io
