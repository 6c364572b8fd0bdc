// SPDX-License-Identifier: GPL-3.0-or-later
// Loaded before the program's libraries (LD_PRELOAD), lets one call of the system fail, as a disk with a
// fault does: of the calls of the kind GRANUM_TEST_CALL that concern files below GRANUM_TEST_FOLDER, number
// GRANUM_TEST_NUMBER (from 0). GRANUM_TEST_FAULT is the error, or "short": the call then does a part of its
// work, which is no error. The path is written to the file GRANUM_TEST_FIRED; of the kind "all" none fails,
// and the kinds are written there.
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

namespace {

template <class Function>
Function* next_of(Function* /*replacement*/, const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

std::string setting(const char* name) {
  const char* text = std::getenv(name);
  return text == nullptr ? "" : text;
}

std::string path_of(int descriptor) {
  char path[4096];
  const auto size = readlink(("/proc/self/fd/" + std::to_string(descriptor)).c_str(), path, sizeof path);
  return {path, size < 0 ? 0 : static_cast<std::size_t>(size)};
}

bool is_short() {
  static const bool chosen = setting("GRANUM_TEST_FAULT") == "short";
  return chosen;
}

/// Adds to the file GRANUM_TEST_FIRED.
void report(const std::string& text) {
  static const auto open_file = next_of<int(const char*, int, ...)>(nullptr, "open");
  static const auto write_file = next_of<ssize_t(int, const void*, std::size_t)>(nullptr, "write");
  static const int file =
      open_file(setting("GRANUM_TEST_FIRED").c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
  if (write_file(file, text.data(), text.size()) < 0)
    std::abort();
}

/// Whether this is the call that fails; errno is then set.
bool fails(const char* call, const std::string& path) {
  static const std::string kind = setting("GRANUM_TEST_CALL"), folder = setting("GRANUM_TEST_FOLDER"),
                           fault = setting("GRANUM_TEST_FAULT");
  static int left = std::atoi(setting("GRANUM_TEST_NUMBER").c_str());
  if ((kind != call && kind != "all") || path.rfind(folder, 0) != 0)
    return false;
  if (kind == "all") {
    report(std::string(call) + "\n");
    return false;
  }
  if (left-- != 0)
    return false;
  report(path);
  errno = fault == "ENOSPC" ? ENOSPC : fault == "EINTR" ? EINTR : EIO;
  return true;
}

bool fails(const char* call, int descriptor) { return fails(call, path_of(descriptor)); }

} // namespace

#define GRANUM_REPLACED extern "C" __attribute__((visibility("default")))
/// A call with nothing but its error.
#define GRANUM_FAILING(kind, result, name, parameters, arguments, subject, failed)                           \
  GRANUM_REPLACED result name parameters {                                                                   \
    static const auto real = next_of(&name, #name);                                                          \
    return fails(kind, subject) ? failed : real arguments;                                                   \
  }
/// A call that moves bytes; half of them if it is short.
#define GRANUM_MOVING(kind, name, parameters, arguments, size)                                               \
  GRANUM_REPLACED ssize_t name parameters {                                                                  \
    static const auto real = next_of(&name, #name);                                                          \
    if (fails(kind, descriptor)) {                                                                           \
      if (!is_short())                                                                                       \
        return -1;                                                                                           \
      size = size > 1 ? size / 2 : size;                                                                     \
    }                                                                                                        \
    return real arguments;                                                                                   \
  }
#define GRANUM_OPENING(name)                                                                                 \
  GRANUM_REPLACED int name(const char* path, int flags, ...) {                                               \
    static const auto real = next_of(&name, #name);                                                          \
    std::va_list more;                                                                                       \
    va_start(more, flags);                                                                                   \
    const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(more, mode_t) : 0;                                   \
    va_end(more);                                                                                            \
    return fails("open", path) ? -1 : real(path, flags, mode);                                               \
  }

GRANUM_OPENING(open)
GRANUM_FAILING("open", FILE*, fopen64, (const char* path, const char* mode), (path, mode), path, nullptr)
GRANUM_FAILING("list", DIR*, fdopendir, (int descriptor), (descriptor), descriptor, nullptr)
GRANUM_FAILING("list", dirent*, readdir, (DIR * folder), (folder), dirfd(folder), nullptr)
GRANUM_MOVING("read", read, (int descriptor, void* to, std::size_t size), (descriptor, to, size), size)
GRANUM_MOVING("write", write, (int descriptor, const void* from, std::size_t size), (descriptor, from, size),
              size)
GRANUM_MOVING("write", writev, (int descriptor, const iovec* from, int size), (descriptor, from, size), size)
GRANUM_FAILING("lock", int, flock, (int descriptor, int operation), (descriptor, operation), descriptor, -1)
GRANUM_FAILING("mode", int, fchmod, (int descriptor, mode_t mode), (descriptor, mode), descriptor, -1)
GRANUM_FAILING("rename", int, rename, (const char* from, const char* to), (from, to), from, -1)
GRANUM_FAILING("remove", int, unlink, (const char* path), (path), path, -1)
GRANUM_FAILING("remove", int, remove, (const char* path), (path), path, -1)
GRANUM_FAILING("folder", int, mkdir, (const char* path, mode_t mode), (path, mode), path, -1)
GRANUM_FAILING("access", int, access, (const char* path, int mode), (path, mode), path, -1)
GRANUM_FAILING("stat", int, stat, (const char* path, struct stat* about), (path, about), path, -1)
GRANUM_FAILING("stat", int, lstat, (const char* path, struct stat* about), (path, about), path, -1)
GRANUM_FAILING("stat", int, fstat, (int descriptor, struct stat* about), (descriptor, about), descriptor, -1)
GRANUM_FAILING("stat", int, fstat64, (int descriptor, struct stat64* about), (descriptor, about), descriptor,
               -1)
GRANUM_FAILING("seek", off64_t, lseek64, (int descriptor, off64_t to, int from), (descriptor, to, from),
               descriptor, -1)

/// Nothing is flushed: it takes long, and no run depends on it.
GRANUM_REPLACED int fsync(int descriptor) { return fails("sync", descriptor) ? -1 : 0; }

GRANUM_REPLACED int close(int descriptor) {
  static const auto real = next_of(&close, "close");
  const bool failed = fails("close", descriptor);
  const int error = errno;
  const int result = real(descriptor);
  if (!failed)
    return result;
  errno = error;
  return -1;
}
