// SPDX-License-Identifier: Apache-2.0
// The union of the few elements that matter in a part of space, eight points at a time.
#pragma once

#include <vug/field/blend.h>
#include <vug/field/box_lanes.h>
#include <vug/field/enclosing_ball.h>
#include <vug/field/evaluates_below.h>
#include <vug/field/lattice_lanes.h>
#include <vug/field/numbers/value_of.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace vug::field {

/// Elements whose distance from the centre of the ball exceeds this are not among those that
/// determine the union in the ball; `value` is the union's value at the centre. An element that is
/// blended is within the radius of the blend of the nearest one, whose distance is at most the
/// value plus the depth of the blend.
inline double nearby_limit(double value, const Ball& ball, const Blend& blend) {
  const double slack = 1e-6 * (1 + ball.centre.length() + ball.radius);
  return value + blend.depth() + blend.radius + 2 * ball.radius + slack;
}

/// An element and its distance from a point.
template <class E>
struct NearElement {
  double distance;
  const E* element;
};

/// The distance of an element from which on it does not lower values to below `limit`, and does not
/// blend with elements that do.
template <class S>
S element_limit(const S& limit, const Blend& blend) {
  return limit + abs(limit) * S(1e-5) + S(blend.depth() + blend.radius * (1 + 1e-5));
}

/// E as in ElementTree; there is at least one element.
template <class E>
class ElementListNode final : public EvaluationModes<ElementListNode<E>>, public EvaluatesBelow {
 public:
  /// Copies the elements, the nearest first: it is likely that the others are skipped then.
  ElementListNode(Traits traits, std::vector<NearElement<E>>& near, const Blend& blend)
      : EvaluationModes<ElementListNode<E>>(std::move(traits)), blend_(blend) {
    std::stable_sort(near.begin(), near.end(),
                     [](const auto& a, const auto& b) { return a.distance < b.distance; });
    elements_.reserve(near.size());
    for (const NearElement<E>& each : near) {
      elements_.push_back(*each.element);
      balls_.push_back(each.element->ball());
    }
    if (elements_.size() <= kFew) return;
    boxes_.reserve(balls_.size());
    for (const Ball& ball : balls_)
      boxes_.add(grown(Box3d(ball.centre), ball.radius), 1, 2 * ball.radius);
  }

  template <class T>
  T at(const Point<T>& p) const {
    if constexpr (std::is_same_v<T, Interval>) {
      const Ball ball = enclosing_ball(p);
      return this->centre_form(at(point(ball.centre)), ball);
    } else {
      T first(kFar), second(kFar);
      for (const E& element : elements_) keep(element.distance(p), first, second);
      return blended(first, second);
    }
  }
  template <class T>
  void fill(const Point<Pack>* points, int count, T* out, Scratch& scratch) const {
    std::fill(out, out + count, T(kFar));
    add_elements(points, count, out, scratch);
  }
  void eval_below(const Point<Pack>* points, const Pack* limits, int count, Pack* out,
                  Scratch& scratch) const override {
    for (int k = 0; k < count; ++k) out[k] = element_limit(limits[k], blend_);
    add_elements(points, count, out, scratch);
  }
  void eval_below(const Point<Pack>* points, const Pack* limits, int count, Dual<Pack>* out,
                  Scratch& scratch) const override {
    for (int k = 0; k < count; ++k)
      out[k] = without_derivatives<Dual<Pack>>(element_limit(limits[k], blend_));
    add_elements(points, count, out, scratch);
  }
  Restriction restrict_below(const Ball& ball, double) const override { return restrict_to(ball); }
  Restriction restrict_to(const Ball& ball) const override {
    const double value = at(point(ball.centre));
    Restriction out{this->centre_form(value, ball), nullptr};
    const double limit = nearby_limit(value, ball, blend_);
    std::vector<NearElement<E>> near;
    for (size_t k = 0; k < elements_.size(); ++k) {
      if ((balls_[k].centre - ball.centre).length() - balls_[k].radius > limit) continue;
      const double distance = elements_[k].distance(point(ball.centre));
      if (distance <= limit) near.push_back({distance, &elements_[k]});
    }
    if (2 * near.size() <= elements_.size())  // A copy for fewer would not pay.
      out.node = std::make_shared<ElementListNode>(this->traits(), near, blend_);
    return out;
  }
  std::string name() const override { return "elements"; }

 protected:
  void add_to(Digester& digester) const override { digester(elements_, blend_); }

 private:
  static constexpr double kFar = 1e6;  ///< As the value of the empty field.

  static constexpr size_t kFew = 16;  ///< A test of the boxes of these would not pay.

  /// The union of the elements with elements at the distances `out`.
  template <class T>
  void add_elements(const Point<Pack>* points, int count, T* out, Scratch& scratch) const {
    constexpr int kMost = BoxLanes::kMostPoints;
    for (; count > kMost; points += kMost, out += kMost, count -= kMost)
      add_elements(points, kMost, out, scratch);
    const auto size = static_cast<size_t>(count);
    Scratch::Frame frame(scratch);
    T* second = frame.template take<T>(size);
    Pack* limits = frame.template take<Pack>(size);
    auto* masks = frame.template take<uint64_t>(elements_.size());
    std::copy(out, out + count, second);
    const auto add = [&](size_t i, int k) {
      const Point<Pack> away = points[k] - constant<Pack>(balls_[i].centre);
      const Pack reach = max(bound(out[k], second[k]) + Pack(balls_[i].radius), Pack(0.0));
      if (any_lane(dot(away, away) < square(reach)))
        keep(elements_[i].distance(point_for<T>(points[k])), out[k], second[k]);
    };
    if (boxes_.empty()) {
      for (int k = 0; k < count; ++k)
        for (size_t i = 0; i < elements_.size(); ++i) add(i, k);
    } else {
      for (int k = 0; k < count; ++k) {
        add(0, k);
        limits[k] = bound(out[k], second[k]);
      }
      boxes_.find_candidates(points, limits, count, masks);
      for (size_t i = 1; i < elements_.size(); ++i)
        for (uint64_t mask = masks[i]; mask != 0; mask &= mask - 1) add(i, std::countr_zero(mask));
    }
    for (int k = 0; k < count; ++k) out[k] = blended(out[k], second[k]);
  }
  template <class T>
  void keep(const T& distance, T& first, T& second) const {
    if (blend_.radius > 0) second = min(second, max(first, distance));
    first = min(first, distance);
  }
  template <class T>
  T blended(const T& first, const T& second) const {
    return blend_.radius > 0 ? blend_.smin(first, second) : first;
  }
  /// Elements that are nowhere below it change nothing. A margin covers single precision.
  Pack bound(const Pack& first, const Pack& second) const {
    const Pack most = blend_.radius > 0 ? min(second, first + Pack(blend_.radius)) : first;
    return most + Pack(1e-5);
  }
  Pack bound(const Dual<Pack>& first, const Dual<Pack>& second) const {
    return bound(first.v, second.v);
  }

  std::vector<E> elements_;
  std::vector<Ball> balls_;  ///< One around each element.
  BoxLanes boxes_;           ///< Around the balls; empty for a few.
  Blend blend_;
};

}  // namespace vug::field
