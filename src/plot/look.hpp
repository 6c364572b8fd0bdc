// SPDX-License-Identifier: GPL-3.0-or-later
// How series look: colours, dashes, markers, and their entries in a legend.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <granum/plot/chart.hpp>
#include <granum/plot/svg_text.hpp>

namespace granum::plot {

/// \throws   InvalidArgument if a chart contradicts itself, as svg says
void require_valid(const Chart& chart);

/// "#rrggbb" on white paper of the series at that place in its chart.
[[nodiscard]] const char* colour_of(const Series& series, std::size_t place);

/// Rules of CSS that turn charts dark on a screen whose reader wants that.
[[nodiscard]] std::string dark_rules();

inline constexpr double font_size = 14;   ///< of all texts but titles
inline constexpr double title_size = 16;  ///< of titles
inline constexpr double title_line = 21;  ///< from one line of a title to the next
inline constexpr double legend_line = 22; ///< from one row of a legend to the next

/// A point of a picture, x to the right and y down.
struct Spot {
  double x = 0;
  double y = 0;
};
[[nodiscard]] std::string pair(const Spot& at);

/// A wide estimate of the width of a text.
[[nodiscard]] double text_width(std::string_view text, double size = font_size);

/// Lines of at most that width, broken at blanks.
[[nodiscard]] std::vector<std::string> wrapped(const std::string& text, double width, double size);

/// One series among those of its chart.
class Look {
 public:
  Look(const Series& series, std::size_t place);

  [[nodiscard]] double marker_size() const { return tone_ == Tone::faint ? 2.5 : 4; }
  [[nodiscard]] std::string marker(const Spot& at) const; ///< circle, square, diamond or triangle
  [[nodiscard]] SvgAttributes stroke() const;
  [[nodiscard]] SvgAttributes filling() const;
  [[nodiscard]] SvgAttributes group() const;

 private:
  std::size_t index_; ///< of dashes and markers
  std::size_t colour_;
  std::size_t place_;
  Tone tone_;
  std::string kind_;
};

/// A pale surface in the colour of its group.
[[nodiscard]] std::string surface(const std::string& path);

/// An upright bar from `high` to `low` with a cap at either end.
[[nodiscard]] std::string error_bar(double x, double high, double low);

/// Samples and names, below a picture from left to right or right of it one below the other.
class Legend {
 public:
  explicit Legend(const Chart& chart);

  [[nodiscard]] double widest() const;             ///< name with its sample, 0 without names
  [[nodiscard]] double height(double width) const; ///< of rows of that width
  [[nodiscard]] std::string rows(const Spot& corner, double width) const;
  [[nodiscard]] std::string column(const Spot& corner) const;

 private:
  struct Entry {
    std::string name;
    const Series* series;
    std::size_t place;
    bool shared; ///< by series of several colours
  };
  [[nodiscard]] std::vector<Spot> places(double width) const;
  [[nodiscard]] std::string drawn(const Entry& entry, const Spot& at) const;
  [[nodiscard]] static double length(const Entry& entry);

  std::vector<Entry> entries_;
  bool rose_; ///< markers are bars
};

} // namespace granum::plot
