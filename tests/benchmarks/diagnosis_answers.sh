#!/bin/sh
# diagnosis_answers.sh HEFT RECORDINGS ANSWERS [OPTION ...]: diagnoses every recording of a folder, two at a time, and
# keeps what the program HEFT says of it in ANSWERS, one JSON a recording. A recording that cannot be diagnosed has the
# error in its place. Options go to `heft diagnose`.
set -eu
heft=$1 recordings=$2 answers=$3
shift 3
mkdir -p "$answers"
find "$recordings" -maxdepth 1 -name '*.csv' | sort | xargs -P 2 -n 1 sh -c '
  heft=$1 answers=$2
  shift 2
  for last; do :; done
  out=$answers/$(basename "$last" .csv).json
  "$heft" diagnose "$@" --json - >"$out" 2>"$out.error" || printf "{\"error\": \"%s\"}\n" "$(tr -d "\"\n\\" <"$out.error")" >"$out"
  rm -f "$out.error"' diagnose "$heft" "$answers" "$@"
