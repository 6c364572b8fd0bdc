// SPDX-License-Identifier: GPL-3.0-or-later
#include "encoding.hpp"

#include <cstdint>
#include <vector>

#include <granum/core/error.hpp>
#include <zlib.h>

namespace granum::io {

namespace {

/// Value of a base64 character; -1 for none.
int base64_value(char c) {
  if (c >= 'A' && c <= 'Z')
    return c - 'A';
  if (c >= 'a' && c <= 'z')
    return c - 'a' + 26;
  if (c >= '0' && c <= '9')
    return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

/// Hands out bytes, decoded on the way. Base64 may be padded in the middle, as VTK encodes the sizes of
/// compressed blocks by themselves.
class ByteStream {
 public:
  ByteStream(std::string_view packed, bool base64) : rest_(packed), base64_(base64) {}

  std::string take(std::uint64_t count) {
    if (count > decoded_.size() + rest_.size())
      throw InvalidArgument("the data end too early");
    if (!base64_) {
      const std::string bytes(rest_.substr(0, count));
      rest_.remove_prefix(count);
      return bytes;
    }
    while (decoded_.size() < count)
      decode_group();
    std::string bytes = decoded_.substr(0, count);
    decoded_.erase(0, count);
    return bytes;
  }

 private:
  /// Four characters, up to three bytes.
  void decode_group() {
    if (rest_.size() < 4)
      throw InvalidArgument("the data end too early");
    std::uint32_t bits = 0;
    int characters = 0;
    for (; characters < 4 && rest_[static_cast<std::size_t>(characters)] != '='; ++characters) {
      const int value = base64_value(rest_[static_cast<std::size_t>(characters)]);
      if (value < 0)
        throw InvalidArgument("expected base64");
      bits |= static_cast<std::uint32_t>(value) << (18 - 6 * characters);
    }
    if (characters < 2 || (characters < 4 && rest_[3] != '='))
      throw InvalidArgument("expected base64");
    for (int k = 0; k < characters - 1; ++k)
      decoded_ += static_cast<char>(bits >> (16 - 8 * k) & 0xff);
    rest_.remove_prefix(4);
  }

  std::string_view rest_;
  std::string decoded_; ///< decoded base64, not yet used
  bool base64_;
};

/// The next number of the header.
std::uint64_t header_number(ByteStream& stream, const VtkEncoding& encoding) {
  const std::string bytes = stream.take(encoding.header_size);
  std::uint64_t value = 0;
  for (std::size_t k = 0; k < bytes.size(); ++k) {
    const std::size_t at = encoding.big_endian ? k : bytes.size() - 1 - k;
    value = value << 8 | static_cast<unsigned char>(bytes[at]);
  }
  return value;
}

std::string inflated(const std::string& block, std::uint64_t size) {
  constexpr std::uint64_t best_ratio = 1032; // of zlib; more is a size that cannot be true
  if (size > best_ratio * (block.size() + 1))
    throw InvalidArgument("a compressed block states a size that it cannot have");
  std::string bytes(size, '\0');
  uLongf length = size;
  if (uncompress(reinterpret_cast<Bytef*>(bytes.data()), &length,
                 reinterpret_cast<const Bytef*>(block.data()), block.size()) != Z_OK ||
      length != size)
    throw InvalidArgument("a compressed block is damaged");
  return bytes;
}

std::string inflated_blocks(ByteStream& stream, std::size_t longest, const VtkEncoding& encoding) {
  const std::uint64_t count = header_number(stream, encoding);
  if (count > longest)
    throw InvalidArgument("the data end too early");
  const std::uint64_t size = header_number(stream, encoding), last = header_number(stream, encoding);
  std::vector<std::uint64_t> packed_sizes;
  for (std::uint64_t k = 0; k < count; ++k)
    packed_sizes.push_back(header_number(stream, encoding));
  std::string bytes;
  for (std::uint64_t k = 0; k < count; ++k)
    bytes += inflated(stream.take(packed_sizes[k]), k + 1 == count && last > 0 ? last : size);
  return bytes;
}

} // namespace

std::string unpacked(std::string_view packed, bool base64, const VtkEncoding& encoding) {
  ByteStream stream(packed, base64);
  if (encoding.compressor.empty())
    return stream.take(header_number(stream, encoding));
  if (encoding.compressor == "vtkZLibDataCompressor")
    return inflated_blocks(stream, packed.size(), encoding);
  throw InvalidArgument("compressed by " + encoding.compressor +
                        ", which is not read: write the file with vtkZLibDataCompressor, or as text");
}

} // namespace granum::io
