// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/matrix_market.hpp>

#include <charconv>

namespace granum::io {

std::string matrix_market(const Eigen::SparseMatrix<double>& symmetric,
                          std::span<const std::string> comments) {
  using Element = Eigen::SparseMatrix<double>::InnerIterator;
  std::string elements;
  Eigen::Index count = 0;
  const auto append = [&](auto number, char behind) {
    char buffer[64];
    elements.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, number).ptr) += behind;
  };
  for (Eigen::Index column = 0; column < symmetric.outerSize(); ++column)
    for (Element element(symmetric, column); element; ++element)
      if (element.row() >= column) {
        append(element.row() + 1, ' ');
        append(column + 1, ' ');
        append(element.value(), '\n');
        ++count;
      }
  std::string text = "%%MatrixMarket matrix coordinate real symmetric\n";
  for (const std::string& comment : comments)
    text += "% " + comment + '\n';
  const std::string rows = std::to_string(symmetric.rows());
  return text + rows + ' ' + rows + ' ' + std::to_string(count) + '\n' + elements;
}

} // namespace granum::io
