// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/output_file.hpp>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>
#include <system_error>

#include <unistd.h>

#include <granum/core/error.hpp>

namespace granum::io {

namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::filesystem::path& temporary, int error) {
  std::error_code ignored;
  std::filesystem::remove(temporary, ignored);
  throw FileError(path.string(), 0, std::string("cannot be written: ") + std::strerror(error));
}

} // namespace

void write_file(const std::filesystem::path& path, std::string_view text, Existing existing) {
  if (existing == Existing::keep && std::filesystem::exists(path))
    throw FileError(path.string(), 0, "exists already and is kept; --force replaces it");
  std::filesystem::path temporary = path;
  temporary += ".part" + std::to_string(getpid());
  std::FILE* file = std::fopen(temporary.c_str(), "wb");
  if (file == nullptr)
    fail(path, temporary, errno);
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size() &&
                       std::fflush(file) == 0 && fsync(fileno(file)) == 0;
  const int write_error = errno;
  const bool closed = std::fclose(file) == 0;
  if (!written || !closed)
    fail(path, temporary, written ? errno : write_error);
  if (std::rename(temporary.c_str(), path.c_str()) != 0)
    fail(path, temporary, errno);
}

} // namespace granum::io
