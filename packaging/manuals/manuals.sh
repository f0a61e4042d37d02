#!/bin/sh
# Manual pages and bash completion from what the programs themselves print for --help, so that they cannot fall behind.
#   manuals.sh OUT HEFT [HEFT_STUDIO]
# writes OUT/man1/NAME.1.gz for heft, each of its commands and heft-studio, and OUT/completions/NAME.
set -eu
here=$(dirname "$0")
out=$1 heft=$2 studio=${3:-}
mkdir -p "$out/man1" "$out/completions"
rm -f "$out"/man1/* "$out"/completions/*

version=$("$heft" --version | head -n 1)
help=$("$heft" --help)
commands=$(printf '%s\n' "$help" | awk '/^[^ ]/ { inside = /^(Subcommands|Commands):/ } inside && /^  [a-z]/ { print $1 }')
if [ -z "$commands" ]; then
  echo "manuals.sh: '$heft --help' lists no commands" >&2
  exit 1
fi

# page NAME SEE_ALSO PROGRAM [COMMAND]
page() {
  name=$1 also=$2
  shift 2
  text=$("$@" --help)
  if ! printf '%s\n' "$text" |
       awk -v page="$name" -v version="$version" -v seealso="$also" -f "$here/manual.awk" >"$out/man1/$name.1"; then
    echo "manuals.sh: what '$* --help' prints has no line 'Usage:'" >&2
    exit 1
  fi
}

# Lines "option kind" from a help on stdin; kind is "-" (takes nothing), "file", "value", or the words to choose from.
options() {
  awk '/^ +-/ {
    row = $0
    sub(/^ +/, "", row)
    split(row, columns, /  +/)
    count = split(columns[1], words, " ")
    kind = "-"
    if (count > 1 && words[2] != "REQUIRED") {
      kind = "value"
      if (words[2] ~ /FILE/ || columns[2] ~ /^(Picture to write|Commands to carry out)/) kind = "file"
      if (match(words[2], /\{[^}]*\}/)) {
        kind = substr(words[2], RSTART + 1, RLENGTH - 2)
        gsub(/,/, " ", kind)
      }
    }
    names = split(words[1], name, ",")
    for (i = 1; i <= names; i++) print name[i], kind
  }'
}

# The branches of a case that completes the words of one command; its help on stdin.
branches() {
  options | awk '
    { all = all (all == "" ? "" : " ") $1; kind = $0; sub(/^[^ ]+ /, "", kind) }
    kind == "-" { next }
    { names[kind] = names[kind] (names[kind] == "" ? "" : "|") $1 }
    END {
      for (kind in names) {
        reply = kind == "file" ? "_heft_files" : kind == "value" ? "return" : "_heft_words \"" kind "\""
        print "      " names[kind] ") " reply " ;;" | "sort"
      }
      close("sort")
      print "      *) _heft_options \"" all "\" ;;"
    }'
}

# The functions are the same in both files: bash-completion loads a file only when its program is completed.
common() {
  cat <<'END'
_heft_reply() { mapfile -t COMPREPLY <<<"$1"; [[ $1 ]] || COMPREPLY=(); }
_heft_words() { _heft_reply "$(compgen -W "$1" -- "$current")"; }
_heft_files() { compopt -o filenames 2>/dev/null; _heft_reply "$(compgen -f -- "$current")"; }
_heft_options() { if [[ $current == -* ]]; then _heft_words "$1"; else _heft_files; fi; }
END
}

also=
for command in $commands; do also="$also heft-$command"; done
[ -z "$studio" ] || also="$also heft-studio"
page heft "${also# }" "$heft"
for command in $commands; do page "heft-$command" heft "$heft" "$command"; done
{
  echo "# bash completion for heft, made from its --help"
  common
  echo '_heft() {'
  echo '  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]}'
  echo '  COMPREPLY=()'
  echo '  if ((COMP_CWORD == 1)); then'
  echo "    _heft_words \"$(echo $commands) $(printf '%s\n' "$help" | options | awk '{ printf "%s ", $1 }')\""
  echo '    return'
  echo '  fi'
  echo '  case ${COMP_WORDS[1]} in'
  for command in $commands; do
    echo "  $command)"
    echo '    case $previous in'
    "$heft" "$command" --help | branches
    echo '    esac'
    echo '    ;;'
  done
  echo '  esac'
  echo '}'
  echo 'complete -F _heft heft'
} >"$out/completions/heft"

if [ -n "$studio" ]; then
  page heft-studio heft "$studio"
  {
    echo "# bash completion for heft-studio, made from its --help"
    common
    echo '_heft_studio() {'
    echo '  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]}'
    echo '  COMPREPLY=()'
    echo '    case $previous in'
    "$studio" --help | branches
    echo '    esac'
    echo '}'
    echo 'complete -F _heft_studio heft-studio'
  } >"$out/completions/heft-studio"
fi

# Debian wants them so; -n: the same bytes from the same text.
gzip -9n "$out"/man1/*.1
