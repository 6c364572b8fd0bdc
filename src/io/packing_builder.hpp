// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/core/vec3.hpp>
#include <granum/io/imported_packing.hpp>

namespace granum::io {

/// Whether an edge of a box along the axes, or of LAMMPS' tilted ones, ends before it begins: no order of
/// edges corrects bounds in reverse order.
[[nodiscard]] bool is_upside_down(const Mat3& cell);

/// Shortens periodic edges by others until none leans by more than half of another: a cell of the same
/// lattice, in which the images nearest to one another are next to one another.
/// \return   whether anything was to be done
bool reduce_cell(Mat3& cell, const std::array<bool, 3>& periodic);

/// The first two edges in each other's place: a right-handed cell of a left-handed one.
void swap_edges(Mat3& cell);

/// A cell with some periodic pairs of faces.
class PeriodicCell {
 public:
  PeriodicCell() = default;
  /// Assumes a finite volume other than zero.
  PeriodicCell(const Mat3& edges, const std::array<bool, 3>& periodic);

  /// The shortest periodic image of a difference of two positions.
  [[nodiscard]] Vec3 nearest(const Vec3& difference) const;
  /// All periodic images of a difference up to a length, the shortest first; the shortest in any case.
  /// Assumes   no grain of half that length reaches around the cell to itself.
  [[nodiscard]] std::vector<Vec3> images(const Vec3& difference, double length) const;

 private:
  [[nodiscard]] Vec3 shifted(Vec3 difference, int a, int b, int c) const;

  Mat3 edges_;
  Mat3 inverse_;
  std::array<bool, 3> periodic_{};
  double safe_length_ = 0; ///< up to it, the image found by rounding is the shortest
};

/// Whether a length [m], force [N] or stiffness [N/m] can be a packing's: products of several that are larger
/// would overflow.
inline bool in_range(double value) { return std::abs(value) <= 1e60; }
inline bool in_range(const Vec3& v) { return in_range(v.x) && in_range(v.y) && in_range(v.z); }

/// A grain as a file states it.
struct GrainRow {
  long id = 0;
  Vec3 position{}; ///< [m]
  double radius = 0;
  std::size_t line = 0;
  std::optional<long> type = {};  ///< as LAMMPS numbers materials
  std::optional<long> body = {};  ///< rigid body that the grain is a part of; 0 or less: of none
  std::optional<Vec3> force = {}; ///< sum of the contact forces, as the code has it [N]
};

/// A contact as a file states it, in the file's order of the two grains a and b.
struct PairRow {
  std::uint32_t a = 0, b = 0; ///< indices in the assembly
  Vec3 branch{};              ///< from a to b [m]
  double overlap = 0;
  double normal_force = 0;
  Vec3 tangential_force{}; ///< exerted by a on b [N]
  double normal_stiffness = 0;
  double tangential_stiffness = 0;
  bool sliding = false;
  double rolling_stiffness = 0;
  double twisting_stiffness = 0;
  std::size_t line = 0;
};

/// "3 rows".
inline std::string many(std::size_t count, const char* what) { return std::to_string(count) + " " + what; }

/// Significant digits that a group of numbers is written with: the most seen, as trailing zeros are not
/// written.
class DigitWatch {
 public:
  void see(std::string_view number);
  /// "at most 6 significant digits" where that may be too few for overlaps.
  [[nodiscard]] bool few() const { return seen_ > 0 && seen_ <= enough; }
  [[nodiscard]] int most() const { return seen_; }
  /// Half a unit of the last digit of the largest number; 0 unless there are few digits.
  [[nodiscard]] double rounding() const;
  /// The same over the number, at worst; 0 unless there are few digits.
  [[nodiscard]] double relative_rounding() const;

 private:
  static constexpr int enough = 8;
  int seen_ = 0;
  double largest_ = 0;
};

/// Combines the rows of any format into a packing, and rejects impossible ones.
class PackingBuilder {
 public:
  PackingBuilder(std::string grain_file, std::string contact_file, PackingFileOptions options = {})
      : grain_file_(std::move(grain_file)), contact_file_(std::move(contact_file)),
        options_(std::move(options)) {}

  /// \throws   FileError unless the volume is finite and positive; InvalidArgument if the options give
  ///           another box, to 1e-4 of its longest edge
  void set_cell(const Mat3& cell, const std::array<bool, 3>& periodic, std::size_t line);
  /// Takes the grains, in the order of their ids. If no cell was set before: the box of the options, else the
  /// smallest upright box, and a note.
  /// \throws   FileError for no grains, an invalid radius or position, an id that occurs twice
  void set_grains(std::vector<GrainRow> rows);

  /// Index of the grain of an id.
  /// \throws   FileError if there is none
  [[nodiscard]] std::uint32_t index(long id, std::size_t line) const;
  /// The same; empty if there is none.
  [[nodiscard]] std::optional<std::uint32_t> find(long id) const;
  [[nodiscard]] double radius(std::uint32_t grain) const { return packing_.assembly.radius[grain]; }
  [[nodiscard]] double radius_sum(std::uint32_t a, std::uint32_t b) const { return radius(a) + radius(b); }
  [[nodiscard]] const std::vector<Vec3>& positions() const { return packing_.assembly.position; }
  [[nodiscard]] const Vec3& position(std::uint32_t grain) const { return packing_.assembly.position[grain]; }
  /// Centre of b minus centre of a, without periodic images.
  [[nodiscard]] Vec3 straight(std::uint32_t a, std::uint32_t b) const;
  /// The shortest periodic image of a difference of positions.
  [[nodiscard]] Vec3 nearest(const Vec3& difference) const { return cell_.nearest(difference); }
  /// The line of centres from a to b that a row means which does not state it: of the images that the two
  /// grains can touch through, in cells narrower than two diameters perhaps several, the one that fits best.
  /// Rows of a pair that fit several images equally are assigned to one after the other.
  /// \param    direction   from a to b, of any length; zero if not in the row
  /// \param    distance    of the centres, if in the row [m]
  [[nodiscard]] Vec3 touching_image(std::uint32_t a, std::uint32_t b, const Vec3& direction,
                                    std::optional<double> distance);
  /// Whether two grains may touch through several images.
  [[nodiscard]] bool ambiguous(std::uint32_t a, std::uint32_t b) const {
    return cell_.images(straight(a, b), reach(a, b)).size() > 1;
  }
  /// \throws   FileError if a branch that the file states leads to no image of the other grain (1 % of the
  ///           radii)
  void require_agreement(const PairRow& row) const;

