# Turns what a program prints for --help into a manual page (man(7)). Variables: page, version, seealso (pages of section 1).
#
# The help has the form that CLI11 prints: a description, "Usage: ...", then sections. A line "Title:" begins a section, two
# blanks a row. A row is an entry (term, at least two blanks, explanation), or an example, which is kept as it stands; deeply
# indented lines go on with the entry above.
function escaped(text) {
  gsub(/\\/, "\\e", text)
  gsub(/-/, "\\-", text)
  gsub(/'/, "\\(aq", text)
  return text ~ /^\./ ? "\\&" text : text
}
function leaveExample() {
  if (inExample) print ".EE"
  inExample = 0
}
function section(title) {
  leaveExample()
  print ".SH \"" escaped(toupper(title)) "\""
}
function trimmed(text) {
  gsub(/^ +| +$/, "", text)
  return text
}
function begin(   sentence) {
  sentence = description
  sub(/\.( .*)?$/, "", sentence)
  sub(/^Heft (Studio )?/, "", sentence)
  print ".TH \"" escaped(toupper(page)) "\" 1 \"\" \"" escaped(version) "\" \"Heft\""
  print ".nh\n.ad l\n.SH NAME"
  print page " \\- " escaped(sentence)
  begun = 1
}
!begun && /^Usage:/ {
  begin()
  section("Synopsis")
  usage = trimmed(substr($0, 7))
  print ".B " escaped(usage)
  if (description != "") {
    section("Description")
    print escaped(description)
  }
  next
}
!begun {
  if (trimmed($0) != "") description = description (description == "" ? "" : " ") trimmed($0)
  next
}
/^ *$/ { gap = 1; next }
/^[^ ].*:$/ {
  section(substr($0, 1, length($0) - 1))
  gap = 0
  next
}
/^[^ ]/ {
  leaveExample()
  # A paragraph after the sections belongs to none of them.
  if (gap && !inNotes) { section("Notes"); inNotes = 1 } else if (gap) print ".PP"
  print escaped($0)
  gap = 0
  next
}
/^        +[^ ]/ && !inExample {
  # A line with columns of its own stays a line.
  if (trimmed($0) ~ /  /) print ".br"
  print escaped(trimmed($0))
  next
}
/^ +heft/ {
  if (!inExample) print ".PP\n.EX"
  inExample = 1
  print escaped($0)
  next
}
{
  leaveExample()
  row = trimmed($0)
  explanation = ""
  if (match(row, /  +/)) {
    explanation = substr(row, RSTART + RLENGTH)
    row = substr(row, 1, RSTART - 1)
  }
  print ".TP\n.B " escaped(row)
  if (explanation != "") print escaped(explanation)
}
END {
  if (!begun) exit 1
  leaveExample()
  if (seealso != "") {
    section("See also")
    count = split(seealso, pages, " ")
    for (i = 1; i <= count; i++) print ".BR " escaped(pages[i]) " (1)" (i < count ? "," : "")
  }
}
