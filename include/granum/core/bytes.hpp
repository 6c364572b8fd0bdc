// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <granum/core/error.hpp>

/// Plain values as bytes, one after the other, to the bit and in this machine's byte order. Read values in
/// the order and with the types of writing; files with such bytes identify themselves in their header.
/// Checked by tests/core/test_bytes.cpp
namespace granum {

template <class T>
concept Plain = std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>;

class ByteWriter {
 public:
  template <Plain T>
  void put(const T& value) {
    append(&value, sizeof value);
  }
  template <Plain T>
  void put_all(const std::vector<T>& values) {
    put(static_cast<std::uint64_t>(values.size()));
    append(values.data(), values.size() * sizeof(T));
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  void append(const void* data, std::size_t size) {
    if (size > 0)
      bytes_.append(static_cast<const char*>(data), size);
  }

  std::string bytes_;
};

class ByteReader {
 public:
  /// \param    source  names the bytes in errors: the path of their file
  /// Assumes   the bytes outlive the reader.
  ByteReader(std::string_view bytes, std::string source) : rest_(bytes), source_(std::move(source)) {}

  /// \throws   FileError if the bytes end before the value does
  template <Plain T>
  [[nodiscard]] T get() {
    if constexpr (std::is_same_v<T, bool>) // any other byte than 0 and 1 would be undefined
      return get<unsigned char>() != 0;
    T value;
    take(&value, sizeof value);
    return value;
  }
  template <Plain T>
  [[nodiscard]] std::vector<T> get_all() {
    const auto count = get<std::uint64_t>();
    if (count > rest_.size() / sizeof(T))
      fail("ends within a list of " + std::to_string(count) + " values");
    std::vector<T> values(static_cast<std::size_t>(count));
    take(values.data(), values.size() * sizeof(T));
    return values;
  }
  [[nodiscard]] bool empty() const { return rest_.empty(); }
  /// \throws   FileError with this source
  [[noreturn]] void fail(const std::string& what) const { throw FileError(source_, 0, what); }

 private:
  void take(void* to, std::size_t size) {
    if (size > rest_.size())
      fail("ends before its last value");
    if (size > 0)
      std::memcpy(to, rest_.data(), size);
    rest_.remove_prefix(size);
  }

  std::string_view rest_;
  std::string source_;
};

} // namespace granum
