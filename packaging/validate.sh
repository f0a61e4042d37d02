#!/bin/sh
# Checks what an installed Heft shows to the system, each part by its own validator: desktop entry, AppStream metadata, MIME
# type, icon, manual pages, completion. Run by check.sh.
#   sh packaging/validate.sh PREFIX     where `cmake --install` put Heft
set -eu
prefix=$1
share=$prefix/share
id=org.heft.HeftStudio
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failed=0

# check WHAT COMMAND...: its output is shown only if it fails.
check() {
  what=$1
  shift
  if "$@" >"$scratch/log" 2>&1; then
    echo "   $what: good"
  else
    echo "   $what: $*" >&2
    cat "$scratch/log" >&2
    failed=1
  fi
}

manuals() {
  count=0
  for page in "$share"/man/man1/*.1.gz; do
    zcat "$page" >"$scratch/page" || return 1
    said=$(groff -man -ww -Tutf8 -z "$scratch/page" 2>&1)
    [ -z "$said" ] || { echo "$said"; return 1; }
    count=$((count + 1))
  done
  [ "$count" -gt 5 ] || { echo "only $count pages"; return 1; }
}

# The first word must complete to every command that has a manual page, and an option's name to the option.
completion() {
  bash -eu -c '
    source "$1/bash-completion/completions/heft"
    COMP_WORDS=(heft ""); COMP_CWORD=1; _heft
    for page in "$1"/man/man1/heft-*.1.gz; do
      command=${page##*/heft-}; command=${command%.1.gz}
      [ "$command" = studio ] || [[ " ${COMPREPLY[*]} " == *" $command "* ]] || { echo "$command is not completed"; exit 1; }
    done
    COMP_WORDS=(heft estimate --shape-f); COMP_CWORD=2; _heft
    [ "${COMPREPLY[*]}" = --shape-file ] || { echo "--shape-f gives: ${COMPREPLY[*]}"; exit 1; }
  ' completion "$share"
}

mime() {
  mkdir -p "$scratch/mime/packages"
  cp "$share/mime/packages/$id.xml" "$scratch/mime/packages"
  xmllint --noout "$share/mime/packages/$id.xml" || return 1
  said=$(update-mime-database -V "$scratch/mime" 2>&1 | grep -i 'error\|warning\|unknown' || true)
  [ -z "$said" ] || { echo "$said"; return 1; }
  grep -q 'application/x-heft-session:\*\.heft' "$scratch/mime/globs" || { echo "*.heft is not a session"; return 1; }
}

echo "== Desktop files, manual pages and completion in $prefix"
check "manual pages" manuals
check "completion" completion
if [ -e "$prefix/bin/heft-studio" ]; then
  check "desktop entry" desktop-file-validate "$share/applications/$id.desktop"
  check "AppStream metadata" appstreamcli validate --no-net "$share/metainfo/$id.metainfo.xml"
  check "MIME type" mime
  check "icon" xmllint --noout "$share/icons/hicolor/scalable/apps/$id.svg"
fi
exit "$failed"
