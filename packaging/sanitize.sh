#!/bin/sh
# `heft estimate` and `heft diagnose` under sanitizers, on ten recordings of different kinds. Any report ends it. Two builds
# of the command line, which need the Debian packages clang and libclang-rt-dev: address and undefined behaviour together,
# which reads the corpora of all parsers, too, and is the tree of packaging/fuzz.sh; threads alone.
#   sh packaging/sanitize.sh [address|thread]     both unless one is named
# HEFT_UNTIL (seconds since 1970): what would begin later is left out, and said.
set -eu
cd "$(dirname "$0")/.."
if ! command -v clang++ >/dev/null; then
  echo "clang++ is missing: install the packages clang and libclang-rt-dev." >&2
  exit 1
fi
mkdir -p build
jobs=${JOBS:-$(nproc)}

recordings() {  # heft, folder: the ten, made once
  heft=$1
  at=$2
  make() { name=$1; shift; "$heft" simulate "$@" --duration 6 --rate 250 -o "$at/$name.csv" --force >/dev/null; }
  make excitation --motion excitation --seed 1
  make free --motion free --seed 2 --joint-noise 1e-5
  make coarse --motion free --seed 3 --joint-step 1e-4
  make contact --motion pick-and-place --seed 4
  make late --motion free --seed 5 --effect time_offset=-8
  make cable --motion free --seed 6 --effect cable_pull=3
  awk -F, 'NR == 1 || NR % 4 == 2' "$at/free.csv" >"$at/slow.csv"
  awk 'NR == 1 || NR < 40' "$at/free.csv" >"$at/few.csv"
  awk -F, -v OFS=, 'NR > 1 && NR % 2 { $16 = f; $17 = g } { f = $16; g = $17; print }' "$at/excitation.csv" >"$at/held.csv"
  cp "$at/free.meta.json" "$at/slow.meta.json"
  cp "$at/free.meta.json" "$at/few.meta.json"
  cp "$at/excitation.meta.json" "$at/held.meta.json"
  cp tests/data/recordings/plain.mcap "$at/plain.mcap"
}

run() {  # preset
  build=build/$1
  echo "== heft under sanitizers: preset $1, $build"
  cmake --preset "$1" >"$build.log" 2>&1 || { tail -n 40 "$build.log" >&2; exit 1; }
  cmake --build --preset "$1" -j "$jobs" >>"$build.log" 2>&1 || { tail -n 40 "$build.log" >&2; exit 1; }
  work=$build/recordings
  mkdir -p "$work"
  recordings "$build/bin/heft" "$work"
  for file in "$work"/*.csv "$work"/plain.mcap; do
    for command in estimate diagnose; do
      status=0
      timeout 900 "$build/bin/heft" "$command" "$file" >"$work/out" 2>"$work/err" || status=$?
      # 1 is a sentence about a recording that cannot be used; a sanitizer's report ends with another code.
      if [ "$status" -gt 1 ] || grep -qE "Sanitizer|runtime error" "$work/err"; then
        cat "$work/err" >&2
        echo "heft $command $file ended with $status" >&2
        exit 1
      fi
      echo "heft $command $(basename "$file"): $status"
    done
  done
}

late() {  # preset
  [ -n "${HEFT_UNTIL:-}" ] && [ "$(date +%s)" -gt "$HEFT_UNTIL" ] || return 1
  echo "== heft under sanitizers: preset $1 is NOT RUN, this machine took too long for what came before (HEFT_MINUTES)"
}

address() {
  late fuzz && return
  run fuzz
  # Exceptions inside assimp, which reads meshes, are leaks of its own.
  echo leak:libassimp >"$build/leaks"
  LSAN_OPTIONS=suppressions=$build/leaks:print_suppressions=0 "$build/bin/replay_corpora" tests/fuzz/corpus >"$build/corpora.log" 2>&1 || { tail -n 40 "$build/corpora.log" >&2; exit 1; }
  echo "corpora of $(wc -l <"$build/corpora.log") parsers: 0"
}
thread() { late threads || run threads; }

export ASAN_OPTIONS=exitcode=99:detect_leaks=1 UBSAN_OPTIONS=halt_on_error=1:exitcode=99 TSAN_OPTIONS=exitcode=99
case ${1:-both} in
  address) address ;;
  thread) thread ;;
  both)
    address
    thread
    ;;
  *)
    echo "sanitize.sh [address|thread]" >&2
    exit 2
    ;;
esac
