# SPDX-License-Identifier: GPL-3.0-or-later
# Docstrings as doxygen reads them: headings of their own, angle brackets as they stand, and keys of sources that lead to
# their entry on the page of sources.
# What stands before the namespace is about the file; the namespace's own sentence stands in docs/architecture.md.
/^\/\/\/ \\file\n/ {
  P
  D
}
1,/^namespace/ {
  /^$/ {
    N
    s/^\n\/\/\//\n\/\/\/ \\file\n\/\/\//
    P
    D
  }
}
/\/\/\// {
  s/^( *\/\/\/ )Assumes  +/\1\\assumes /
  s/^( *\/\/\/ )Accuracy  +/\1\\accuracy /
  s/^( *\/\/\/ )Checked by /\1\\checked /
  s/\/\/\/</\/\/\/\x01/
  s/(\/\/\/.*)$/\n\1/
  h
  s/^.*\n//
  s/</\&lt;/g
  s/>/\&gt;/g
  s/([[; ])([A-Z][A-Za-z]+[12][0-9]{3}[a-z]?)([],;])/\1\\ref \2 "\2"\3/g
  x
  s/\n.*$//
  G
  s/\n//
  s/\x01/</
}
