// SPDX-License-Identifier: Apache-2.0
// The field f of a floor with the cosine c of its slope is c (y - z0) near it, with the height z0
// of the smooth floor at that place. Where it faces up, it is replaced by c (y - Z(z0)) with the
// terraces Z: their crests are level, because Z is a height and not a displacement.
#include <vug/field/speleothems/rimstone_params.h>

#include <algorithm>
#include <cmath>

namespace vug::field {
namespace {

constexpr double kCosine = kTerraceCosine;
/// Floors have a vertical part of their normal above the last number; terraces begin at the first.
constexpr double kSteepest = 0.55, kFloor = 0.8;
/// The greatest slope of a smoothstep.
constexpr double kStepSlope = 1.5;

class RimstoneNode final : public EvaluationModes<RimstoneNode> {
 public:
  RimstoneNode(Traits traits, NodePtr rock, Noise lobes, const RimstoneParams& p, bool water)
      : EvaluationModes(std::move(traits)),
        rock_(std::move(rock)),
        lobes_(std::move(lobes)),
        p_(p),
        water_(water) {}

  /// Bounds of the difference between the terraces and the smooth floor.
  static double reach(const RimstoneParams& p) { return p.height * (1.2 + p.depth + p.lobes); }
  static Traits traits_of(const Traits& rock, const Noise& lobes, const RimstoneParams& p) {
    Traits out = rock;
    // Of u, in metres; of the terraces; of the weight, which depends on a difference over `feel`.
    const double height =
        1 + rock.lipschitz / kCosine + p.lobes * p.height * lobes.field.lipschitz();
    const double terraces = (1 + p.depth) * kStepSlope / (1 - kOuterFace) + 1;
    const double weight = kStepSlope / (kFloor - kSteepest) * rock.lipschitz / feel(p);
    out.lipschitz += kCosine * (terraces + 1) * height + reach(p) * weight;
    out.exactness = Exactness::sign;
    out.bounds = rock.bounds_below(reach(p));
    out.growth = rock.growth_rate();
    return out;
  }

  template <class T>
  T at(const Point<T>& p) const {
    if constexpr (std::is_same_v<T, Interval>) {
      return rock_->eval(p) + Interval(-reach(p_), reach(p_));
    } else {
      const T h(feel(p_));
      return changed(p, rock_->eval(p), rock_->eval(Point<T>{p.x, p.y + h, p.z}),
                     rock_->eval(Point<T>{p.x, p.y - h, p.z}), lobes_.field.node()->eval(p));
    }
  }
  template <class T>
  void fill(const Point<Pack>* points, int count, T* out, Scratch& scratch) const {
    Scratch::Frame frame(scratch);
    const auto size = static_cast<size_t>(count);
    auto* moved = frame.template take<Point<Pack>>(size);
    T* above = frame.template take<T>(size);
    T* below = frame.template take<T>(size);
    T* lobe = frame.template take<T>(size);
    const Pack h(feel(p_));
    for (int i = 0; i < count; ++i) moved[i] = {points[i].x, points[i].y + h, points[i].z};
    rock_->eval(moved, count, above, scratch);
    for (int i = 0; i < count; ++i) moved[i].y = points[i].y - h;
    rock_->eval(moved, count, below, scratch);
    lobes_.field.node()->eval(points, count, lobe, scratch);
    rock_->eval(points, count, out, scratch);
    for (int i = 0; i < count; ++i)
      out[i] = changed(point_for<T>(points[i]), out[i], above[i], below[i], lobe[i]);
  }
  Restriction restrict_to(const Ball& ball) const override {
    const Restriction near = rock_->restrict_to(ball);
    Restriction out{near.range + Interval(-reach(p_), reach(p_)), nullptr};
    const NodePtr inner = rock_->restrict_to({ball.centre, ball.radius + feel(p_)}).node;
    if (inner) out.node = std::make_shared<RimstoneNode>(traits(), inner, lobes_, p_, water_);
    return out;
  }
  std::string name() const override { return water_ ? "rimstone_water" : "rimstone"; }
  std::vector<NodePtr> children() const override { return {rock_, lobes_.field.node()}; }

 protected:
  void add_to(Digester& digester) const override {
    digester(rock_, lobes_, p_.height, p_.depth, p_.lobes, p_.lobe_size, water_);
  }

 private:
  static double feel(const RimstoneParams& p) { return 0.8 * p.height; }

  template <class T>
  T changed(const Point<T>& p, const T& rock, const T& above, const T& below, const T& lobe) const {
    const T up = (above - below) * T(0.5 / feel(p_));
    const T weight = terrace_step((up - T(kSteepest)) * T(1 / (kFloor - kSteepest)));
    // Lobes are round about the points of worley's noise.
    const T u = (p.y - rock * T(1 / kCosine)) * T(1 / p_.height) + lobe * T(p_.lobes);
    const T level = (water_ ? terrace_water(u, p_.depth) : terrace(u, p_.depth)) * T(p_.height);
    const T there = (p.y - level) * T(kCosine);
    // Elsewhere the water lies within the rock.
    const T other = water_ ? rock + T(0.5 * p_.height) : rock;
    return other + weight * clamp(there - rock, T(-reach(p_)), T(reach(p_))) -
           (water_ ? weight * T(0.5 * p_.height) : T(0.0));
  }

  NodePtr rock_;
  Noise lobes_;
  RimstoneParams p_;
  bool water_;
};

Field terraced(const RimstoneParams& p, bool water) {
  const Noise lobes = make_noise("worley", {{"scale", p.lobe_size}, {"seed", p.seed}});
  return Field(
      std::make_shared<RimstoneNode>(RimstoneNode::traits_of(p.field.node()->traits(), lobes, p),
                                     p.field.node(), lobes, p, water));
}

}  // namespace

Field rimstone(const RimstoneParams& params) { return terraced(params, false); }
Field rimstone_water(const RimstoneParams& params) { return terraced(params, true); }

}  // namespace vug::field
