# SPDX-License-Identifier: GPL-3.0-or-later
# Manual pages and completion, which the build lets the program make of its own options.
if(TARGET granum_reference)
  set(reference "${PROJECT_BINARY_DIR}/reference")
  find_program(GRANUM_BASH bash)
  find_program(GRANUM_ZSH zsh)
  set(pages --reference "${reference}") # of test_screens.py
  if(GRANUM_BASH)
    add_test(NAME "cli: completion in bash" WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}/data"
      COMMAND "${GRANUM_BASH}" "${CMAKE_CURRENT_SOURCE_DIR}/check_completion.sh" "$<TARGET_FILE:granum_cli>" "${reference}/bash/granum")
    set_tests_properties("cli: completion in bash" PROPERTIES LABELS cli)
  endif()
  if(GRANUM_ZSH)
    add_test(NAME "cli: completion in zsh is read" COMMAND "${GRANUM_ZSH}" -n "${reference}/zsh/_granum")
    set_tests_properties("cli: completion in zsh is read" PROPERTIES LABELS cli)
    add_test(NAME "cli: completion in zsh"
      COMMAND "${GRANUM_ZSH}" "${CMAKE_CURRENT_SOURCE_DIR}/check_completion.zsh" "${reference}/zsh")
    set_tests_properties("cli: completion in zsh" PROPERTIES LABELS cli SKIP_RETURN_CODE 77 TIMEOUT 600)
  endif()
endif()
