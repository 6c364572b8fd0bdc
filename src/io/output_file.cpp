// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/output_file.hpp>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <granum/core/error.hpp>

namespace granum::io {

namespace {

namespace fs = std::filesystem;

/// The file that a text goes to before it has its name. It is locked while it is written: one without a lock
/// was left by a run that was killed, and is removed.
class PartFile {
 public:
  explicit PartFile(const fs::path& target)
      : target_(target.string()), name_(target_ + std::string(part_extension)) {
    while (!open_new())
      close();
    struct stat old {};
    const bool replaces = stat(target_.c_str(), &old) == 0 && S_ISREG(old.st_mode);
    if (replaces && fchmod(file_, old.st_mode & 07777) != 0)
      fail(errno);
  }
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;
  ~PartFile() { discard(); }

  void write(std::string_view text) {
    while (!text.empty()) {
      const ssize_t count = ::write(file_, text.data(), text.size());
      if (count < 0 && errno != EINTR)
        fail(errno);
      text.remove_prefix(count < 0 ? 0 : static_cast<std::size_t>(count));
    }
  }

  /// Gives the file its name.
  void finish() {
    if (fsync(file_) != 0 || std::rename(name_.c_str(), target_.c_str()) != 0)
      fail(errno);
    made_ = false;
  }

 private:
  [[noreturn]] void fail(int error) {
    discard();
    throw FileError(target_, 0, std::string("cannot be written: ") + std::strerror(error));
  }

  /// Opens the part and waits for its lock; false if another run has finished it in the meantime, or if it
  /// was a killed run's, which is then removed.
  [[nodiscard]] bool open_new() {
    file_ = open(name_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (file_ < 0)
      fail(errno);
    while (flock(file_, LOCK_EX) != 0 && errno == EINTR) {
    } // file systems without locks do without
    struct stat by_name {
    }, opened{};
    if (lstat(name_.c_str(), &by_name) != 0 || fstat(file_, &opened) != 0 ||
        by_name.st_ino != opened.st_ino || by_name.st_dev != opened.st_dev)
      return false;
    made_ = true;
    return opened.st_size == 0 || unlink(name_.c_str()) != 0;
  }

  void discard() {
    if (made_)
      unlink(name_.c_str());
    made_ = false;
    close();
  }

  void close() {
    if (file_ >= 0)
      ::close(file_);
    file_ = -1;
  }

  std::string target_, name_;
  int file_ = -1;
  bool made_ = false; ///< the file with the part's name is this one
};

} // namespace

bool is_taken(const fs::path& path) {
  std::error_code unknown; // a name that cannot be is told by writing
  return fs::exists(fs::symlink_status(path, unknown));
}

void write_file(const fs::path& path, std::string_view text, Existing existing) {
  if (existing == Existing::keep && is_taken(path))
    throw FileError(path.string(), 0, "exists already and is kept; --force replaces it");
  PartFile part(path);
  part.write(text);
  part.finish();
}

} // namespace granum::io
