// SPDX-License-Identifier: GPL-3.0-or-later
// Loaded before the program's libraries (LD_PRELOAD), kills it at a given moment of its writing, whatever its
// speed. Files appear by rename(2); GRANUM_TEST_MOMENT=2k kills before the (k+1)-th of them, 2k + 1 after it.
#include <atomic>
#include <csignal>
#include <cstdlib>

#include <dlfcn.h>
#include <unistd.h>

extern "C" __attribute__((visibility("default"))) int rename(const char* from, const char* to) {
  static const char* const text = std::getenv("GRANUM_TEST_MOMENT");
  static const long moment = text == nullptr ? -1 : std::atol(text);
  static std::atomic<long> renames = 0;
  using Rename = int (*)(const char*, const char*);
  static const Rename real = reinterpret_cast<Rename>(dlsym(RTLD_NEXT, "rename"));
  const long before = 2 * renames++;
  if (before == moment)
    kill(getpid(), SIGKILL);
  const int result = real(from, to);
  if (before + 1 == moment)
    kill(getpid(), SIGKILL);
  return result;
}
