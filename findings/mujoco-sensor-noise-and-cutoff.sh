#!/bin/sh
# MuJoCo 2.2.2: <force noise="0.5"> adds no noise to sensordata, and cutoff="5" is no frequency: it clamps the reading.
#
# Seen on Debian 12 (libmujoco-dev 2.2.2-3), 1 kg held still for 1000 steps, force along z at the site:
#   plain   mean 9.81, standard deviation 0
#   noise   mean 9.81, standard deviation 0
#   cutoff  mean 5, standard deviation 0
#
# Why it matters: whoever exports a sensor model with noise and a low-pass frequency into these attributes, which every
# other simulator has under the same names, gets a clean sensor that saturates at a few newtons. Noise has to be added,
# and filters applied, by the program that reads sensordata.
#
# Needs g++ and apt-get; installs nothing (packages are unpacked in a temporary folder). Ends with 1 if this changes.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get download -q libmujoco-dev=2.2.2-3 libmujoco2.2.2=2.2.2-3 >/dev/null
for package in ./*.deb; do dpkg -x "$package" root; done
lib=$(dirname "$(find root -name 'libmujoco.so.2.2.2' | head -n 1)")

cat >held.xml <<'MODEL'
<mujoco><option gravity="0 0 -9.81"/>
  <worldbody><body><joint type="hinge" axis="0 0 1" damping="1"/><geom type="sphere" size=".05" mass="0.001"/>
    <body><site name="s"/><geom type="sphere" size=".05" mass="1"/></body></body></worldbody>
  <sensor><force name="plain" site="s"/><force name="noise" site="s" noise="0.5"/>
    <force name="cutoff" site="s" cutoff="5"/></sensor></mujoco>
MODEL
cat >read.cpp <<'CODE'
#include <mujoco/mujoco.h>
#include <cmath>
#include <cstdio>
int main() {
  char error[1000] = "";
  mjModel* model = mj_loadXML("held.xml", nullptr, error, sizeof error);
  if (model == nullptr) return std::printf("%s\n", error), 1;
  mjData* data = mj_makeData(model);
  double sum[3] = {}, square[3] = {};
  constexpr int steps = 1000;
  for (int i = 0; i < steps; ++i) {
    mj_step(model, data);
    for (int s = 0; s < 3; ++s) {
      const double z = data->sensordata[3 * s + 2];
      sum[s] += z;
      square[s] += z * z;
    }
  }
  const char* names[] = {"plain", "noise", "cutoff"};
  for (int s = 0; s < 3; ++s) {
    const double mean = sum[s] / steps;
    const double deviation = std::sqrt(std::fmax(0.0, square[s] / steps - mean * mean));
    std::printf("%s mean %.3g, standard deviation %.3f\n", names[s], mean, deviation);
  }
}
CODE
g++ -Iroot/usr/include read.cpp -o read "$lib/libmujoco.so.2.2.2" -Wl,-rpath,"$work/$lib"
./read | tee seen
printf 'plain mean 9.81, standard deviation 0.000\nnoise mean 9.81, standard deviation 0.000\ncutoff mean 5, standard deviation 0.000\n' >expected
cmp -s seen expected || { echo "This has changed."; exit 1; }
echo "As described."
