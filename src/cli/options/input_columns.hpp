// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <granum/estimate/input_values.hpp>
#include <granum/estimate/notes.hpp>
#include <granum/io/csv/table.hpp>

#include "cli/frame/option_row.hpp"

/// Columns of a table for values that may also be options, and what each row knows of its packing.
namespace granum::cli {

/// Symbols that head the columns of measured quantities, the same for every command that reads a table;
/// separated by blanks. Those of inputs are in their rows (granum/estimate/inputs.hpp).
/// is_column_of reads primes and the Greek letter sigma in them too.
namespace column_names {

inline constexpr std::string_view shear_modulus = "G G_max Gmax G_0 G0 G_hv G_vh Ghv Gvh shear_modulus";
inline constexpr std::string_view shear_modulus_hh = "G_hh Ghh";
inline constexpr std::string_view bulk_modulus = "K";
inline constexpr std::string_view shear_wave_speed = "V_s Vs v_s vs shear_wave_speed shear_wave_velocity";
inline constexpr std::string_view shear_wave_speed_hh = "V_s_hh Vs_hh";
inline constexpr std::string_view compression_wave_speed =
    "V_p Vp v_p vp compression_wave_speed compression_wave_velocity";
inline constexpr std::string_view compression_wave_speed_h = "V_p_h Vp_h";

} // namespace column_names

/// The names of a column, without the unit: symbols, which blanks separate, then the option without its
/// hyphens, void_ratio; of an input then the other headings that people have. Words are read however they are
/// spelt (is_column_of).
[[nodiscard]] std::vector<std::string> names_of_column(estimate::Input input);
[[nodiscard]] std::vector<std::string> names_of_column(std::string_view symbols, const std::string& option);

/// Inputs and other numbers bound to their columns, by the names of their options (void_ratio, "Void Ratio"),
/// by symbol (e), or by another heading that people have (e_c, "Mean Effective Stress"), with their unit:
/// p_kPa, "p (kPa)", "p [kPa]".
class InputColumns {
 public:
  /// \param    options   what the options give, for all rows; it must stay in its place
  /// \throws   FileError for a table with suction
  InputColumns(const io::CsvTable& table, const estimate::InputValues& options);

  /// Binds an input to its column; returns whether there is one. Rows that leave it empty do not give it.
  /// \throws   FileError for a column without its unit, or if two columns contain the number;
  ///           InvalidArgument if it is given by an option too
  bool bind(estimate::Input input);
  /// Binds the inputs of a packing, those of its contact law among them.
  void bind_packing();
  /// Binds what is known of the material: relative density and its limits, density of the grains, saturation;
  /// and by name grain, sand and kind of grains.
  void bind_material();
  /// The same as bind for a number that is no input; an empty field gives its default.
  bool bind(Number& number);
  /// Marks a column as used by other code.
  void mark_as_read(std::size_t column) { read_.at(column) = true; }

  /// Whether options or columns give a stress.
  [[nodiscard]] bool gives_stress() const;
  /// The inputs of the options and a row; also sets the numbers that are bound.
  /// \throws   InvalidArgument for a field that is not a number or not one of the words of its input
  [[nodiscard]] estimate::InputValues row(std::size_t row) const;
  /// The heading of the column that gives an option, such as "--saturation".
  [[nodiscard]] std::optional<std::string> heading(std::string_view option) const;
  /// Headings of unused columns.
  [[nodiscard]] std::vector<std::string> unread() const;
  /// Sentences on how columns were read, and "unused columns: borehole, date".
  [[nodiscard]] std::vector<std::string> remarks() const;

 private:
  struct NumberColumn {
    Number* number; ///< null for an input
    estimate::Input input;
    io::CsvTable::Place place;
    bool per_cent; ///< in its heading
    double by_default;
  };
  struct TextColumn {
    estimate::Input input;
    std::size_t index;
  };
  struct Field {
    double number = 0;
    bool given = false;
  };

  [[nodiscard]] std::optional<io::CsvTable::Place> find(std::string_view symbols, const std::string& name,
                                                        Dimension dimension) const;
  bool bind_number(Number* number, estimate::Input input, std::string_view symbols, const std::string& option,
                   Dimension dimension, bool option_given, double by_default);
  bool bind_text(const estimate::InputRow& row);
  /// The stress sigma_3 of a cell without any other stress is the mean stress.
  void take_alone_as_mean();
  [[nodiscard]] Field field(const NumberColumn& column, std::size_t row) const;
  void read(std::size_t column, const std::string& option);

  const io::CsvTable& table_;
  const estimate::InputValues& given_;
  std::vector<NumberColumn> numbers_;
  std::vector<TextColumn> texts_;
  std::vector<bool> read_;
  std::vector<std::string> options_; ///< of each column; empty without one
  std::vector<std::string> remarks_;
};

/// Adds remarks on a table to the notes, and says each on standard error.
void name_remarks(estimate::Notes& to, const std::vector<std::string>& remarks);

/// \throws   FileError for a table with suction or a negative pore pressure, which no law here has
void refuse_suction(const io::CsvTable& table);

} // namespace granum::cli
