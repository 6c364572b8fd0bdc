// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces throwing where exceptions cannot be caught: the page receives the message, and throws its own
// error through the frames of this module, which is then replaced by a new instance. Everything thrown by
// granum and its libraries has std::exception as its first base, which therefore begins at the address of the
// thrown object.
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <exception>

extern "C" {

[[noreturn]] __attribute__((import_module("page"), import_name("thrown"))) void
page_thrown(const char* text, std::size_t length);

void* __cxa_allocate_exception(std::size_t size) noexcept { return std::malloc(size); }
void __cxa_free_exception(void* thrown) noexcept { std::free(thrown); }
[[noreturn]] void __cxa_throw(void* thrown, void* /*type*/, void (* /*destructor*/)(void*)) {
  const char* const text = static_cast<const std::exception*>(thrown)->what();
  page_thrown(text, std::strlen(text));
}
}
