// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing_builder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include <granum/core/error.hpp>
#include <granum/core/stop.hpp>
#include <granum/core/text.hpp>
#include <granum/io/imported_packing.hpp>

#include "io/text/row.hpp"

namespace granum::io {

namespace {

/// Two rows of one pair state the same if they differ by no more than the rounding to six digits.
constexpr double same_value = 1e-5;
/// A branch that a file states and the one between its grains may differ by six-digit coordinates in a large
/// box.
constexpr double same_branch = 1e-2;
/// Grains whose centres are further apart than this many sums of their radii do not touch in any code.
constexpr double farthest = 2;

bool same(const Vec3& a, const Vec3& b) { return norm(a - b) <= same_value * std::max(norm(a), norm(b)); }

packing::Contact turned(packing::Contact c) {
  std::swap(c.i, c.j);
  c.branch = -c.branch;
  c.tangential_force = -c.tangential_force;
  return c;
}

packing::Contact contact_of(const PairRow& row) {
  return {.i = row.a,
          .j = row.b,
          .branch = row.branch,
          .overlap = row.overlap,
          .normal_force = row.normal_force,
          .tangential_force = row.tangential_force,
          .normal_stiffness = row.normal_stiffness,
          .tangential_stiffness = row.tangential_stiffness,
          .sliding = row.sliding,
          .rolling_stiffness = row.rolling_stiffness,
          .twisting_stiffness = row.twisting_stiffness};
}

} // namespace

void PackingBuilder::require_given_box(const Mat3& cell, const std::array<bool, 3>& periodic,
                                       std::size_t line) const {
  constexpr double rounding = 1e-4; // of the longest edge
  double longest = 0, apart = 0;
  for (int k = 0; k < 3; ++k) {
    longest = std::max(longest, norm(column(cell, k)));
    apart = std::max(apart, norm(column(cell, k) - column(options_.box->cell, k)));
  }
  const auto edges = [](const Mat3& m) {
    return short_text(norm(column(m, 0)), 8) + ", " + short_text(norm(column(m, 1)), 8) + ", " +
           short_text(norm(column(m, 2)), 8) + " m";
  };
  const std::string place = grain_file_ + (line > 0 ? ":" + std::to_string(line) : "");
  if (!(apart <= rounding * longest))
    throw InvalidArgument("box: the edges " + edges(options_.box->cell) + " are not those of the box of " +
                          place + ", " + edges(cell));
  if (periodic != options_.box->periodic)
    throw InvalidArgument("box: a periodic box is given, but " + place + " has faces that are not periodic");
}

void PackingBuilder::set_cell(const Mat3& cell, const std::array<bool, 3>& periodic, std::size_t line) {
  if (options_.box)
    require_given_box(cell, periodic, line);
  use_cell(cell, periodic, line);
}

void PackingBuilder::use_cell(const Mat3& given, const std::array<bool, 3>& given_periodic,
                              std::size_t line) {
  Mat3 cell = given;
  std::array<bool, 3> periodic = given_periodic;
  if (determinant(cell) < 0 && !is_upside_down(cell)) {
    swap_edges(cell);
    std::swap(periodic[0], periodic[1]);
    note(Finding::cell_turned, "the edges of the cell are left-handed: the first two were swapped");
  }
  const double volume = determinant(cell);
  const Mat3 back = inverse_of(cell);
  bool usable = volume > 0 && std::isfinite(volume);
  for (int k = 0; k < 3; ++k)
    usable = usable && in_range(column(cell, k)) && in_range(column(back, k));
  if (!usable)
    throw FileError(grain_file_, line,
                    "expected a box of positive volume, found " + short_text(volume) + " m^3");
  if (reduce_cell(cell, periodic))
    note(Finding::cell_turned,
         "the cell is tilted by more than half an edge: replaced by an equivalent cell of the lattice");
  packing_.assembly.cell = cell;
  packing_.periodic = periodic;
  cell_ = PeriodicCell(cell, periodic);
  has_cell_ = true;
}

void PackingBuilder::set_grains(std::vector<GrainRow> rows) {
  if (rows.empty())
    throw FileError(grain_file_, 0, "contains no grains");
  if (rows.size() >= std::numeric_limits<std::uint32_t>::max())
    throw FileError(grain_file_, 0, "contains more than 4294967294 grains");
  const auto by_id = [](const GrainRow& a, const GrainRow& b) { return a.id < b.id; };
  if (!std::is_sorted(rows.begin(), rows.end(), by_id))
    std::stable_sort(rows.begin(), rows.end(), by_id);
  packing_.id.reserve(rows.size());
  packing_.assembly.position.reserve(rows.size());
  packing_.assembly.radius.reserve(rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    stop_point(k);
    const GrainRow& grain = rows[k];
    if (k > 0 && rows[k - 1].id == grain.id)
      throw FileError(grain_file_, grain.line,
                      "the grain " + std::to_string(grain.id) + " is also on line " +
                          std::to_string(rows[k - 1].line));
    if (!(grain.radius > 0) || !in_range(grain.radius))
      throw FileError(grain_file_, grain.line,
                      "expected a positive radius of grain " + std::to_string(grain.id) + ", found " +
                          short_text(grain.radius));
    if (!in_range(grain.position))
      throw FileError(grain_file_, grain.line, "the position of the grain is beyond all range");
    packing_.id.push_back(grain.id);
    packing_.assembly.position.push_back(grain.position);
    packing_.assembly.radius.push_back(grain.radius);
  }
  if (std::all_of(rows.begin(), rows.end(), [](const GrainRow& g) { return g.type.has_value(); }))
    for (const GrainRow& grain : rows)
      packing_.type.push_back(*grain.type);
  take_bodies(rows);
  if (std::all_of(rows.begin(), rows.end(), [](const GrainRow& g) { return g.force.has_value(); }))
    for (const GrainRow& grain : rows)
      stated_force_.push_back(*grain.force);
  if (!has_cell_ && options_.box)
    use_cell(options_.box->cell, options_.box->periodic, 0);
  else if (!has_cell_)
    bound_grains();
}

void PackingBuilder::take_bodies(const std::vector<GrainRow>& rows) {
  if (options_.none("body"))
    return;
  std::map<long, std::size_t> members;
  for (const GrainRow& grain : rows)
    if (grain.body && *grain.body > 0)
      ++members[*grain.body];
  const auto shared = [&](const GrainRow& g) { return g.body && *g.body > 0 && members[*g.body] > 1; };
  const auto parts = static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), shared));
  if (parts == 0 || (members.size() == 1 && parts == rows.size())) // one molecule for all grains is none
    return;
  std::map<long, std::uint32_t> number;
  std::uint32_t bodies = 0;
  for (const GrainRow& grain : rows) {
    if (!shared(grain))
      packing_.assembly.body.push_back(bodies++);
    else if (const auto [place, is_new] = number.try_emplace(*grain.body, bodies); is_new)
      packing_.assembly.body.push_back(bodies++);
    else
      packing_.assembly.body.push_back(place->second);
  }
  note(Finding::bodies,
       many(parts, "grains are parts of ") +
           many(number.size(), "rigid bodies, which move as one; volume shared by grains of a "
                               "body counts twice in the void ratio (if they are free: --column-map "
                               "body=none)"));
}

