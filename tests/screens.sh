#!/bin/sh
# Takes every step of Heft Studio in both window sizes, themes and languages, to be looked at by a person.
# usage: tests/screens.sh BIN_FOLDER OUT_FOLDER [RECORDING.csv ...]     without recordings one is simulated
set -eu
bin=$(cd "$1" && pwd)
mkdir -p "$2"
out=$(cd "$2" && pwd)
shift 2
if [ $# -eq 0 ]; then
  printf '{"mass_kg": 0.812, "com_m": [0.004, -0.002, 0.062], "inertia_com_kgm2": [[0.0016, 0, 0], [0, 0.0015, 0], [0, 0, 0.0009]]}' \
    > "$out/tool.json"
  "$bin/heft" simulate --motion excitation --payload "$out/tool.json" --seed 7 --effect time_offset=8 \
    -o "$out/simulated.csv" > /dev/null
  set -- "$out/simulated.csv"
fi
for recording; do
  name=$(basename "$recording" .csv)
  script=$out/$name.txt
  {
    echo "open $recording"
    for look in "1280x800 light en" "1920x1080 dark de" "1280x800 dark de" "1920x1080 light en"; do
      set -- $look
      printf 'size %s\ntheme %s\nlanguage %s\n' "$1" "$2" "$3"
      for step in record mark shape result reality-check export; do
        printf 'step %s\n' "$step"
        printf 'picture %s/%s_%s_%s_%s_%s.png\n' "$out" "$name" "$step" "$1" "$2" "$3"
      done
    done
  } > "$script"
  "$bin/heft-studio" --offscreen --script "$script"
done
