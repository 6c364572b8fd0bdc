// SPDX-License-Identifier: GPL-3.0-or-later
// File: header, scene, state. The checksum covers the header's sizes, the scene and the state.
#include <granum/io/checkpoint.hpp>

#include <array>
#include <fstream>
#include <sstream>
#include <string_view>

#include <zlib.h>

#include <granum/core/bytes.hpp>
#include <granum/io/output_file.hpp>

namespace granum::io {

namespace {

constexpr std::array<char, 8> magic{'g', 'r', 'a', 'n', 'u', 'm', 'C', 'K'};
constexpr std::uint32_t byte_order = 0x01020304;

struct Header {
  std::array<char, 8> magic;
  std::uint32_t version;
  std::uint32_t byte_order;
  std::uint64_t scene_size;
  std::uint64_t state_size;
  std::uint64_t checksum;
};

std::uint64_t checksum_of(const Header& header, std::string_view body) {
  uLong sum = crc32_z(0, nullptr, 0);
  const auto add = [&](const void* data, std::size_t size) {
    sum = crc32_z(sum, static_cast<const Bytef*>(data), size);
  };
  add(&header.scene_size, sizeof header.scene_size);
  add(&header.state_size, sizeof header.state_size);
  add(body.data(), body.size());
  return sum;
}

std::string contents(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path))
    throw FileError(path.string(), 0, "cannot be opened as a checkpoint");
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return bytes.str();
}

} // namespace

void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint) {
  const std::string body = checkpoint.scene + checkpoint.state;
  Header header{magic, checkpoint_version, byte_order, checkpoint.scene.size(), checkpoint.state.size(), 0};
  header.checksum = checksum_of(header, body);
  ByteWriter writer;
  writer.put(header);
  write_file(path, writer.bytes() + body, Existing::replace);
}

Checkpoint read_checkpoint(const std::filesystem::path& path) {
  const std::string file = contents(path);
  ByteReader reader(file, path.string());
  if (file.compare(0, magic.size(), magic.data(), magic.size()) != 0)
    reader.fail("is not a checkpoint of granum");
  if (file.size() < sizeof(Header))
    reader.fail("is a checkpoint cut short within its header");
  const auto header = reader.get<Header>();
  if (header.byte_order != byte_order)
    reader.fail("is a checkpoint from a machine of another byte order");
  if (header.version != checkpoint_version)
    reader.fail("is a checkpoint of version " + std::to_string(header.version) +
                "; this granum reads version " + std::to_string(checkpoint_version));
  const std::string_view body = std::string_view(file).substr(sizeof(Header));
  if (header.scene_size > body.size() || header.state_size != body.size() - header.scene_size)
    reader.fail("is a checkpoint cut short or run over: " + std::to_string(body.size()) +
                " bytes where it says " + std::to_string(header.scene_size) + " and " +
                std::to_string(header.state_size));
  if (header.checksum != checksum_of(header, body))
    reader.fail("is a damaged checkpoint: its checksum does not match");
  return {std::string(body.substr(0, header.scene_size)), std::string(body.substr(header.scene_size))};
}

} // namespace granum::io