void PackingBuilder::drop_inner_contacts() {
  const std::vector<std::uint32_t>& body = packing_.assembly.body;
  if (!body.empty())
    std::erase_if(packing_.assembly.contacts,
                  [&](const packing::Contact& c) { return body[c.i] == body[c.j]; });
}

void PackingBuilder::bound_grains() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec3 low{infinity, infinity, infinity}, high = -low;
  for (std::size_t g = 0; g < packing_.assembly.grain_count(); ++g)
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], packing_.assembly.position[g][k] - packing_.assembly.radius[g]);
      high[k] = std::max(high[k], packing_.assembly.position[g][k] + packing_.assembly.radius[g]);
    }
  use_cell(Mat3::diagonal(high.x - low.x, high.y - low.y, high.z - low.z), {false, false, false}, 0);
  note(Finding::cell_unknown, "no box in the file: the smallest upright box around the grains is the cell");
}

std::optional<std::uint32_t> PackingBuilder::find(long id) const {
  const auto& ids = packing_.id;
  // Most codes number their grains from 1 on, without gaps.
  if (id >= ids.front() && id - ids.front() < static_cast<long>(ids.size())) {
    const auto place = static_cast<std::uint32_t>(id - ids.front());
    if (ids[place] == id)
      return place;
  }
  const auto found = std::lower_bound(ids.begin(), ids.end(), id);
  if (found == ids.end() || *found != id)
    return std::nullopt;
  return static_cast<std::uint32_t>(found - ids.begin());
}

std::uint32_t PackingBuilder::index(long id, std::size_t line) const {
  const auto found = find(id);
  const auto& ids = packing_.id;
  if (!found)
    fail_contact(line, "the grain " + std::to_string(id) + " is not among the " + many(ids.size(), "grains") +
                           " (ids " + std::to_string(ids.front()) + " to " + std::to_string(ids.back()) +
                           ")");
  return *found;
}

Vec3 PackingBuilder::straight(std::uint32_t a, std::uint32_t b) const { return position(b) - position(a); }

double PackingBuilder::reach(std::uint32_t a, std::uint32_t b) const {
  return (1 + same_branch) * radius_sum(a, b);
}

