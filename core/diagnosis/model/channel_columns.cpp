#include "core/diagnosis/model/channel_columns.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/base/parallel.h"
#include "core/math/column_products.h"

namespace heft::diagnosis {

namespace {

using Channels = Eigen::Map<Wrenches>;
using ConstChannels = Eigen::Map<const Wrenches>;

constexpr std::size_t kChannels = 6;

Eigen::Index rowOf(std::size_t channel) { return static_cast<Eigen::Index>(channel); }

}  // namespace

ChannelColumn::ChannelColumn(const Eigen::Ref<const Wrenches>& wrench, double factor) : blocks_(wrench.cols()) {
  Vector6d most = Vector6d::Zero();
  if (blocks_ > 0) most = wrench.cwiseAbs().rowwise().maxCoeff();
  Eigen::Index kept = 0;
  for (std::size_t c = 0; c < kChannels; ++c) {
    at_[c] = most(rowOf(c)) == 0.0 ? -1 : kept;
    if (at_[c] >= 0) kept += blocks_;
  }
  values_.resize(kept);
  for (std::size_t c = 0; c < kChannels; ++c)
    if (at_[c] >= 0) values_.segment(at_[c], blocks_) = factor * wrench.row(rowOf(c)).transpose();
}

ChannelColumn::ChannelColumn(std::size_t channel, VectorXd values)
    : blocks_(values.size()), values_(std::move(values)) {
  at_.fill(-1);
  at_[channel] = 0;
}

Stretch ChannelColumn::support() const {
  Stretch out{blocks_, 0};
  for (std::size_t c = 0; c < kChannels; ++c) {
    if (isZero(c)) continue;
    const auto values = channel(c);
    const auto acts = [](double value) { return value != 0.0; };
    const auto from = std::find_if(values.begin(), values.end(), acts) - values.begin();
    if (from == blocks_) continue;
    Eigen::Index to = blocks_;
    while (!acts(values(to - 1))) --to;
    out = {std::min(out.from, from), std::max(out.to, to)};
  }
  return out.from < out.to ? out : Stretch{};
}

ChannelColumn ChannelColumn::middle(Stretch blocks) const {
  ChannelColumn out;
  out.blocks_ = blocks.to - blocks.from;
  out.values_.resize(values_.size() / std::max<Eigen::Index>(1, blocks_) * out.blocks_);
  for (std::size_t c = 0; c < kChannels; ++c) {
    out.at_[c] = isZero(c) ? -1 : at_[c] / blocks_ * out.blocks_;
    if (!isZero(c)) out.values_.segment(out.at_[c], out.blocks_) = channel(c).segment(blocks.from, out.blocks_);
  }
  return out;
}

VectorXd ChannelColumn::dense() const {
  VectorXd out = VectorXd::Zero(6 * blocks_);
  for (std::size_t c = 0; c < kChannels; ++c)
    if (!isZero(c)) Channels(out.data(), 6, blocks_).row(rowOf(c)) = channel(c).transpose();
  return out;
}

ChannelColumns::ChannelColumns(Eigen::Index blocks, Eigen::Index columns) : blocks_(blocks) { grow(columns); }

ChannelColumns::ChannelColumns(const MatrixXd& dense) : ChannelColumns(dense.rows() / 6, dense.cols()) {
  for (Eigen::Index i = 0; i < cols(); ++i) set(i, ChannelColumn(ConstChannels(dense.col(i).data(), 6, blocks_)));
}

void ChannelColumns::set(Eigen::Index i, ChannelColumn column) {
  columns_[static_cast<std::size_t>(i)] = std::make_shared<const ChannelColumn>(std::move(column));
}

void ChannelColumns::grow(Eigen::Index columns) {
  const auto nothing = std::make_shared<const ChannelColumn>(Wrenches(Wrenches::Zero(6, blocks_)));
  columns_.resize(columns_.size() + static_cast<std::size_t>(columns), nothing);
}

Stretch ChannelColumns::support() const {
  Stretch out{blocks_, 0};
  for (const auto& column : columns_) {
    const Stretch acts = column->support();
    if (acts.from < acts.to) out = {std::min(out.from, acts.from), std::max(out.to, acts.to)};
  }
  return out.from < out.to ? out : Stretch{};
}

ChannelColumns ChannelColumns::middle(Stretch blocks) const {
  if (blocks.from == 0 && blocks.to == blocks_) return *this;
  ChannelColumns out(blocks.to - blocks.from, cols());
  for (Eigen::Index i = 0; i < cols(); ++i) out.set(i, column(i).middle(blocks));
  return out;
}

MatrixXd ChannelColumns::dense() const {
  MatrixXd out(6 * blocks_, cols());
  for (Eigen::Index i = 0; i < cols(); ++i) out.col(i) = column(i).dense();
  return out;
}

VectorXd ChannelColumns::times(const VectorXd& v) const {
  VectorXd out = VectorXd::Zero(6 * blocks_), sum(blocks_);
  for (std::size_t c = 0; c < kChannels; ++c) {
    std::vector<const double*> acting;
    std::vector<double> by;
    for (Eigen::Index i = 0; i < cols(); ++i) {
      if (v(i) == 0.0 || column(i).isZero(c)) continue;
      acting.push_back(column(i).channel(c).data());
      by.push_back(v(i));
    }
    if (acting.empty()) continue;
    sumOfColumns(acting, by, sum);
    Channels(out.data(), 6, blocks_).row(rowOf(c)) = sum.transpose();
  }
  return out;
}

WhitenedColumns::WhitenedColumns(Eigen::Index columns, Eigen::Index blocks, Eigen::Index first, const Noise& noise,
                                 const std::vector<Stretch>& stretches)
    : columns_(columns), blocks_(blocks), first_(first) {
  for (std::size_t c = 0; c < kChannels; ++c)
    for (const Stretch& stretch : stretches) {
      // The first ones only fill the memory.
      const Eigen::Index from = std::max<Eigen::Index>(0, stretch.from - first) + noise.channels[c].order(),
                         count = std::min(blocks_, stretch.to - first) - from;
      if (count > 0) runs_[c].push_back({from, count, rows(c)});
    }
}

Eigen::Index WhitenedColumns::rows(std::size_t channel) const {
  const auto& runs = runs_[channel];
  return runs.empty() ? 0 : runs.back().row + runs.back().count;
}

WhitenedColumns WhitenedColumns::ofWhite(const MatrixXd& white, const Noise& noise,
                                         const std::vector<Stretch>& stretches) {
  WhitenedColumns out(white.cols(), white.rows() / 6, 0, noise, stretches);
  parallelFor(kChannels, [&](std::size_t c) {
    out.which_[c].resize(static_cast<std::size_t>(out.columns_));
    std::iota(out.which_[c].begin(), out.which_[c].end(), Eigen::Index{0});
    out.parts_[c] = out.judged(white, c);
  });
  return out;
}

WhitenedColumns::WhitenedColumns(const ChannelColumns& columns, const Noise& noise,
                                 const std::vector<Stretch>& stretches, Eigen::Index first)
    : WhitenedColumns(columns.cols(), columns.blocks(), first, noise, stretches) {
  struct Piece {
    std::size_t channel;
    Eigen::Index place;
  };
  std::vector<Piece> pieces;
  for (std::size_t c = 0; c < kChannels; ++c) {
    for (Eigen::Index i = 0; i < columns_; ++i) {
      if (columns.column(i).isZero(c)) continue;
      pieces.push_back({c, std::ssize(which_[c])});
      which_[c].push_back(i);
    }
    parts_[c].resize(rows(c), std::ssize(which_[c]));
  }
  parallelFor(pieces.size(), [&](std::size_t i) {
    const auto [c, place] = pieces[i];
    const auto values = columns.column(which_[c][static_cast<std::size_t>(place)]).channel(c);
    VectorXd even;
    if (noise.level != nullptr)
      even = values.cwiseProduct(noise.level->byChannel.col(rowOf(c)).segment(first, blocks_));
    const double* const x = noise.level != nullptr ? even.data() : values.data();
    for (const Run& run : runs_[c])
      innovate(x + run.from, noise.channels[c], run.count, parts_[c].col(place).data() + run.row);
  });
}

/// What is judged of a channel of columns with 6N rows.
MatrixXd WhitenedColumns::judged(const MatrixXd& C, std::size_t channel) const {
  MatrixXd out(rows(channel), C.cols());
  for (Eigen::Index i = 0; i < C.cols(); ++i)
    for (const Run& run : runs_[channel])
      out.col(i).segment(run.row, run.count) =
          ConstChannels(C.col(i).data(), 6, blocks_).row(rowOf(channel)).segment(run.from, run.count).transpose();
  return out;
}

MatrixXd WhitenedColumns::gram() const {
  std::array<MatrixXd, kChannels> parts;
  parallelFor(kChannels, [&](std::size_t c) { parts[c] = columnProducts(parts_[c]); });
  MatrixXd out = MatrixXd::Zero(columns_, columns_);
  for (std::size_t c = 0; c < kChannels; ++c) out(which_[c], which_[c]) += parts[c];
  return out;
}

VectorXd WhitenedColumns::times(const VectorXd& v) const {
  VectorXd out = VectorXd::Zero(6 * blocks_);
  for (std::size_t c = 0; c < kChannels; ++c) {
    const VectorXd rows = parts_[c] * v(which_[c]);
    for (const Run& run : runs_[c])
      Channels(out.data(), 6, blocks_).row(rowOf(c)).segment(run.from, run.count) =
          rows.segment(run.row, run.count).transpose();
  }
  return out;
}

MatrixXd WhitenedColumns::transposeTimes(const WhitenedColumns& C) const {
  MatrixXd out = MatrixXd::Zero(columns_, C.columns_);
  const Eigen::Index ahead = C.first_ - first_;
  for (std::size_t c = 0; c < kChannels; ++c) {
    if (which_[c].empty() || C.which_[c].empty()) continue;
    for (const Run& theirs : C.runs_[c]) {
      const Eigen::Index from = theirs.from + ahead;
      const auto own = std::ranges::find_if(
          runs_[c], [&](const Run& run) { return run.from <= from && from < run.from + run.count; });
      out(which_[c], C.which_[c]) += columnProducts(parts_[c].middleRows(own->row + from - own->from, theirs.count),
                                                    C.parts_[c].middleRows(theirs.row, theirs.count));
    }
  }
  return out;
}

MatrixXd WhitenedColumns::transposeTimes(const MatrixXd& C) const {
  MatrixXd out = MatrixXd::Zero(columns_, C.cols());
  for (std::size_t c = 0; c < kChannels; ++c) {
    if (which_[c].empty()) continue;
    out(which_[c], Eigen::all) += columnProducts(parts_[c], judged(C, c));
  }
  return out;
}

}  // namespace heft::diagnosis
