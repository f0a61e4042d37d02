#include "ui/robot_view/soft_shadow.h"

#include <algorithm>
#include <cmath>

namespace heft {
namespace {

/// Light falls a little from the side: a point at height z throws its shadow this far per metre.
constexpr double kLeanX = 0.22, kLeanY = 0.16;
constexpr double kTop[] = {0.18, 0.5, 1e9};  // Upper height of each layer [m].
constexpr int kBlur[] = {3, 7, 12};          // Half width of its box blur [cells].
constexpr float kDarkness[] = {0.62f, 0.38f, 0.26f};

/// Three box blurs come close to a Gaussian.
void blur(std::vector<float>& cells, int n, int half) {
  std::vector<float> line(n);
  const float share = 1.0f / static_cast<float>(2 * half + 1);
  for (int pass = 0; pass < 3; ++pass) {
    for (const bool rows : {true, false}) {
      const int step = rows ? 1 : n, jump = rows ? n : 1;
      for (int l = 0; l < n; ++l) {
        float* start = cells.data() + static_cast<std::ptrdiff_t>(l) * jump;
        float sum = 0;
        for (int i = 0; i < half; ++i) sum += start[i * step];
        for (int i = 0; i < n; ++i) {
          if (i + half < n) sum += start[(i + half) * step];
          if (i - half - 1 >= 0) sum -= start[(i - half - 1) * step];
          line[i] = sum * share;
        }
        for (int i = 0; i < n; ++i) start[i * step] = line[i];
      }
    }
  }
}

}  // namespace

void SoftShadow::clear() {
  for (auto& layer : layers_) layer.assign(kCells * kCells, 0.0f);
}

void SoftShadow::add(const Vector3d& point) {
  if (!point.allFinite()) return;
  const double scale = kCells / kExtent;
  const int x = static_cast<int>(std::floor((point.x() + kLeanX * point.z() + kExtent / 2) * scale));
  const int y = static_cast<int>(std::floor((point.y() + kLeanY * point.z() + kExtent / 2) * scale));
  int layer = 0;
  while (point.z() > kTop[layer]) ++layer;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (x + dx < 0 || x + dx >= kCells || y + dy < 0 || y + dy >= kCells) continue;
      layers_[layer][(y + dy) * kCells + x + dx] = 1.0f;
    }
  }
}

const std::vector<std::uint8_t>& SoftShadow::finish() {
  result_.resize(kCells * kCells);
  for (int l = 0; l < kLayers; ++l) blur(layers_[l], kCells, kBlur[l]);
  for (int i = 0; i < kCells * kCells; ++i) {
    float light = 1.0f;
    for (int l = 0; l < kLayers; ++l) light *= 1.0f - kDarkness[l] * std::min(1.0f, layers_[l][i]);
    result_[i] = static_cast<std::uint8_t>(std::lround(255.0f * (1.0f - light)));
  }
  return result_;
}

}  // namespace heft
