# SPDX-License-Identifier: GPL-3.0-or-later
# Formulas between dollars and in blocks of math, which Markdown readers know, as doxygen writes them; and keys of sources
# that lead to their entry.
/^```math$/,/^```$/ {
  s/^```math$/\\f[/
  s/^```$/\\f]/
  b
}
/^ *```/,/^ *```$/ b
s/\$([^$`]+)\$/\\f$\1\\f$/g
s/([[; ])([A-Z][A-Za-z]+[12][0-9]{3}[a-z]?)([],;])/\1\\ref \2 "\2"\3/g