  /// Adds a contact. A row without overlap and without force is a neighbour that does not touch: left out.
  /// \throws   FileError for a grain in contact with itself, centres that coincide, numbers beyond all range
  void add(const PairRow& row);
  /// Counts a row of contacts that holds zeros alone, which is left out.
  void skip_empty(std::size_t rows = 1) { empty_ += rows; }
  /// Adds a contact with a wall; all vectors point from the grain a to the wall.
  /// \throws   FileError for an invalid wall number, a branch of no length, numbers beyond all range
  void add_wall(const PairRow& row, long wall);
  /// Notes a finding, unless the options state what was not found.
  void note(Finding finding, std::string text);
  /// Notes the columns or arrays that were not used: those of shapes in a note of their own.
  /// \param    place   "columns of the grains"
  void note_unused(const std::vector<std::string>& names, const std::string& place);
  /// \param    unit   that the coordinates are in [m]
  void note_digits(const DigitWatch& coordinates, std::string_view what, double unit = 1);
  /// The same for the source of the overlaps, if the rows of contacts contain it.
  void note_overlap_digits(const DigitWatch& numbers, std::string_view what, double unit = 1);
  void note_force_digits(const DigitWatch& forces) { packing_.rounding.force = forces.relative_rounding(); }
  /// Lengths of single precision, up to the largest of the coordinates.
  void note_single_precision(std::string text);
  /// Makes room for so many rows of contacts.
  void expect_contacts(std::size_t rows) { entries_.reserve(rows); }
  /// Declares that the files contain every pair twice, once from each side.
  void expect_both_sides() { both_sides_ = true; }
  /// Declares that the files contain no forces: rows without force are then contacts too.
  void expect_no_forces() { forces_known_ = false; }

  /// The packing with its contacts sorted, each pair once.
  /// \throws   FileError for a pair that occurs twice with different values
  [[nodiscard]] ImportedPacking finish(long step, std::optional<double> time);

  [[noreturn]] void fail_contact(std::size_t line, const std::string& what) const;

 private:
  struct Side {
    bool turned;
    std::size_t line;
  };
  struct Entry {
    packing::Contact contact;
    Side side;
  };

  void bound_grains();
  void use_cell(const Mat3& cell, const std::array<bool, 3>& periodic, std::size_t line);
  void require_given_box(const Mat3& cell, const std::array<bool, 3>& periodic, std::size_t line) const;
  void take_bodies(const std::vector<GrainRow>& rows);
  /// Forces that pull all overlapping spheres apart have the other sign.
  void turn_signs();
  /// Contacts inside of a body carry no force.
  void drop_inner_contacts();
  /// Compares the sums of the contact forces with those that the file of grains states.
  void compare_forces();
  /// Largest distance in the search for the image of a listed pair.
  [[nodiscard]] double reach(std::uint32_t a, std::uint32_t b) const;
  void merge(std::span<const std::uint32_t> group);
  void merge_image(std::span<const std::uint32_t> rows);
  [[noreturn]] void fail_repeated(const Entry& entry, const Entry& first) const;
  /// \throws   FileError for a line of centres of no length, or numbers beyond all range
  /// \param    name  gives the text that names the contact
  template <class Name>
  void require_finite(const PairRow& row, const Name& name) const;
  [[nodiscard]] std::string pair_text(std::uint32_t a, std::uint32_t b) const;
  void note_counts();

  std::string grain_file_;
  std::string contact_file_;
  PackingFileOptions options_;
  ImportedPacking packing_;
  PeriodicCell cell_;
  bool has_cell_ = false;
  bool both_sides_ = false;
  bool forces_known_ = true;
  bool overlaps_stated_ = false;
  bool unsorted_ = false;
  std::vector<Entry> entries_;
  std::vector<packing::Contact> own_images_; ///< of grains with their own images, each once
  std::vector<Vec3> stated_force_;           ///< on each grain; empty if not in the files
  /// Images that rows without a line of centres have been given, of pairs with several.
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Vec3>> taken_;
  std::size_t through_faces_ = 0, open_ = 0, neighbours_ = 0, duplicated_ = 0, one_sided_ = 0, empty_ = 0;
};

/// The message of PackingBuilder, which names a line of a file, with the name of an array's element in its
/// place.
[[nodiscard]] inline InvalidArgument in_arrays(const FileError& error) {
  const bool numbered = error.line() > 0;
  const std::string place = error.path() + (numbered ? ":" + std::to_string(error.line()) : "") + ": ";
  const std::string element = numbered ? "[" + std::to_string(error.line() - 1) + "]" : "";
  return InvalidArgument(error.path() + element + ": " + std::string(error.what()).substr(place.size()));
}

} // namespace granum::io
