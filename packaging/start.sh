#!/bin/sh
# Installs what is missing, builds Heft and does its main job once: sample recordings from the built-in simulator,
# an estimate of each, a payload file for the controller. Opens the studio where there is a display.
# Works as root and through sudo, and again and again.
#   sh packaging/start.sh                  everything
#   HEFT_GUI=OFF sh packaging/start.sh     without Qt and VTK: the command line only
#   HEFT_OPEN=no sh packaging/start.sh     does not open the studio
set -eu
cd "$(dirname "$0")/.."
gui=${HEFT_GUI:-ON}
jobs=$(nproc)
samples=build/samples
bin=build/release/bin

sh packaging/install-packages.sh
echo "== Build: preset release, build/release, $jobs at a time"
cmake --preset release -DHEFT_WITH_GUI="$gui"
cmake --build --preset release --target programs -j "$jobs"

echo "== Sample recordings, made by Heft's own simulator"
mkdir -p "$samples"
for motion in excitation pick-and-place free; do
  "$bin/heft" simulate --motion "$motion" --seed 1 -o "$samples/$motion.csv" --truth "$samples/$motion.truth.json"
done

for motion in excitation pick-and-place free; do
  echo
  echo "== heft estimate $samples/$motion.csv"
  "$bin/heft" estimate "$samples/$motion.csv" --json "$samples/$motion.result.json"
done

echo
echo "== The payload file for Franka Desk, from the excitation recording"
"$bin/heft" export "$samples/excitation.result.json" --format franka-desk -o "$samples/tool.json" --force
cat "$samples/tool.json"

# Whoever called sudo shall be able to go on without it.
[ -z "${SUDO_UID:-}" ] || chown -R "$SUDO_UID:${SUDO_GID:-$SUDO_UID}" build

echo
studio=$bin/heft-studio
if [ "$gui" = OFF ]; then
  echo "Done. The command line is $bin/heft."
elif [ -z "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ] || [ "${HEFT_OPEN:-yes}" = no ]; then
  echo "Done. The command line is $bin/heft. With a display, open the studio by: $studio $samples/excitation.csv"
else
  echo "Done. The command line is $bin/heft. Opening the studio: $studio $samples/excitation.csv"
  as_user=
  [ -z "${SUDO_USER:-}" ] || [ "$SUDO_USER" = root ] || as_user="sudo -E -u $SUDO_USER"
  # shellcheck disable=SC2086  # nothing, or a command and its arguments
  nohup $as_user "$studio" "$samples/excitation.csv" >build/studio.log 2>&1 &
  sleep 2
  kill -0 $! 2>/dev/null || echo "The studio ended at once; build/studio.log says why."
fi
