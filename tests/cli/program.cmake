# SPDX-License-Identifier: GPL-3.0-or-later
granum_cli_test("version" EXIT 0 STDOUT "^granum ${PROJECT_VERSION} \\(.+\\)\n$" ARGS --version)
granum_cli_test("help" EXIT 0 STDOUT "Exit codes: 0 ok" ARGS --help)
granum_cli_test("help of a subcommand" EXIT 0 STDOUT "atmospheric-pressure PRESSURE" ARGS fit --help)
granum_cli_test("no subcommand" EXIT 2 STDERR "^granum: error: .*subcommand.*\n  estimate .*\n  export " ARGS)
granum_cli_test("unknown subcommand" EXIT 2 STDERR "^granum: error: .*fitt" ARGS fitt)

add_test(NAME "cli: exit codes of every command and event"
  COMMAND "${CMAKE_CURRENT_SOURCE_DIR}/check_exit_codes.sh" "$<TARGET_FILE:granum_cli>"
    "${CMAKE_CURRENT_SOURCE_DIR}/exit_codes.txt" "${CMAKE_CURRENT_SOURCE_DIR}/data" "${CMAKE_CURRENT_BINARY_DIR}/exit codes")
set_tests_properties("cli: exit codes of every command and event" PROPERTIES LABELS cli TIMEOUT 1200)
