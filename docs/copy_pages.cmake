# SPDX-License-Identifier: GPL-3.0-or-later

# link_for_html(<variable> <text> <target> <path> <folder> <html>): what becomes of the link or picture (<text> begins with !
# then) of the page at <path>, relative to <root>. Pictures are copied beside the HTML, each in its own folder, because
# doxygen puts all of them in one, where some have the same name. Files that are no pages are named without a link.
function(link_for_html variable text target path root html)
  get_filename_component(folder "${path}" DIRECTORY)
  string(REGEX REPLACE "^!?\\[(.*)\\]$" "\\1" words "${text}")
  if(text MATCHES "^!")
    file(COPY "${root}/${folder}/${target}" DESTINATION "${html}/${folder}")
    set(link "<img src=\"${folder}/${target}\" alt=\"${words}\"/>")
  elseif(target MATCHES "^(https?:|#)|\\.md(#.*)?$")
    set(link "${text}(${target})")
  else()
    set(link "${words}")
  endif()
  set(${variable} "${link}" PARENT_SCOPE)
endfunction()

# copy_pages(<root> <to> <html> <path>...): Markdown files of <root>, for doxygen to read them in <to>.
function(copy_pages root to html)
  foreach(path IN LISTS ARGN)
    file(READ "${root}/${path}" rest)
    set(page "")
    if(NOT rest MATCHES "^#") # a table of numbers alone
      get_filename_component(stem "${path}" NAME_WE)
      string(REPLACE "_" " " stem "${stem}")
      set(page "# Benchmark: ${stem}\n\n")
    endif()
    while(rest MATCHES "(!?\\[[^]\n]*\\])\\(([^) \n]+)\\)")
      set(text "${CMAKE_MATCH_1}")
      set(target "${CMAKE_MATCH_2}")
      string(LENGTH "${CMAKE_MATCH_0}" length)
      string(FIND "${rest}" "${CMAKE_MATCH_0}" at)
      string(SUBSTRING "${rest}" 0 ${at} before)
      math(EXPR after "${at} + ${length}")
      string(SUBSTRING "${rest}" ${after} -1 rest)
      link_for_html(link "${text}" "${target}" "${path}" "${root}" "${html}")
      string(APPEND page "${before}${link}")
    endwhile()
    file(WRITE "${to}/${path}" "${page}${rest}")
  endforeach()
endfunction()
