# A header as Doxygen is to see it. What it says of itself stands before its namespace; Doxygen would
# put that, from all headers, at the namespace, so the blank line before gets the command \file. The
# namespace itself, which all names share, is left out. Lines keep their numbers.
{ lines[NR] = $0 }
/^namespace isomatch \{/ {
  lines[NR] = ""
  first = NR - 1
  while (lines[first] ~ /^\/\/\//) --first
  if (first < NR - 1) lines[first] = "/// \\file"
}
/^\}  \/\/ namespace isomatch$/ { lines[NR] = "" }
END { for (i = 1; i <= NR; ++i) print lines[i] }
