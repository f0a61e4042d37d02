#!/bin/sh
# Where a build's time went: by library, the twenty dearest units, and the twenty headers of which most is read.
#   sh packaging/compile-times.sh [build/release]
# Times are those of the log that Ninja keeps (wall time of each unit's last compilation, summed over all jobs), so a
# busy machine makes them longer. A header's size counts once for each unit that reads it.
set -eu
build=${1:-build/release}
[ -f "$build/.ninja_log" ] || { echo "$build holds no build by Ninja: build first, for instance by sh packaging/start.sh" >&2; exit 1; }

# Start, end [ms], time stamp, output: the last line of an output counts.
units=$(mktemp)
trap 'rm -f "$units"' EXIT
awk -F '\t' '$4 ~ /\.(o|gch)$/ { ms[$4] = $2 - $1 } END { for (o in ms) printf "%.1f\t%s\n", ms[o] / 1000, o }' \
    "$build/.ninja_log" | sort -rn >"$units"

echo "== Compile time by library [s]"
awk -F '\t' '{ name = $2; sub(/\/?CMakeFiles\/.*/, "", name); if (name == "") name = "precompiled headers"
               s[name] += $1; n[name]++; all += $1; count++ }
             END { printf "%8.1f  %4d units  all\n", all, count
                   for (l in s) printf "%8.1f  %4d units  %s\n", s[l], n[l], l | "sort -rn" }' "$units"

echo "== The twenty dearest units [s]"
awk -F '\t' 'NR <= 20 { name = $2; sub(/CMakeFiles\/[^\/]*\//, "", name); printf "%8.1f  %s\n", $1, name }' "$units"

echo "== The twenty headers of which most is read [MB, units]"
ninja -C "$build" -t deps 2>/dev/null | awk '/^ +\// { n[$1]++ } END { for (f in n) print n[f], f }' |
  while read -r count file; do
    [ -f "$file" ] && echo "$count $(wc -c <"$file") $file"
  done | awk '{ printf "%8.1f  %4d units  %s\n", $1 * $2 / 1e6, $1, $3 }' | sort -rn | head -n 20
