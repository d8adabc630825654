// SPDX-License-Identifier: Apache-2.0
#include <vug/field/enclosing_ball.h>
#include <vug/field/evaluates_below.h>
#include <vug/field/lattice_lanes.h>
#include <vug/field/speleothems/facet.h>
#include <vug/field/speleothems/sheet.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <memory>
#include <type_traits>

namespace vug::field {
namespace {

/// Consecutive facets within a ball that also contains their thickness.
struct Group {
  Vec3d centre{0.0};
  double radius = 0;
  size_t begin = 0, end = 0;

  /// A lower bound of the values of its facets.
  template <class S>
  S bound(const Point<S>& p) const {
    return length(p - constant<S>(centre)) * S(1 - 1e-6) - S(radius * (1 + 1e-6) + 1e-9);
  }
};

constexpr size_t kGroup = 12;

class SheetNode final : public EvaluationModes<SheetNode>, public EvaluatesBelow {
 public:
  SheetNode(Traits traits, std::string name, std::vector<Facet<double>> facets)
      : EvaluationModes(std::move(traits)), name_(std::move(name)), facets_(std::move(facets)) {
    single_.reserve(facets_.size());
    for (const Facet<double>& facet : facets_) single_.push_back(facet.as<float>());
    for (size_t begin = 0; begin < facets_.size(); begin += kGroup) {
      Group group{.begin = begin, .end = std::min(begin + kGroup, facets_.size())};
      Box3d box;
      for (size_t i = begin; i < group.end; ++i) box.extendBy(box_of(facets_[i]));
      group.centre = box.center();
      group.radius = 0.5 * box.size().length();
      groups_.push_back(group);
    }
  }

  /// Groups that cannot contain the least value are not evaluated. Derivatives are computed for the
  /// facets with the least value only.
  template <class T>
  T at(const Point<T>& p) const {
    using S = std::decay_t<decltype(value_of(p.x))>;
    const Point<S> q{value_of(p.x), value_of(p.y), value_of(p.z)};
    S least = facet<S>(0).distance(q), which(0.0);
    find_nearest(q, least, which);
    if constexpr (std::is_same_v<T, S>)
      return least;
    else
      return facets_at(which).distance(p);
  }
  Interval at(const Point<Interval>& p) const {
    const Ball ball = enclosing_ball(p);
    return centre_form(at(field::point(ball.centre)), ball);
  }
  template <class T>
  void fill(const Point<Pack>* points, int count, T* out, Scratch&) const {
    for (int i = 0; i < count; ++i) out[i] = at(point_for<T>(points[i]));
  }
  void eval_below(const Point<Pack>* points, const Pack* limits, int count, Pack* out,
                  Scratch&) const override {
    for (int i = 0; i < count; ++i) {
      Pack which(-1.0);
      out[i] = limits[i];
      find_nearest(points[i], out[i], which);
    }
  }
  void eval_below(const Point<Pack>* points, const Pack* limits, int count, Dual<Pack>* out,
                  Scratch&) const override {
    for (int i = 0; i < count; ++i) {
      Pack least = limits[i], which(-1.0);
      find_nearest(points[i], least, which);
      out[i] = without_derivatives<Dual<Pack>>(least);
      const PackMask found = which >= Pack(0.0);
      if (any(found))
        out[i] =
            select(found, facets_at(max(which, Pack(0.0))).distance(seeded(points[i])), out[i]);
    }
  }
  Restriction restrict_below(const Ball& ball, double) const override { return restrict_to(ball); }
  /// Keeps the facets that can be nearest within the ball, the nearest to its centre first.
  Restriction restrict_to(const Ball& ball) const override {
    const Point<double> centre = field::point(ball.centre);
    const double least = at(centre);
    const Interval range = centre_form(least, ball);
    if (!(ball.radius < 1e6)) return {range, nullptr};
    const double slack = 1e-6 * (1 + ball.centre.length() + ball.radius);
    const double reach = 2 * traits().lipschitz * (ball.radius + slack);
    std::vector<Facet<double>> kept;
    for (const Group& group : groups_) {
      if (group.bound(centre) > least + reach) continue;
      for (size_t i = group.begin; i < group.end; ++i) {
        const double value = facets_[i].distance(centre);
        if (value > least + reach) continue;
        kept.push_back(facets_[i]);
        if (value <= least) std::swap(kept.front(), kept.back());
      }
    }
    if (kept.empty() || kept.size() == facets_.size()) return {range, nullptr};
    return {range, std::make_shared<SheetNode>(traits(), name_, std::move(kept))};
  }
  std::string name() const override { return name_; }

