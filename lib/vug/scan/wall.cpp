// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/scan/cell_depths.h>
#include <vug/scan/wall.h>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <cmath>

namespace vug::scan {
namespace {

struct BinDepth {
  Vec2d place;
  double depth = 0;
};

/// The median depth of each cell with points.
std::vector<BinDepth> samples_of(const RangeImage& range, const CellDepths& cells) {
  std::vector<BinDepth> out;
  for (int y = 0; y < cells.down; ++y)
    for (int x = 0; x < cells.across; ++x)
      if (const double depth = cells.depths[cells.index(x, y)]; !std::isnan(depth))
        out.push_back({{(x + 0.5) * cells.side * range.pixel,
                        (range.height - (y + 0.5) * cells.side) * range.pixel},
                       depth});
  return out;
}

/// The four nodes around a position and their bilinear weights.
struct BilinearWeights {
  std::array<int, 4> node{};
  std::array<double, 4> part{};
};

BilinearWeights bilinear_weights(const Wall& wall, const Vec2d& place) {
  const auto axis = [&](double v, int nodes) {
    const double at = std::clamp(v / wall.step, 0.0, nodes - 1.0);
    const int low = std::clamp(static_cast<int>(at), 0, std::max(0, nodes - 2));
    return std::pair(low, at - low);
  };
  const auto [x, u] = axis(place.x, wall.across);
  const auto [y, v] = axis(place.y, wall.up);
  const int right = wall.across > 1 ? 1 : 0, above = wall.up > 1 ? wall.across : 0;
  const int node = y * wall.across + x;
  return {{node, node + right, node + above, node + above + right},
          {(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v}};
}

class WallFitter {
 public:
  WallFitter(const RangeImage& range, const WallOptions& options, const CellDepths& cells)
      : options_(options), samples_(samples_of(range, cells)) {
    if (samples_.empty()) throw Error(ErrorCode::bad_input, "the range image has no depths");
    const auto nodes = [&](double metres) {
      return static_cast<int>(std::ceil(std::min(metres / options.step, 1e4))) + 1;
    };
    wall_.step = options.step;
    wall_.across = nodes(range.metres_wide()), wall_.up = nodes(range.metres_high());
    wall_.depths.assign(static_cast<size_t>(wall_.across) * static_cast<size_t>(wall_.up), 0);
    for (const BinDepth& sample : samples_)
      weights_.push_back(bilinear_weights(wall_, sample.place));
  }

  Wall fit() {
    // Weight of cells in front of the surface; 1 minus this behind it.
    constexpr double kBefore = 0.95;
    // Initial width of the robust kernel, in multiples of the noise.
    constexpr double kWidest = 8;
    constexpr double kMaxDeviation = 1;  // Metres by which a wall may differ from the plane.
    for (int round = 0; round < 3; ++round) solve(kMaxDeviation, 0.5);
    for (double reach = kWidest; reach >= 1; reach *= 0.75)
      for (int round = 0; round < 3; ++round)
        solve(reach * options_.noise, reach > 2 ? kBefore : 0.5);
    for (int round = 0; round < 5; ++round) solve(options_.noise, 0.5);
    double squares = 0, count = 0;
    for (size_t i = 0; i < samples_.size(); ++i) {
      const double r = residual(i);
      if (std::fabs(r) <= 2 * options_.noise) squares += r * r, ++count;
    }
    wall_.rms = count > 0 ? std::sqrt(squares / count) : 0;
    return std::move(wall_);
  }

 private:
  double residual(size_t i) const {
    double surface = 0;
    for (size_t k = 0; k < 4; ++k)
      surface += weights_[i].part[k] * wall_.depths[static_cast<size_t>(weights_[i].node[k])];
    return samples_[i].depth - surface;
  }

  void solve(double reach, double pull_before) {
    const auto count = static_cast<Eigen::Index>(wall_.depths.size());
    std::vector<Eigen::Triplet<double>> terms;
    Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
    for (size_t i = 0; i < samples_.size(); ++i) {
      const double r = residual(i), fall = 1 + r * r / (reach * reach);
      const double weight = (r > 0 ? pull_before : 1 - pull_before) / (fall * fall);
      for (size_t a = 0; a < 4; ++a) {
        const double part = weight * weights_[i].part[a];
        right[weights_[i].node[a]] += part * samples_[i].depth;
        for (size_t b = 0; b < 4; ++b)
          terms.emplace_back(weights_[i].node[a], weights_[i].node[b], part * weights_[i].part[b]);
      }
    }
    add_bends(terms);
    Eigen::SparseMatrix<double> matrix(count, count);
    matrix.setFromTriplets(terms.begin(), terms.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    const Eigen::VectorXd depths = solver.solve(right);
    std::copy(depths.begin(), depths.end(), wall_.depths.begin());
  }

  /// Penalty on squared second differences along both axes, plus a small one on squared depths for
  /// otherwise unconstrained nodes.
  void add_bends(std::vector<Eigen::Triplet<double>>& terms) const {
    const double cells = options_.step / options_.cell;
    const double weight = 0.01 * options_.stiffness * cells * cells;
    const auto bend = [&](int a, int b, int c) {
      const std::array<std::pair<int, double>, 3> row = {{{a, 1}, {b, -2}, {c, 1}}};
      for (const auto& [i, u] : row)
        for (const auto& [j, v] : row) terms.emplace_back(i, j, weight * u * v);
    };
    for (int y = 0; y < wall_.up; ++y)
      for (int x = 0; x < wall_.across; ++x) {
        const int node = y * wall_.across + x;
        terms.emplace_back(node, node, 1e-6 * weight);
        if (x > 0 && x + 1 < wall_.across) bend(node - 1, node, node + 1);
        if (y > 0 && y + 1 < wall_.up) bend(node - wall_.across, node, node + wall_.across);
      }
  }

  const WallOptions& options_;
  std::vector<BinDepth> samples_;
  std::vector<BilinearWeights> weights_;
  Wall wall_;
};

}  // namespace

double Wall::at(const Vec2d& place) const {
  const BilinearWeights near = bilinear_weights(*this, place);
  double out = 0;
  for (size_t k = 0; k < 4; ++k) out += near.part[k] * depths[static_cast<size_t>(near.node[k])];
  return out;
}

Wall fit_wall(const RangeImage& range, const WallOptions& options,
              const std::vector<uint8_t>& only) {
  for (const double number : {options.step, options.cell, options.noise, options.stiffness})
    if (!(number > 0 && std::isfinite(number)))
      throw Error(ErrorCode::bad_input, "the options of the wall surface must be above 0");
  return WallFitter(range, options, cell_depths(range, options.cell, only)).fit();
}

}  // namespace vug::scan
