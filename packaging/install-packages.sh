#!/bin/sh
# Installs what building and testing Heft needs on Debian 12, and nothing if it is all there. Run by start.sh and check.sh.
# libmujoco-dev and libsdformat-dev, 13 MB, read exported files back in the tests, which do without them, too.
# HEFT_GUI=OFF leaves out Qt, VTK and QCustomPlot; HEFT_PYTHON=ON adds what the Python module and its tests need,
# HEFT_STYLE=ON what style.sh does, HEFT_SANITIZERS=both what sanitize.sh and fuzz.sh do. (locales: a decimal comma for the tests;
# groff-base and the last four: validate.sh; dpkg-dev and file: cpack.)
set -eu

core="clang cmake ninja-build ccache lld pkg-config libeigen3-dev nlohmann-json3-dev libcli11-dev libfmt-dev libceres-dev
      liburdfdom-dev libassimp-dev libsqlite3-dev libzstd-dev liblz4-dev libbz2-dev zlib1g-dev libhdf5-dev libmatio-dev libboost-dev libfcl-dev libqhull-dev libgtest-dev libgmock-dev
      libmujoco-dev libsdformat-dev locales
      groff-base dpkg-dev file"
gui="libvtk9-qt-dev qtbase5-dev qttools5-dev libqt5svg5-dev libqcustomplot-dev xvfb libgl1-mesa-dri fonts-inter
     desktop-file-utils appstream shared-mime-info libxml2-utils"
python="python3-dev pybind11-dev python3-numpy python3-matplotlib python3-pytest"

style="git clang-format"
tidy="clang-tidy"
sanitizers="libclang-rt-dev"

packages=$core
[ "${HEFT_STYLE:-OFF}" = OFF ] || packages="$packages $style"
[ "${HEFT_STYLE:-OFF}" != ON ] || packages="$packages $tidy"
[ -z "${HEFT_SANITIZERS:-}" ] || packages="$packages $sanitizers"
[ "${HEFT_PYTHON:-OFF}" = OFF ] || packages="$packages $python"
[ "${HEFT_GUI:-ON}" = OFF ] || packages="$packages $gui"

missing=
for package in $packages; do
  if ! dpkg-query -W -f '${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed; then
    missing="$missing $package"
  fi
done
if [ -z "$missing" ]; then
  echo "== Packages: all there"
  exit 0
fi

if ! command -v apt-get >/dev/null; then
  echo "This machine has no apt-get. Install the equivalents of these Debian packages and run again:$missing" >&2
  exit 1
fi
if [ "$(id -u)" -eq 0 ]; then
  as_root=
elif command -v sudo >/dev/null; then
  as_root=sudo
else
  echo "Packages are missing and there is no sudo. As root run: apt-get install --no-install-recommends$missing" >&2
  exit 1
fi

# Java, which Debian's VTK headers depend on, cannot be set up in a chroot without /proc.
if [ ! -e /proc/self ]; then
  echo "== Packages: mounting /proc meanwhile, which this chroot lacks"
  if $as_root mount -t proc proc /proc; then
    # shellcheck disable=SC2064  # as it is now
    trap "$as_root umount /proc" EXIT
  else
    echo "/proc cannot be mounted; if apt-get fails below, mount it from outside and run again." >&2
  fi
fi

echo "== Packages: installing with apt-get:$missing"
# Finishes what an interrupted run left half installed; otherwise it does nothing.
$as_root env DEBIAN_FRONTEND=noninteractive dpkg --configure -a
$as_root apt-get update -q
# shellcheck disable=SC2086  # one word a package is what is wanted
$as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $missing
