// SPDX-License-Identifier: Apache-2.0
#include <vug/base/cell.h>
#include <vug/base/maths.h>
#include <vug/field/box_lanes.h>
#include <vug/field/enclosing_ball.h>
#include <vug/field/speleothems/deposits.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace vug::field {
namespace {

/// The greatest slope of (1 - x^2)^2, at x = 1 / sqrt(3).
constexpr double kProfileSlope = 1.5396007178;
constexpr double kCell = 0.4;  // Side of the cells of the grid in metres.
/// A list of at most this number of layers is tested without boxes.
constexpr size_t kFew = 4;

struct Layer {
  Vec3d from, along;
  double inverse;  // 1 / |along|^2, 0 for round layers.
  double width, widening, thickness, thickening;

  explicit Layer(const Deposit& d)
      : from(d.from),
        along(d.to - d.from),
        inverse(along.length2() > 1e-12 ? 1 / along.length2() : 0),
        width(d.half_width_from),
        widening(d.half_width_to - d.half_width_from),
        thickness(d.thickness_from),
        thickening(d.thickness_to - d.thickness_from) {
    const double greatest = std::max(d.thickness_from, d.thickness_to);
    const double narrowest = std::min(d.half_width_from, d.half_width_to);
    const double length = inverse > 0 ? along.length() : kInfinity;
    const double slope = kProfileSlope * greatest / narrowest * (1 + std::fabs(widening) / length) +
                         std::fabs(thickening) / length;
    const double factor =
        std::min({1.0, kSteepestDeposit / slope, kThickestDeposit / std::max(greatest, 1e-9)});
    thickness *= factor, thickening *= factor;
  }
  double widest() const { return width + std::max(widening, 0.0); }
  double greatest() const { return thickness + std::max(thickening, 0.0); }
  Box3d box() const {
    Box3d out(from);
    out.extendBy(from + along);
    return grown(out, widest());
  }
  template <class T>
  T at(const Point<T>& p) const {
    const Point<T> offset = p - constant<T>(from), way = constant<T>(along);
    const T t = clamp(dot(offset, way) * T(inverse), T(0.0), T(1.0));
    const T w = T(width) + T(widening) * t;
    const Point<T> away = offset - way * t;
    const T share = max(T(1.0) - dot(away, away) / square(w), T(0.0));
    return (T(thickness) + T(thickening) * t) * square(share);
  }
  double distance(const Vec3d& p) const {
    const Vec3d offset = p - from;
    return (offset - along * std::clamp(offset.dot(along) * inverse, 0.0, 1.0)).length();
  }
  void add_to(Digester& digester) const {
    digester(from, along, inverse, width, widening, thickness, thickening);
  }
};

class ThicknessNode final : public EvaluationModes<ThicknessNode> {
 public:
  struct Grid {
    std::vector<Layer> layers;
    CellMap<std::vector<int>> cells;
    BoxLanes boxes;
  };

  ThicknessNode(Traits traits, std::shared_ptr<const Grid> grid)
      : EvaluationModes(std::move(traits)), grid_(std::move(grid)) {}
  ThicknessNode(Traits traits, std::vector<Layer> listed)
      : EvaluationModes(std::move(traits)), listed_(std::move(listed)) {
    if (listed_.size() <= kFew) return;
    boxes_.reserve(listed_.size());
    for (const Layer& layer : listed_) boxes_.add(layer.box(), 1, 0);
  }

  template <class T>
  T at(const Point<T>& p) const {
    if constexpr (std::is_same_v<T, Interval>) {
      return restrict_to(enclosing_ball(p)).range;
    } else if constexpr (std::is_same_v<T, double>) {
      return greatest_at(p, Box3d(vector(p)));
    } else {
      return greatest_at(p, Box3d(Vec3d(p.x.v, p.y.v, p.z.v)));
    }
  }
  template <class T>
  void fill(const Point<Pack>* points, int count, T* out, Scratch& scratch) const {
    if (!boxes_.empty()) return fill_listed(points, count, out, scratch);
    for (int i = 0; i < count; ++i)
      out[i] = greatest_at(point_for<T>(points[i]), grid_ ? box_of(points[i]) : Box3d());
  }

  Restriction restrict_to(const Ball& ball) const override {
    const std::vector<Layer>& layers = grid_ ? grid_->layers : listed_;
    const BoxLanes& boxes = grid_ ? grid_->boxes : boxes_;
    std::vector<uint32_t> near;
    if (boxes.empty())
      for (uint32_t i = 0; i < layers.size(); ++i) near.push_back(i);
    else
      boxes.find_candidates(ball, 0, near);
    Interval range(0, 0);
    const double slack = 1e-6 * (1 + ball.centre.length() + ball.radius);
    const double reach = ball.radius + slack;
    std::vector<Layer> kept;
    double middle = 0;
    for (const uint32_t i : near) {
      const Layer& layer = layers[i];
      if (layer.distance(ball.centre) - reach >= layer.widest()) continue;
      range.hi = std::max(range.hi, layer.greatest());
      middle = std::max(middle, layer.at(point(ball.centre)));
      kept.push_back(layer);
    }
    const double change = kSteepestDeposit * ball.radius + slack;
    range.hi = kept.empty() ? 0 : std::min(range.hi, middle + change);
    range.lo = std::max(0.0, middle - change);
    if (2 * kept.size() > layers.size()) return {range, nullptr};  // A copy would not pay.
    return {range, std::make_shared<ThicknessNode>(traits(), std::move(kept))};
  }
  std::string name() const override { return "deposits"; }

