#!/bin/sh
# Makes the Debian package of a build and tries it in a bare Debian: installs it, weighs a simulated tool, writes a payload
# file, drives the studio without a screen, removes it. Run as root; needs the package debootstrap.
#   sh packaging/deb/try.sh [BUILD_FOLDER [SUITE]]      build/release and bookworm unless said
set -eu
cd "$(dirname "$0")/../.."
build=$(cd "${1:-build/release}" && pwd)
suite=${2:-bookworm}
root=$(mktemp -d)
chmod 755 "$root"
leave() {
  umount "$root/proc" "$root/dev" 2>/dev/null || true
  # Nothing of the machine may still hang in there when it is removed.
  if ! mount | grep -q " $root/"; then rm -rf "$root"; fi
}
trap leave EXIT

rm -f "$build"/heft_*.deb
(cd "$build" && cpack -G DEB >/dev/null)
echo "== Debian $suite with nothing installed"
debootstrap --variant=minbase "$suite" "$root" http://deb.debian.org/debian >"$build/debootstrap.log"
mount --bind /proc "$root/proc"
mount --bind /dev "$root/dev"
cp "$build"/heft_*.deb "$root/tmp/"
cat >"$root/tmp/inside.sh" <<'INSIDE'
set -eu
export DEBIAN_FRONTEND=noninteractive
cd /tmp
apt-get update -q >apt.log
apt-get install -y -q ./heft_*.deb >>apt.log 2>&1 || { tail -20 apt.log; exit 1; }
echo "== Installed on $(cat /etc/debian_version)"
heft --version
heft-studio --version
heft simulate --motion excitation --seed 3 --duration 10 -o rec.csv
heft estimate rec.csv --json result.json
heft export result.json --format libfranka -o load.h
printf 'open rec.csv\nstep result\npicture result.png\nexport franka-desk desk.json\n' >script.txt
heft-studio --offscreen --script script.txt
for made in load.h result.png desk.json; do test -s "$made" || { echo "$made was not made"; exit 1; }; done
for shown in man/man1/heft.1.gz applications/org.heft.HeftStudio.desktop bash-completion/completions/heft; do
  test -e "/usr/share/$shown" || echo "/usr/share/$shown is not there"
done
apt-get purge -y -q heft >>apt.log 2>&1
left=$(find /usr /etc /var/lib -name '*heft*' -not -path '/var/lib/apt/*' | head)
[ -z "$left" ] || { echo "left behind: $left"; exit 1; }
echo "== Works, and leaves nothing behind when it is removed"
INSIDE
chroot "$root" sh /tmp/inside.sh