 protected:
  void add_to(Digester& digester) const override { digester(name_, facets_); }

 private:
  /// Lowers `least` to the least value of the facets that is below it, and `which` to their index.
  template <class S>
  void find_nearest(const Point<S>& p, S& least, S& which) const {
    for (const Group& group : groups_) {
      if (!any_lane(group.bound(p) < least)) continue;
      for (size_t i = group.begin; i < group.end; ++i) {
        const S value = facet<S>(i).distance(p);
        which = select(value < least, S(static_cast<double>(i)), which);
        least = min(least, value);
      }
    }
  }
  template <class S>
  Facet<S> facet(size_t i) const {
    if constexpr (std::is_same_v<S, double>)
      return facets_[i];
    else
      return single_[i].template as<S>();
  }
  const Facet<double>& facets_at(double which) const { return facets_[static_cast<size_t>(which)]; }
  /// A facet for each lane.
  Facet<Pack> facets_at(const Pack& which) const {
    using Numbers = std::array<float, sizeof(Facet<float>) / sizeof(float)>;
    using Packs = std::array<Pack, sizeof(Facet<Pack>) / sizeof(Pack)>;
    float index[Pack::kLanes], lanes[std::tuple_size_v<Numbers>][Pack::kLanes];
    which.store(index);
    for (int k = 0; k < Pack::kLanes; ++k) {
      const auto numbers = std::bit_cast<Numbers>(single_[static_cast<size_t>(index[k])]);
      for (size_t n = 0; n < numbers.size(); ++n) lanes[n][k] = numbers[n];
    }
    Packs out;
    for (size_t n = 0; n < out.size(); ++n) out[n] = Pack::load(lanes[n]);
    return std::bit_cast<Facet<Pack>>(out);
  }

  std::string name_;
  std::vector<Facet<double>> facets_;
  std::vector<Facet<float>> single_;  // The same in single precision.
  std::vector<Group> groups_;
};

Field sheet_of(const std::string& name, std::vector<Facet<double>> facets) {
  Traits traits;
  double slope = 0;
  for (const Facet<double>& facet : facets) {
    traits.bounds.extendBy(box_of(facet));
    slope = std::max(slope, field::slope(facet));
  }
  traits.lipschitz = 1 + slope;
  traits.exactness = slope > 0 ? Exactness::sign : Exactness::eikonal;
  // The box of a facet exceeds that of its triangle by the greatest radius, which no radius
  // exceeds.
  traits.growth = 1;
  return Field(std::make_shared<SheetNode>(traits, name, std::move(facets)));
}

}  // namespace

Field sheet_field(const std::string& name, const Sheet& sheet) {
  const auto across = static_cast<size_t>(sheet.across);
  std::vector<Facet<double>> facets;
  for (size_t i = 0; i + across < sheet.corners.size(); ++i) {
    if (i % across == across - 1) continue;
    const auto add = [&](size_t a, size_t b, size_t c) {
      const std::array<Vec3d, 3> p{sheet.corners[a], sheet.corners[b], sheet.corners[c]};
      if ((p[1] - p[0]).cross(p[2] - p[0]).length2() > 1e-24)
        facets.push_back(make_facet(p, std::array{sheet.radii[a], sheet.radii[b], sheet.radii[c]}));
    };
    add(i, i + 1, i + across);
    add(i + across + 1, i + across, i + 1);
  }
  return facets.empty() ? Field() : sheet_of(name, std::move(facets));
}

}  // namespace vug::field