 protected:
  void add_to(Digester& digester) const override { digester(grid_ ? grid_->layers : listed_); }

 private:
  /// In ascending order, each once.
  std::vector<int> numbers_in(const Box3d& box) const {
    std::vector<int> out;
    for_each_cell(cell_at(box.min, kCell), cell_at(box.max, kCell), [&](const Cell& cell) {
      const auto found = grid_->cells.find(cell);
      if (found != grid_->cells.end())
        out.insert(out.end(), found->second.begin(), found->second.end());
    });
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
  }
  template <class T>
  static T greatest_of(const std::vector<Layer>& layers, const Point<T>& p) {
    T most(0.0);
    for (const Layer& layer : layers) most = max(most, layer.at(p));
    return most;
  }
  /// Each layer is evaluated at the points that its box may contain.
  template <class T>
  void fill_listed(const Point<Pack>* points, int count, T* out, Scratch& scratch) const {
    constexpr int kMost = BoxLanes::kMostPoints;
    for (; count > kMost; points += kMost, out += kMost, count -= kMost)
      fill_listed(points, kMost, out, scratch);
    Scratch::Frame frame(scratch);
    Pack* limits = frame.template take<Pack>(static_cast<size_t>(count));
    auto* masks = frame.template take<uint64_t>(listed_.size());
    std::fill(out, out + count, T(0.0));
    std::fill(limits, limits + count, Pack(0.0));
    boxes_.find_candidates(points, limits, count, masks);
    for (size_t i = 0; i < listed_.size(); ++i)
      for (uint64_t mask = masks[i]; mask != 0; mask &= mask - 1) {
        const int k = std::countr_zero(mask);
        out[k] = max(out[k], listed_[i].at(point_for<T>(points[k])));
      }
  }
  template <class T>
  T greatest_at(const Point<T>& p, const Box3d& box) const {
    if (!grid_) return greatest_of(listed_, p);
    T most(0.0);
    if (!is_finite(box)) return most;
    const Vec3d size = box.size();
    if (std::max({size.x, size.y, size.z}) > 20 * kCell) {  // Scattered points.
      for (const Layer& layer : grid_->layers) most = max(most, layer.at(p));
      return most;
    }
    for (const int i : numbers_in(box))
      most = max(most, grid_->layers[static_cast<size_t>(i)].at(p));
    return most;
  }
  /// A box around the eight points, with a tolerance for single precision.
  static Box3d box_of(const Point<Pack>& p) {
    Box3d box;
    float x[Pack::kLanes], y[Pack::kLanes], z[Pack::kLanes];
    p.x.store(x), p.y.store(y), p.z.store(z);
    for (int i = 0; i < Pack::kLanes; ++i) box.extendBy(Vec3d(x[i], y[i], z[i]));
    return box;
  }

  std::shared_ptr<const Grid> grid_;
  std::vector<Layer> listed_;
  BoxLanes boxes_;  // Of the listed layers; empty for a few.
};

Traits thickness_traits() { return {kSteepestDeposit, Exactness::sign, infinite_box(), 0}; }

}  // namespace

Deposit Deposit::along(int64_t drip, const Vec3d& from, const Vec3d& to, double section_from,
                       double section_to, const LayerShape& shape) {
  Deposit out{drip, from, to, 0, 0, 0, 0};
  const auto set = [&](double section, double& width, double& thickness) {
    width = std::clamp(std::sqrt(section / (kSectionShare * shape.slenderness)), shape.narrowest,
                       shape.widest);
    thickness = std::min(section / (kSectionShare * width), shape.thickest);
  };
  set(section_from, out.half_width_from, out.thickness_from);
  set(section_to, out.half_width_to, out.thickness_to);
  return out;
}

Deposit Deposit::around(int64_t drip, const Vec3d& at, double volume, const LayerShape& shape) {
  const double width = std::clamp(maths::pow(volume / (kRoundShare * shape.slenderness), 1.0 / 3),
                                  shape.narrowest, shape.widest);
  const double thickness = std::min(volume / (kRoundShare * width * width), shape.thickest);
  return {drip, at, at, width, width, thickness, thickness};
}

Field thickness_field(std::vector<Deposit> deposits) {
  auto grid = std::make_shared<ThicknessNode::Grid>();
  for (const Deposit& deposit : deposits) {
    const Layer layer(deposit);
    if (!(layer.greatest() > 0)) continue;
    const auto number = static_cast<int>(grid->layers.size());
    const Box3d box = layer.box();
    for_each_cell(cell_at(box.min, kCell), cell_at(box.max, kCell),
                  [&](const Cell& cell) { grid->cells[cell].push_back(number); });
    grid->boxes.add(box, 1, 0);
    grid->layers.push_back(layer);
  }
  return Field(std::make_shared<ThicknessNode>(thickness_traits(), std::move(grid)));
}

}  // namespace vug::field
