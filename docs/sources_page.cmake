# SPDX-License-Identifier: GPL-3.0-or-later
include("${CMAKE_CURRENT_LIST_DIR}/../cmake/references.cmake")

# write_sources_page(<bibliography> <path>): a BibTeX file as a page, one entry a key, for the links of docstrings to
# lead to.
function(write_sources_page bibliography path)
  read_bibliography("${bibliography}" "*" "**")
  set(page "# Sources {#sources}\n\nThe keys in square brackets, as in comments. The same list for BibTeX: `validation/references.bib`.\n")
  foreach(key IN LISTS keys)
    string(APPEND page "\n\\anchor ${key} **${key}**: ${text_${key}}")
    if(link_${key})
      string(APPEND page " <${link_${key}}>")
    endif()
    if(remark_${key})
      string(APPEND page " Not checked: ${remark_${key}}.")
    endif()
    string(APPEND page "\n")
  endforeach()
  file(WRITE "${path}" "${page}")
endfunction()