Vec3 PackingBuilder::touching_image(std::uint32_t a, std::uint32_t b, const Vec3& direction,
                                    std::optional<double> distance) {
  const std::vector<Vec3> images = cell_.images(straight(a, b), reach(a, b));
  if (images.size() == 1)
    return images.front();
  const auto misfit = [&](const Vec3& image) {
    const double length = norm(image), scale = norm(direction) * length;
    return (scale > 0 ? 1 - dot(direction, image) / scale : 0) +
           (distance ? std::abs(length - *distance) / radius_sum(a, b) : 0);
  };
  double least = misfit(images.front());
  for (const Vec3& image : images)
    least = std::min(least, misfit(image));
  const bool turn = a > b;
  std::vector<Vec3>& taken = taken_[{std::min(a, b), std::max(a, b)}];
  std::optional<Vec3> best;
  for (const Vec3& image : images) {
    constexpr double alike = 1e-4;
    if (misfit(image) > least + alike)
      continue;
    const Vec3 forward = turn ? -image : image;
    const bool free =
        std::none_of(taken.begin(), taken.end(), [&](const Vec3& t) { return same(t, forward); });
    if (!best || free)
      best = image;
    if (free)
      break;
  }
  taken.push_back(turn ? -*best : *best);
  return *best;
}

void PackingBuilder::require_agreement(const PairRow& row) const {
  const double radii = radius_sum(row.a, row.b);
  const Vec3 between = straight(row.a, row.b);
  const bool image = norm(row.branch) <= farthest * radii; // of several that touch; else it is the nearest
  const Vec3 off = image ? nearest(row.branch - between) : row.branch - nearest(between);
  if (!(norm(off) <= same_branch * radii))
    fail_contact(row.line, pair_text(row.a, row.b) +
                               " has a line of centres that does not fit the positions of "
                               "the grains: are both of the same state?");
}

std::string PackingBuilder::pair_text(std::uint32_t a, std::uint32_t b) const {
  return "the pair " + std::to_string(packing_.id[a]) + ", " + std::to_string(packing_.id[b]);
}

template <class Name>
void PackingBuilder::require_finite(const PairRow& row, const Name& name) const {
  const double length = norm(row.branch);
  if (!(length > 0) || !in_range(length))
    fail_contact(row.line, name() + " has no line of centres");
  if (!in_range(row.overlap) || !in_range(row.normal_force) || !in_range(row.tangential_force) ||
      !in_range(row.normal_stiffness) || !in_range(row.tangential_stiffness))
    fail_contact(row.line, name() + " has numbers beyond all range");
}

void PackingBuilder::add_wall(const PairRow& row, long wall) {
  if (wall < 0 || wall > std::numeric_limits<std::uint32_t>::max())
    fail_contact(row.line, "expected a number of a wall, found " + std::to_string(wall));
  require_finite(row, [&] {
    return "the contact of grain " + std::to_string(packing_.id[row.a]) + " with wall " +
           std::to_string(wall);
  });
  packing::Contact contact = contact_of(row);
  contact.j = static_cast<std::uint32_t>(wall);
  packing_.assembly.wall_contacts.push_back(contact);
}

void PackingBuilder::add(const PairRow& row) {
  if (row.a == row.b && norm(row.branch) > 0 && norm(row.branch) <= reach(row.a, row.b) &&
      norm(nearest(row.branch)) <= same_branch * radius_sum(row.a, row.b)) {
    require_finite(row, [&] { return pair_text(row.a, row.b); });
    const Vec3& b = row.branch;
    const bool turn = std::tie(b.x, b.y, b.z) < std::tuple(0.0, 0.0, 0.0); // one image, seen from either side
    const packing::Contact own = turn ? turned(contact_of(row)) : contact_of(row);
    if (std::none_of(own_images_.begin(), own_images_.end(),
                     [&](const packing::Contact& c) { return c.i == own.i && same(c.branch, own.branch); }))
      own_images_.push_back(own);
    return;
  }
  if (row.a == row.b)
    fail_contact(row.line, "the grain " + std::to_string(packing_.id[row.a]) + " is in contact with itself" +
                               (ambiguous(row.a, row.b)
                                    ? ": through a face of a narrow periodic cell; write two copies "
                                      "of the packing side by side"
                                    : ""));
  require_finite(row, [&] { return pair_text(row.a, row.b); });
  if (row.overlap <= 0) {
    if (forces_known_ && row.normal_force == 0 && row.tangential_force == Vec3{} && row.overlap < 0) {
      ++neighbours_;
      return;
    }
    ++open_;
  }
  if (norm(row.branch) > farthest * radius_sum(row.a, row.b))
    fail_contact(row.line,
                 pair_text(row.a, row.b) + " is in contact across a gap: are the right faces periodic?");
  if (norm(row.branch - straight(row.a, row.b)) > same_branch * radius_sum(row.a, row.b))
    ++through_faces_;
  const packing::Contact as_read = contact_of(row);
  const bool turn = row.a > row.b;
  const packing::Contact contact = turn ? turned(as_read) : as_read;
  if (!entries_.empty() && !both_sides_) {
    const packing::Contact& last = entries_.back().contact;
    unsorted_ = unsorted_ || std::tie(contact.i, contact.j) < std::tie(last.i, last.j);
  }
  entries_.push_back({contact, {turn, row.line}});
}

