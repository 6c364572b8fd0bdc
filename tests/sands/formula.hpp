// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cctype>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>

namespace granum::test {

/// The value of a formula as a law states it: "a (p/p_a)^n, a = 2 MPa, n = 0.5". What is not an equation
/// behind the first comma is words.
class Formula {
 public:
  /// \param    values   of names and units
  Formula(const std::string& text, std::map<std::string, double> values) : values_(std::move(values)) {
    std::size_t end = text.find(", ");
    first_ = text.substr(0, end);
    while (end < text.size()) {
      const std::size_t begin = end + 2;
      end = text.find(", ", begin);
      const std::string clause = text.substr(begin, end - begin);
      if (const std::size_t equals = clause.find(" = "); equals < clause.size())
        definitions_[clause.substr(0, equals)] = clause.substr(equals + 3);
    }
  }

  double value() { return value(first_); }

 private:
  double value(const std::string& text) {
    const std::string before = rest_;
    rest_ = text;
    const double found = sum();
    if (peek() != '\0')
      throw std::logic_error("not understood: " + rest_);
    rest_ = before;
    return found;
  }
  char peek() {
    rest_.erase(0, rest_.find_first_not_of(' '));
    return rest_.empty() ? '\0' : rest_[0];
  }
  bool take(char c) {
    const bool found = peek() == c;
    if (found)
      rest_.erase(0, 1);
    return found;
  }
  std::string name() {
    std::size_t end = peek() == '%' ? 1 : 0;
    while (end < rest_.size() && rest_[0] != '%' &&
           (std::isalnum(static_cast<unsigned char>(rest_[end])) || rest_[end] == '_' || rest_[end] == '\''))
      ++end;
    const std::string found = rest_.substr(0, end);
    rest_.erase(0, end);
    return found;
  }

  double sum() {
    double total = product();
    while (peek() == '+' || peek() == '-')
      total += (take('+') ? 1 : (take('-'), -1)) * product();
    return total;
  }
  double product() {
    double total = power();
    for (char c = peek(); c != '\0' && c != '+' && c != '-' && c != ')'; c = peek())
      total = take('/') ? total / power() : total * power();
    return total;
  }
  double power() { // a sign belongs to the whole power, except behind ^
    if (take('-'))
      return -power();
    const double base = primary();
    return take('^') ? std::pow(base, take('-') ? -primary() : primary()) : base;
  }
  double primary() {
    if (take('(')) {
      const double inner = sum();
      take(')');
      return inner;
    }
    if (std::isdigit(static_cast<unsigned char>(peek()))) {
      std::size_t length = 0;
      const double number = std::stod(rest_, &length);
      rest_.erase(0, length);
      const std::string before = rest_, unit = peek() == '\0' ? "" : name();
      if (unit == "%" || unit == "mm" || unit == "MPa")
        return number * values_.at(unit);
      rest_ = before;
      return number;
    }
    const std::string word = name();
    if (word == "exp")
      return std::exp(power());
    if (word == "ln")
      return std::log(power());
    if (word == "log10")
      return std::log10(power());
    if (word == "tanh")
      return std::tanh(power());
    const auto known = values_.find(word);
    return known != values_.end() ? known->second : value(definitions_.at(word));
  }

  std::string first_, rest_;
  std::map<std::string, double> values_;
  std::map<std::string, std::string> definitions_;
};

} // namespace granum::test
