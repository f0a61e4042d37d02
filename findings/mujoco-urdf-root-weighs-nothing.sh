#!/bin/sh
# MuJoCo 2.2.2 loads a URDF whose tool is the root link, or hangs on the root by a fixed joint, without a word, and the
# tool weighs nothing: such links are merged into the world, whose mass is 0. Only behind a moving joint does it weigh.
#
# Seen on Debian 12 (libmujoco-dev 2.2.2-3):
#   root.urdf    bodies 1, total mass 0
#   fixed.urdf   bodies 1, total mass 0
#   hinge.urdf   bodies 2, total mass 1.5
#
# Why it matters: a payload file with one link, or with a flange and a fixed tool, is what one would write for a tool that
# is bolted on. Whoever checks it by loading it alone gets a model without gravity load and no warning. Attach it to an
# arm, or look at the total mass.
#
# Needs g++ and apt-get; installs nothing (packages are unpacked in a temporary folder). Ends with 1 if this changes.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get download -q libmujoco-dev=2.2.2-3 libmujoco2.2.2=2.2.2-3 >/dev/null
for package in ./*.deb; do dpkg -x "$package" root; done
lib=$(dirname "$(find root -name 'libmujoco.so.2.2.2' | head -n 1)")

inertial='<inertial><origin xyz="0.01 0.02 0.06"/><mass value="1.5"/>
  <inertia ixx="0.003" iyy="0.003" izz="0.001" ixy="0" ixz="0" iyz="0"/></inertial>'
printf '<robot name="r"><link name="tool">%s</link></robot>' "$inertial" >root.urdf
for kind in fixed hinge; do
  [ $kind = fixed ] && joint='type="fixed">' || joint='type="continuous"><axis xyz="0 0 1"/>'
  printf '<robot name="r"><link name="flange"/><link name="tool">%s</link><joint name="j" %s
    <parent link="flange"/><child link="tool"/></joint></robot>' "$inertial" "$joint" >$kind.urdf
done

cat >weigh.cpp <<'CODE'
#include <mujoco/mujoco.h>
#include <cstdio>
int main(int, char** files) {
  while (*++files) {
    char error[1000] = "";
    mjModel* model = mj_loadXML(*files, nullptr, error, sizeof error);
    if (model == nullptr) return std::printf("%s: %s\n", *files, error), 1;
    double mass = 0;
    for (int i = 0; i < model->nbody; ++i) mass += model->body_mass[i];
    std::printf("%s bodies %d, total mass %g%s\n", *files, model->nbody, mass, error);
    mj_deleteModel(model);
  }
}
CODE
g++ -Iroot/usr/include weigh.cpp -o weigh "$lib/libmujoco.so.2.2.2" -Wl,-rpath,"$work/$lib"
./weigh root.urdf fixed.urdf hinge.urdf | tee seen
printf 'root.urdf bodies 1, total mass 0\nfixed.urdf bodies 1, total mass 0\nhinge.urdf bodies 2, total mass 1.5\n' >expected
cmp -s seen expected || { echo "This has changed."; exit 1; }
echo "As described."
