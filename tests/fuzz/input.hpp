// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>

#include <sys/mman.h>
#include <unistd.h>

#include <granum/core/error.hpp>

/// What the fuzz targets share. A reader may take an input or refuse it with FileError; anything else is a
/// fault.
namespace granum::fuzz {

/// What is made of an input.
using Target = void (*)(std::string_view input);

inline std::map<std::string, Target>& targets() {
  static std::map<std::string, Target> all;
  return all;
}

/// Each source lists its targets by such constants.
struct Named {
  Named(const std::string& name, Target target) { targets().emplace(name, target); }
};

inline void demand(bool promise) {
  if (!promise)
    std::abort();
}

/// A refusal by an error of this type is an answer too, if it says something.
template <class Refusal, class Action>
void taken_or_refused(const Action& action) {
  try {
    action();
  } catch (const Refusal& error) {
    demand(!std::string_view(error.what()).empty());
  }
}

/// A file that lies in no folder, for readers that take a path.
class MemoryFile {
 public:
  explicit MemoryFile(std::string_view bytes) : descriptor_(memfd_create("fuzz", MFD_CLOEXEC)) {
    demand(descriptor_ >= 0 &&
           write(descriptor_, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()));
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { close(descriptor_); }

  [[nodiscard]] std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

} // namespace granum::fuzz
