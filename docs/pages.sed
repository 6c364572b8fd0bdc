# SPDX-License-Identifier: GPL-3.0-or-later
# Formulas between dollars and in blocks of math, which Markdown readers know, as doxygen writes them.
/^```math$/,/^```$/ {
  s/^```math$/\\f[/
  s/^```$/\\f]/
  b
}
/^```/,/^```$/ b
s/\$([^$`]+)\$/\\f$\1\\f$/g