/// Makes a contact of all rows of a pair, numbered in `group`; one for each image of the second grain
/// where rows lead to several.
void PackingBuilder::merge(std::span<const std::uint32_t> group) {
  const auto branch = [this](std::uint32_t number) { return entries_[number].contact.branch; };
  std::vector<std::vector<std::uint32_t>> images;
  for (const std::uint32_t number : group) {
    const auto found =
        std::find_if(images.begin(), images.end(), [&](const std::vector<std::uint32_t>& rows) {
          return same(branch(number), branch(rows.front()));
        });
    (found == images.end() ? images.emplace_back() : *found).push_back(number);
  }
  for (const std::vector<std::uint32_t>& rows : images) {
    const Entry& one = entries_[rows.front()];
    const double off = norm(nearest(one.contact.branch - branch(group.front())));
    if (!(off <= same_branch * radius_sum(one.contact.i, one.contact.j)))
      fail_repeated(one, entries_[group.front()]);
  }
  std::sort(images.begin(), images.end(), [&](const auto& x, const auto& y) {
    const Vec3 a = branch(x.front()), b = branch(y.front());
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  });
  for (const std::vector<std::uint32_t>& rows : images)
    merge_image(rows);
}

void PackingBuilder::fail_repeated(const Entry& entry, const Entry& first) const {
  fail_contact(entry.side.line, pair_text(entry.contact.i, entry.contact.j) + " is also on line " +
                                    std::to_string(first.side.line) +
                                    ", with another line of centres or force");
}

/// Makes one contact of all rows that agree.
void PackingBuilder::merge_image(std::span<const std::uint32_t> group) {
  const Entry& front = entries_[group.front()];
  const packing::Contact& first = front.contact;
  std::size_t turned_rows = 0;
  for (const std::uint32_t number : group) {
    const Entry& entry = entries_[number];
    const packing::Contact& c = entry.contact;
    if (!same(force(c), force(first)))
      fail_repeated(entry, front);
    turned_rows += entry.side.turned ? 1 : 0;
  }
  const std::size_t straight_rows = group.size() - turned_rows;
  if (both_sides_) {
    one_sided_ += (turned_rows == 0 || straight_rows == 0) ? 1 : 0;
    duplicated_ += (turned_rows > 1 ? turned_rows - 1 : 0) + (straight_rows > 1 ? straight_rows - 1 : 0);
  } else {
    duplicated_ += group.size() - 1;
  }
  packing_.assembly.contacts.push_back(first);
}

ImportedPacking PackingBuilder::finish(long step, std::optional<double> time) {
  const auto pair = [this](std::uint32_t number) {
    const packing::Contact& c = entries_[number].contact;
    return std::pair(c.i, c.j);
  };
  std::vector<std::uint32_t> order(entries_.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, {}, pair);
  packing_.assembly.contacts.reserve(entries_.size());
  for (auto begin = order.begin(); begin != order.end();) {
    const auto end =
        std::find_if(begin, order.end(), [&](std::uint32_t number) { return pair(number) != pair(*begin); });
    merge({begin, end});
    begin = end;
  }
  drop_inner_contacts();
  turn_signs();
  compare_forces();
  entries_ = {};
  std::ranges::stable_sort(packing_.assembly.wall_contacts, {},
                           [](const packing::Contact& c) { return std::pair(c.i, c.j); });
  note_counts();
  if (!own_images_.empty()) {
    auto& contacts = packing_.assembly.contacts;
    contacts.insert(contacts.end(), own_images_.begin(), own_images_.end());
    packing_ = without_own_images(std::move(packing_));
  }
  packing_ = without_air(std::move(packing_));
  packing_.step = step;
  packing_.time = time;
  if (!overlaps_stated_)
    packing_.rounding.overlap = packing_.rounding.length;
  try {
    require_valid(packing_.assembly);
  } catch (const InvalidArgument& error) {
    throw FileError(contact_file_, 0, error.what());
  }
  return std::move(packing_);
}

void PackingBuilder::fail_contact(std::size_t line, const std::string& what) const {
  throw FileError(contact_file_, line, what);
}

} // namespace granum::io
