// SPDX-License-Identifier: GPL-3.0-or-later
// What takes the place of throwing where nothing can be caught: the page is told the message, and throws its
// own error through the frames of this module, which it then drops for a fresh one. All that granum and its
// libraries throw is a std::exception by its first base, so that it begins where the thrown object does.
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
