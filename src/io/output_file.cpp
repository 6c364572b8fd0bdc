// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/output_file.hpp>

#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <granum/core/error.hpp>

namespace granum::io {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void cannot_be_written(const fs::path& path, const std::string& why) {
  throw FileError(path.string(), 0, "cannot be written: " + why);
}

/// A file that is open for writing, and closed with this object.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() {
    if (number_ >= 0)
      close(number_);
  }

  [[nodiscard]] int number() const { return number_; }

  /// The error, or 0.
  [[nodiscard]] int write(std::string_view text) const {
    while (!text.empty()) {
      const ssize_t count = ::write(number_, text.data(), text.size());
      if (count < 0 && errno != EINTR)
        return errno;
      text.remove_prefix(count < 0 ? 0 : static_cast<std::size_t>(count));
    }
    return 0;
  }

 private:
  int number_;
};

std::optional<int> number_of(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

/// The number of this process's own descriptor that a path leads to, as /dev/stdout and the shell's >(...)
/// do.
std::optional<int> own_descriptor(fs::path path) {
  constexpr int most_links = 40;
  std::error_code error;
  const fs::path descriptors = fs::canonical("/dev/fd", error);
  for (int links = 0; links < most_links && !error; ++links) {
    const fs::path folder = fs::canonical(path.has_parent_path() ? path.parent_path() : ".", error);
    if (!error && folder == descriptors)
      return number_of(path.filename().string());
    path = folder / fs::read_symlink(path, error);
  }
  return {};
}

/// Whether writing cannot destroy a result: a device such as a terminal, a pipe, or a descriptor of this
/// process.
bool is_stream(const fs::path& path) {
  std::error_code unknown; // impossible names are reported on writing
  const fs::file_type type = fs::status(path, unknown).type();
  return type == fs::file_type::character || type == fs::file_type::fifo || own_descriptor(path);
}

/// A pipe gets a moment for its reader to come: in `cat pipe & granum ...` both begin together.
Descriptor opened_stream(const fs::path& path) {
  if (const std::optional<int> own = own_descriptor(path))
    return Descriptor(fcntl(*own, F_DUPFD_CLOEXEC, 0));
  constexpr std::chrono::milliseconds pause{10};
  for (int tries = 100;; --tries) {
    Descriptor file(open(path.c_str(), O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
    if (file.number() >= 0)
      fcntl(file.number(), F_SETFL, 0); // from here on it waits for its reader
    if (file.number() >= 0 || errno != ENXIO || tries == 0)
      return file;
    std::this_thread::sleep_for(pause);
  }
}

void write_stream(const fs::path& path, std::string_view text) {
  const Descriptor file = opened_stream(path);
  const int error = file.number() < 0 ? errno : file.write(text);
  if (error == ENXIO)
    cannot_be_written(path, "it is a pipe that nobody reads from");
  if (error != 0)
    cannot_be_written(path, std::strerror(error));
}

/// \throws   FileError if the existing file cannot or must not be replaced
void require_place(const fs::path& path, Existing existing) {
  std::error_code unknown;
  const fs::file_type type = fs::status(path, unknown).type();
  if (type == fs::file_type::directory)
    cannot_be_written(path, "it is a folder");
  if (type == fs::file_type::block || type == fs::file_type::socket)
    cannot_be_written(path, "it is a disk or a socket, no file");
  if (existing == Existing::keep && is_taken(path))
    throw FileError(path.string(), 0, "exists already and is kept; --force replaces it");
}

/// The name of the part of a file: no longer than names can be in its folder. Files that share it wait for
/// each other.
std::string part_name(const fs::path& target) {
  const fs::path folder = target.has_parent_path() ? target.parent_path() : ".";
  const long longest = pathconf(folder.c_str(), _PC_NAME_MAX);
  std::string name = target.filename().string();
  if (longest > 0 && name.size() + part_extension.size() > static_cast<std::size_t>(longest)) {
    std::size_t kept = static_cast<std::size_t>(longest) - part_extension.size();
    while (kept > 0 && (static_cast<unsigned char>(name[kept]) & 0xC0) == 0x80) // within a character of UTF-8
      --kept;
    name.resize(kept);
  }
  return (target.parent_path() / (name + std::string(part_extension))).string();
}

/// The temporary file of a text. It is locked while it is written: one without a lock
/// was left by a run that was killed, and is removed.
class PartFile {
 public:
  explicit PartFile(const fs::path& target) : target_(target.string()), name_(part_name(target)) {
    while (!open_new()) {
    }
    struct stat old {};
    const bool replaces = stat(target_.c_str(), &old) == 0 && S_ISREG(old.st_mode);
    if (replaces && fchmod(file_.number(), old.st_mode & 07777) != 0)
      fail(errno);
  }
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;
  ~PartFile() { discard(); }

  void write(std::string_view text) {
    if (const int error = file_.write(text))
      fail(error);
  }

  /// Gives the file its name.
  void finish() {
    if (fsync(file_.number()) != 0 || std::rename(name_.c_str(), target_.c_str()) != 0)
      fail(errno);
    made_ = false;
  }

 private:
  [[noreturn]] void fail(int error) {
    discard();
    cannot_be_written(target_, std::strerror(error));
  }

  /// Makes the part and waits for its lock; false if another run took it in the meantime, or if it was there
  /// before: another run has finished it then, or it was a killed run's, which is removed.
  [[nodiscard]] bool open_new() {
    constexpr int flags = O_WRONLY | O_CLOEXEC | O_NOFOLLOW;
    struct stat by_name {
    }, opened{};
    file_ = Descriptor(open(name_.c_str(), flags | O_CREAT | O_EXCL, 0666));
    const bool is_new = file_.number() >= 0;
    if (!is_new) {
      if (errno != EEXIST)
        fail(errno);
      if (lstat(name_.c_str(), &by_name) == 0 && !S_ISREG(by_name.st_mode))
        throw FileError(name_, 0, "exists and is not a regular file; remove it");
      file_ = Descriptor(open(name_.c_str(), flags | O_NONBLOCK));
      if (file_.number() < 0 && errno != ENOENT)
        cannot_be_written(name_, std::strerror(errno));
    }
    while (flock(file_.number(), LOCK_EX) != 0 && errno == EINTR) {
    } // file systems without locks do without
    if (lstat(name_.c_str(), &by_name) != 0 || fstat(file_.number(), &opened) != 0 ||
        by_name.st_ino != opened.st_ino || by_name.st_dev != opened.st_dev)
      return false;
    if (!is_new && unlink(name_.c_str()) != 0 && errno != ENOENT)
      cannot_be_written(name_, std::strerror(errno));
    made_ = is_new;
    return is_new;
  }

  void discard() {
    if (made_)
      unlink(name_.c_str());
    made_ = false;
    file_ = Descriptor();
  }

  std::string target_, name_;
  Descriptor file_;
  bool made_ = false; ///< the file with the part's name is this one
};

} // namespace

bool is_taken(const fs::path& path) {
  std::error_code unknown; // impossible names are reported on writing
  return fs::exists(fs::symlink_status(path, unknown)) && !is_stream(path);
}

bool is_one_file(const fs::path& a, const fs::path& b) {
  const auto place = [](const fs::path& path) {
    std::error_code unknown;
    return fs::weakly_canonical(fs::absolute(path, unknown).parent_path(), unknown) / path.filename();
  };
  return a == b || place(a) == place(b);
}

void write_file(const fs::path& path, std::string_view text, Existing existing) {
  if (is_stream(path))
    return write_stream(path, text);
  require_place(path, existing);
  PartFile part(path);
  part.write(text);
  part.finish();
}

} // namespace granum::io
