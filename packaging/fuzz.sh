#!/bin/sh
# Builds tests/fuzz with Clang's libFuzzer, address and undefined-behaviour sanitizers and lets every parser read made-up
# input, one after the other. Inputs that reach something new are kept in build/fuzz/corpus; one that breaks a parser ends
# the run and is named. Needs the Debian packages clang and libclang-rt-dev.
#   sh packaging/fuzz.sh [SECONDS=60] [PARSER ...]      SECONDS for each parser; all of them unless some are named
set -eu
cd "$(dirname "$0")/.."
seconds=${1:-60}
[ $# -eq 0 ] || shift
if ! command -v clang++ >/dev/null; then
  echo "clang++ is missing: install the packages clang and libclang-rt-dev." >&2
  exit 1
fi
cmake --preset fuzz >build/fuzz.log 2>&1 || { cat build/fuzz.log >&2; exit 1; }
cmake --build --preset fuzz --target fuzz_parsers
program=build/fuzz/bin/fuzz_parsers
parsers=${*:-$(ls tests/fuzz/corpus)}
# Exceptions of the libraries that meshes and HDF5 are read with are leaks of theirs; a parser may take 2 GB and 25 s at most.
# libmatio reserves what a damaged head asks for, and does not touch it: only what is resident counts.
export ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1 UBSAN_OPTIONS=print_stacktrace=1
# libhdf5 1.10 crashes on some damaged files, which is why it reads in a process of its own (core/import/own_process.h):
# its run goes on after a crash.
for parser in $parsers; do
  kept=build/fuzz/corpus/$parser
  mkdir -p "$kept" build/fuzz/broken
  echo "== $parser, $seconds s"
  own=
  [ "$parser" != hdf5 ] || own="-fork=1 -ignore_crashes=1"
  # shellcheck disable=SC2086
  if ! "$program" --parser="$parser" $own -max_total_time="$seconds" -timeout=25 -rss_limit_mb=2048 -malloc_limit_mb=65536 -max_len=65536 -print_final_stats=1 \
    -artifact_prefix="build/fuzz/broken/$parser-" "$kept" "tests/fuzz/corpus/$parser" >"build/fuzz/$parser.log" 2>&1; then
    tail -n 40 "build/fuzz/$parser.log" >&2
    echo "$parser broke; the input lies in build/fuzz/broken, and build/fuzz/$parser.log says where." >&2
    exit 1
  fi
  grep -E "number_of_executed_units|peak_rss_mb" "build/fuzz/$parser.log"
done
