// SPDX-License-Identifier: GPL-3.0-or-later
// File: header, subject, scene, state. The checksum covers the header's sizes and all that follows it.
#include <granum/io/checkpoint/checkpoint.hpp>

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>

#include <zlib.h>

#include <granum/core/bytes.hpp>
#include <granum/io/output_file.hpp>
#include <granum/io/text/source.hpp>

namespace granum::io {

namespace {

constexpr std::array<char, 8> magic{'g', 'r', 'a', 'n', 'u', 'm', 'C', 'K'};
constexpr std::uint32_t byte_order = 0x01020304;

struct Header {
  std::array<char, 8> magic;
  std::uint32_t version;
  std::uint32_t byte_order;
  std::uint64_t subject_size;
  std::uint64_t scene_size;
  std::uint64_t state_size;
  std::uint64_t checksum;
};

std::uint64_t checksum_of(const Header& header, std::string_view body) {
  uLong sum = crc32_z(0, nullptr, 0);
  const auto add = [&](const void* data, std::size_t size) {
    sum = crc32_z(sum, static_cast<const Bytef*>(data), size);
  };
  add(&header.subject_size, sizeof header.subject_size);
  add(&header.scene_size, sizeof header.scene_size);
  add(&header.state_size, sizeof header.state_size);
  add(body.data(), body.size());
  return sum;
}

std::string contents(const std::filesystem::path& path) {
  std::error_code unknown; // a file that cannot be found is reported on reading
  if (std::filesystem::status(path, unknown).type() == std::filesystem::file_type::fifo)
    throw FileError(path.string(), 0, "cannot be read: it is a pipe"); // which would wait for its writer
  return file_content(path);
}

} // namespace

void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint) {
  const std::string body = checkpoint.subject + checkpoint.scene + checkpoint.state;
  Header header{.magic = magic,
                .version = checkpoint_version,
                .byte_order = byte_order,
                .subject_size = checkpoint.subject.size(),
                .scene_size = checkpoint.scene.size(),
                .state_size = checkpoint.state.size(),
                .checksum = 0};
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
  const std::uint64_t behind_subject =
      body.size() - std::min<std::uint64_t>(header.subject_size, body.size());
  if (header.subject_size > body.size() || header.scene_size > behind_subject ||
      header.state_size != behind_subject - header.scene_size)
    reader.fail("is a checkpoint of the wrong length: " + std::to_string(body.size()) +
                " bytes in place of " + std::to_string(header.subject_size) + ", " +
                std::to_string(header.scene_size) + " and " + std::to_string(header.state_size));
  if (header.checksum != checksum_of(header, body))
    reader.fail("is a damaged checkpoint: its checksum does not match");
  return {.subject = std::string(body.substr(0, header.subject_size)),
          .scene = std::string(body.substr(header.subject_size, header.scene_size)),
          .state = std::string(body.substr(header.subject_size + header.scene_size))};
}

} // namespace granum::io
