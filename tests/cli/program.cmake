# SPDX-License-Identifier: GPL-3.0-or-later
granum_cli_test("version" EXIT 0 STDOUT "^granum ${PROJECT_VERSION} \\(.+\\)\n$" ARGS --version)
granum_cli_test("help" EXIT 0 STDOUT "Exit codes: 0 ok" ARGS --help)
granum_cli_test("help of a subcommand" EXIT 0 STDOUT "atmospheric-pressure PRESSURE" ARGS fit --help)
granum_cli_test("no subcommand" EXIT 2 STDERR "^granum: error: .*subcommand.*\n  estimate .*\n  export " ARGS)
granum_cli_test("unknown subcommand" EXIT 2 STDERR "^granum: error: .*fitt" ARGS fitt)

add_test(NAME "cli: standard streams that are closed, full or broken"
  COMMAND "${CMAKE_CURRENT_SOURCE_DIR}/check_streams.sh" "$<TARGET_FILE:granum_cli>" "${CMAKE_CURRENT_BINARY_DIR}/streams")
set_tests_properties("cli: standard streams that are closed, full or broken" PROPERTIES LABELS cli)

# Calls of the system that fail, one after the other. Not under sanitizers, whose libraries must be loaded first.
granum_preloaded(fail_at_call)
# granum_faults_test(<name> <label> <most calls of a kind> [studies])
function(granum_faults_test name label)
  add_test(NAME "cli: ${name}"
    COMMAND "${CMAKE_CURRENT_SOURCE_DIR}/check_faults.sh" "$<TARGET_FILE:granum_cli>" "$<TARGET_FILE:granum_fail_at_call>"
      "${CMAKE_CURRENT_SOURCE_DIR}/data" "${CMAKE_CURRENT_BINARY_DIR}/${name}" ${ARGN})
  set_tests_properties("cli: ${name}" PROPERTIES LABELS ${label} TIMEOUT 7200)
endfunction()
granum_faults_test("disk faults" cli 3)
granum_faults_test("disk faults, each call" slow 100)
granum_faults_test("disk faults of studies" slow 25 studies)

add_test(NAME "cli: exit codes of every command and event"
  COMMAND "${CMAKE_CURRENT_SOURCE_DIR}/check_exit_codes.sh" "$<TARGET_FILE:granum_cli>"
    "${CMAKE_CURRENT_SOURCE_DIR}/exit_codes.txt" "${CMAKE_CURRENT_SOURCE_DIR}/data" "${CMAKE_CURRENT_BINARY_DIR}/exit codes")
set_tests_properties("cli: exit codes of every command and event" PROPERTIES LABELS cli TIMEOUT 1200)
