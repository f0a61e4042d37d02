#!/bin/sh
# Builds Heft with warnings as errors, runs every test, and checks what it installs. Works as root and through sudo, and
# again and again.
#   sh packaging/check.sh                  everything
#   HEFT_GUI=OFF sh packaging/check.sh     without Qt and VTK: core and the command line
set -eu
cd "$(dirname "$0")/.."
gui=${HEFT_GUI:-ON}
jobs=$(nproc)

sh packaging/install-packages.sh
echo "== Build: preset ci, warnings are errors, build/ci, $jobs at a time"
cmake --preset ci -DHEFT_WITH_GUI="$gui"
cmake --build --preset ci -j "$jobs"
echo "== Tests"
status=0
ctest --preset ci -j "$jobs" || status=$?
rm -rf build/ci/installed
cmake --install build/ci --prefix build/ci/installed >build/ci/installed.log
sh packaging/validate.sh build/ci/installed || status=$?
# Whoever called sudo shall be able to go on without it.
[ -z "${SUDO_UID:-}" ] || chown -R "$SUDO_UID:${SUDO_GID:-$SUDO_UID}" build
exit "$status"
