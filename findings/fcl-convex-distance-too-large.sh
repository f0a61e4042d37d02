#!/bin/sh
# FCL 0.7.0: the distance of two fcl::Convex bodies (GST_LIBCCD, the default) is now and then millimetres too large.
#
# Seen on Debian 12 (libfcl-dev 0.7.0-3+b1, libccd-dev 2.1-2+b1): two ellipsoids of 738 vertices, 5 to 20 cm, in 5,000
# random poses, 4,806 of them apart. Against the same triangles as BVHModel<OBBRSS>:
#   7 of 4806 larger by 0.1 mm and more, most 13.7 mm
# No error is reported and no request setting warns of it; the other 4,799 agree.
#
# Why it matters: who keeps a margin by this distance (a planner, a speed limit near people) is nearer than it says. The
# nearest points that come with it prove a lower bound: the gap between the two supports along their difference. Where
# that is less than the distance, compare triangles instead.
#
# Needs g++, Eigen and apt-get; installs nothing (packages are unpacked in a temporary folder). Ends with 1 if this
# changes.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get download -q libfcl-dev=0.7.0-3+b1 libfcl0.7=0.7.0-3+b1 libccd-dev=2.1-2+b1 libccd2=2.1-2+b1 \
    liboctomap-dev=1.9.7+dfsg-3+b1 liboctomap1.9=1.9.7+dfsg-3+b1 libeigen3-dev=3.4.0-4 >/dev/null 2>&1
for package in ./*.deb; do dpkg -x "$package" root; done
lib=$(dirname "$(find root -name 'libfcl.so.0.7' | head -n 1)")

cat >apart.cpp <<'CODE'
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/distance.h>
#include <cmath>
#include <cstdio>
#include <memory>
#include <random>
#include <vector>
using fcl::Vector3d;
struct Body {
  std::shared_ptr<fcl::Convexd> convex;
  std::shared_ptr<fcl::BVHModel<fcl::OBBRSSd>> mesh = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
};
Body ellipsoid(double a, double b, double c) {
  const int rings = 24, corners = 32;
  auto points = std::make_shared<std::vector<Vector3d>>();
  auto faces = std::make_shared<std::vector<int>>();
  std::vector<fcl::Triangle> triangles;
  points->push_back(Vector3d(0, 0, -c));
  for (int i = 1; i < rings; ++i)
    for (int k = 0; k < corners; ++k) {
      const double u = M_PI * (double(i) / rings - 0.5), v = 2 * M_PI * k / corners;
      points->push_back(Vector3d(a * cos(u) * cos(v), b * cos(u) * sin(v), c * sin(u)));
    }
  points->push_back(Vector3d(0, 0, c));
  const auto at = [&](int ring, int k) {
    return ring == 0 ? 0 : ring == rings ? int(points->size()) - 1 : 1 + (ring - 1) * corners + k % corners;
  };
  const auto add = [&](int p, int q, int r) {
    triangles.emplace_back(p, q, r);
    faces->insert(faces->end(), {3, p, q, r});
  };
  for (int i = 0; i < rings; ++i)
    for (int k = 0; k < corners; ++k) {
      if (i > 0) add(at(i, k), at(i, k + 1), at(i + 1, k));
      if (i + 1 < rings) add(at(i, k + 1), at(i + 1, k + 1), at(i + 1, k));
    }
  Body out;
  out.convex = std::make_shared<fcl::Convexd>(points, int(triangles.size()), faces);
  out.mesh->beginModel();
  out.mesh->addSubModel(*points, triangles);
  out.mesh->endModel();
  return out;
}
int main() {
  const Body a = ellipsoid(0.05, 0.08, 0.2), b = ellipsoid(0.1, 0.06, 0.15);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> u(-1, 1);
  int tried = 0, larger = 0;
  double most = 0;
  for (int n = 0; n < 5000; ++n) {
    fcl::Transform3d X = fcl::Transform3d::Identity();
    fcl::Quaterniond q(u(random), u(random), u(random), u(random));
    q.normalize();
    X.linear() = q.toRotationMatrix();
    X.translation() = 0.5 * Vector3d(u(random), u(random), u(random));
    const fcl::DistanceRequestd points(true), plain(false);
    fcl::DistanceResultd one, other;
    const auto here = fcl::Transform3d::Identity();
    const double convex = fcl::distance(a.convex.get(), here, b.convex.get(), X, points, one);
    const double mesh = fcl::distance(a.mesh.get(), here, b.mesh.get(), X, plain, other);
    if (mesh <= 0 || convex <= 0) continue;
    ++tried;
    if (convex > mesh + 1e-4) {
      ++larger;
      most = std::max(most, convex - mesh);
    }
  }
  std::printf("%d of %d larger by 0.1 mm and more, most %.1f mm\n", larger, tried, 1e3 * most);
}
CODE
g++ -O2 -w -std=c++17 -Iroot/usr/include -isystem root/usr/include/eigen3 apart.cpp -o apart "$lib/libfcl.so.0.7" \
    "$(find root -name 'libccd.so.2' | head -n 1)" -Wl,-rpath,"$work/$lib" -Wl,--allow-shlib-undefined
LD_LIBRARY_PATH=$work/$lib ./apart | tee seen
# Which poses fail depends on rounding: a few do, by millimetres.
awk '{ exit !($1 >= 1 && $1 < 50 && $(NF - 1) > 1.0) }' seen || { echo "This has changed."; exit 1; }
echo "As described."
