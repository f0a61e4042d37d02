#!/bin/sh
# Builds Heft with warnings as errors, runs every test, and checks what it installs. Works as root and through sudo, and
# again and again.
#   sh packaging/check.sh                  everything
#   HEFT_GUI=OFF sh packaging/check.sh     without Qt and VTK: core and the command line
#   HEFT_STYLE=ON sh packaging/check.sh    clang-format of all and clang-tidy of what changed, too (packaging/style.sh);
#                                          format: clang-format alone
#   HEFT_SANITIZERS=address sh packaging/check.sh   heft under sanitizers, too (packaging/sanitize.sh): one more build by Clang;
#                                          both: two
#   HEFT_MINUTES=60 sh packaging/check.sh  begins no further build under sanitizers after so many minutes, and says so
set -eu
cd "$(dirname "$0")/.."
began=$(date +%s)
gui=${HEFT_GUI:-ON}
jobs=$(nproc)

HEFT_PYTHON=ON sh packaging/install-packages.sh
echo "== Build: preset release, warnings are errors, build/release, $jobs at a time"
cmake --preset release -DHEFT_WITH_GUI="$gui" -DHEFT_WITH_PYTHON=ON -DHEFT_WERROR=ON -DHEFT_CONSUMER_TEST=ON
cmake --build --preset release -j "$jobs"
sh packaging/compile-times.sh build/release | head -n 12
echo "== Tests"
status=0
ctest --preset release -j "$jobs" || status=$?
rm -rf build/release/installed
cmake --install build/release --prefix build/release/installed >build/release/installed.log
sh packaging/validate.sh build/release/installed || status=$?
case ${HEFT_STYLE:-OFF} in
  ON) sh packaging/style.sh || status=$? ;;
  format) sh packaging/style.sh format || status=$? ;;
esac
if [ -n "${HEFT_SANITIZERS:-}" ]; then
  HEFT_UNTIL=${HEFT_MINUTES:+$((began + HEFT_MINUTES * 60))} sh packaging/sanitize.sh "$HEFT_SANITIZERS" || status=$?
fi
# Whoever called sudo shall be able to go on without it.
[ -z "${SUDO_UID:-}" ] || chown -R "$SUDO_UID:${SUDO_GID:-$SUDO_UID}" build
exit "$status"
