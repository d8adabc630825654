// SPDX-License-Identifier: Apache-2.0
// The node of a sweep: all segments, or those that matter in the ball to which it was restricted.
#include <vug/base/error.h>
#include <vug/field/enclosing_ball.h>
#include <vug/field/thickness.h>
#include <vug/passages/sweep/batch_minimum.h>
#include <vug/passages/sweep/block_minimum.h>
#include <vug/passages/sweep/lower_bounds.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <type_traits>
#include <utility>

namespace vug::passages {
namespace {

using field::Ball;

using PartsPtr = std::shared_ptr<const SweepParts>;

/// Points are evaluated with the BVH of the whole sweep, which finds segments faster than a list,
/// where a restriction has more segments.
constexpr size_t kMostActive = 256;

/// A segment of a set whose value at the point is known.
struct Known {
  uint32_t segment = 0;
  double value = 0;
};

/// Segments whose bound exceeds the least value so far by the radius of the widest joint are left
/// out.
template <class T>
T evaluate(const SweepParts& parts, const ActiveSet& set, const Point<T>& p,
           const Known* known = nullptr) {
  thread_local std::vector<T> arms;
  if (arms.size() < set.arms) arms.resize(set.arms);
  Minimum<T> minimum(set, arms.data());
  const Vec3d at(value_of(p.x), value_of(p.y), value_of(p.z));
  double least = known ? known->value : kFar;
  for (size_t i = 0; i < set.segments.size(); ++i) {
    const bool is_known = known && known->segment == set.segments[i];
    if constexpr (std::is_same_v<T, double>)
      if (is_known) {
        minimum.combine(i, known->value);
        continue;
      }
    const Segment& segment = parts.sweep.segments[set.segments[i]];
    if (!is_known && segment.least(at) > least + parts.widest_joint + segment.rounding(at))
      continue;
    const T value = segment.at(p);
    least = std::min(least, value_of(value));
    minimum.combine(i, value);
  }
  return minimum.finish();
}

template <class T>
void evaluate(const SweepParts& parts, const ActiveSet& set, const Point<Pack>* points, int count,
              T* out, field::Scratch& scratch) {
  if (set.segments.size() == 1)
    return parts.sweep.segments[set.segments[0]].fill(points, count, out, scratch);
  BatchMinimum<T>(parts, set, points, count, scratch).run(out);
}

class SweepNode final : public field::EvaluationModes<SweepNode>,
                        public field::VariesInThickness,
                        public field::NearSurface {
 public:
  SweepNode(field::Traits traits, PartsPtr parts)
      : EvaluationModes(std::move(traits)), parts_(std::move(parts)), whole_(true), many_(true) {}
  SweepNode(field::Traits traits, PartsPtr parts, ActiveSet active)
      : EvaluationModes(std::move(traits)),
        parts_(std::move(parts)),
        active_(std::move(active)),
        many_(active_.segments.size() > kMostActive) {}

  template <class T>
  T at(const Point<T>& p) const {
    return many_ ? at(p, parts_->bvh.nearest(centre_of(p))) : evaluate(*parts_, linked(), p);
  }
  /// The value of the whole, given the segment with the least value at the point.
  template <class T>
  T at(const Point<T>& p, const SegmentBvh::Nearest& nearest) const {
    thread_local ActiveSet near;
    const Vec3d centre = centre_of(p);
    near.segments.clear();
    if (parts_->widest_joint > 0) {
      collect({centre, 0}, nearest.value, parts_->sweep.segments.size(), near.segments);
      complete(*parts_, near);
      const Known known{nearest.segment, nearest.value};
      if (!near.joints.empty()) return evaluate(*parts_, near, p, &known);
    }
    if constexpr (std::is_same_v<T, double>)
      return nearest.value;
    else
      return parts_->sweep.segments[nearest.segment].at(p);
  }
  Interval at(const Point<Interval>& p) const {
    const Ball ball = field::enclosing_ball(p);
    return centre_form(at(field::point(ball.centre)), ball);
  }

  template <class T>
  void fill(const Point<Pack>* points, int count, T* out, field::Scratch& scratch) const {
    if (!many_) return evaluate(*parts_, linked(), points, count, out, scratch);
    fill_near(points, count, out, scratch);
  }

  field::Restriction restrict_to(const Ball& ball) const override;
  field::Restriction restrict_near(const Ball& ball, double limit) const override;
  field::BlockRange first_order(const field::LatticeBlock& block, double limit,
                                const field::FirstOrderRuns& out,
                                field::Scratch& scratch) const override;
  std::string name() const override { return "passages"; }
  std::optional<Thin> thinner_than(double thickness) const override;

 protected:
  void add_to(Digester& digester) const override {
    digester(parts_->sweep, active_.segments, whole_);
  }

 private:
  /// The active set with its links, which are found when they are needed: nodes that are only
  /// restricted further, or evaluated in blocks, do not need them.
  const ActiveSet& linked() const {
    std::call_once(linking_, [&] { link(*parts_, active_); });
    return active_;
  }
  static Vec3d centre_of(const Point<double>& p) { return field::vector(p); }
  static Vec3d centre_of(const Point<Dual<double>>& p) { return {p.x.v, p.y.v, p.z.v}; }

  /// Segments that can matter in the ball, in which the field is at most `least` + radius: a joint
  /// has no effect where its arms differ by more than its radius. False beyond `most` segments.
  bool collect(const Ball& ball, double least, size_t most, std::vector<uint32_t>& out) const {
    return parts_->bvh.collect(ball.centre, limit(ball, least), most, out);
  }
  double limit(const Ball& ball, double least) const {
    return least + 2 * ball.radius + parts_->widest_joint + tolerance(ball.centre, ball.radius);
  }

  template <class T>
  void fill_near(const Point<Pack>* points, int count, T* out, field::Scratch& scratch) const;

  PartsPtr parts_;
  mutable ActiveSet active_;  // Empty for the whole sweep.
  mutable std::once_flag linking_;
  bool whole_ = false;
  bool many_ = false;  // Points are evaluated with the BVH.
};

/// Batches of points that are far apart are divided, down to one pack.
template <class T>
void SweepNode::fill_near(const Point<Pack>* points, int count, T* out,
                          field::Scratch& scratch) const {
  constexpr size_t kFew = 24;
  const Ball ball = box_around(points, static_cast<size_t>(count)).ball();
  ActiveSet near;
  const size_t most = count > 1 ? kFew : parts_->sweep.segments.size();
  if (!collect(ball, parts_->bvh.nearest(ball.centre).value, most, near.segments)) {
    fill_near(points, count / 2, out, scratch);
    return fill_near(points + count / 2, count - count / 2, out + count / 2, scratch);
  }
  complete(*parts_, near);
  evaluate(*parts_, near, points, count, out, scratch);
}

/// Distances to the axes select the segments, so few of them are evaluated: those that can be the
/// minimum at the centre of the ball, from which the range follows.
field::Restriction SweepNode::restrict_to(const Ball& ball) const {
  const Point<double> centre = field::point(ball.centre);
  const auto& segments = parts_->sweep.segments;
  thread_local ActiveSet listed, middle;
  const ActiveSet* list = &active_;
  if (whole_) {
    listed.clear();
    const double value = parts_->bvh.nearest(ball.centre).value;
    list = collect(ball, value, kMostActive, listed.segments) ? &listed : &parts_->all;
    if (list == &listed) fill_capsules(*parts_, listed);
  }
  const ActiveSet& candidates = *list;
  const LowerBounds lower(candidates, ball.centre);
  const uint32_t nearest = candidates.segments[lower.nearest()];
  const Known known{nearest, segments[nearest].value(centre)};
  const double limit = known.value + tolerance(ball.centre, ball.radius);
  middle.clear();
  lower.append_below(limit, middle);
  link(*parts_, middle);
  const Interval range = centre_form(evaluate(*parts_, middle, centre, &known), ball);
  const double highest = limit + 2 * ball.radius;
  const size_t count = lower.count_below(highest);
  if (count == candidates.segments.size() && list != &listed) return {range, nullptr};
  ActiveSet active;
  active.reserve(count);
  lower.append_below(highest, active);
  return {range, std::make_shared<SweepNode>(traits(), parts_, std::move(active))};
}

/// The bounds of the axes decide, without the value of a segment unless the ball can be inside.
field::Restriction SweepNode::restrict_near(const Ball& ball, double limit) const {
  const double rounding = tolerance(ball.centre, ball.radius),
               most = limit + ball.radius + rounding;
  thread_local ActiveSet listed;
  const ActiveSet* list = &active_;
  if (whole_) {
    listed.clear();
    if (!parts_->bvh.collect(ball.centre, limit_with_fillet(most, parts_->widest_joint),
                             kMostActive, listed.segments))
      return restrict_to(ball);
    fill_capsules(*parts_, listed);
    list = &listed;
  }
  const LowerBounds lower(*list, ball.centre);
  const size_t count = lower.count_near(most);
  if (count == 0) return {{limit + rounding, kInfinity}, nullptr};
  // No value of the sweep is above that of a segment.
  Interval range(-kInfinity, kInfinity);
  if (const size_t nearest = lower.nearest(); lower.bound(nearest) < -most) {
    const Segment& segment = parts_->sweep.segments[list->segments[nearest]];
    range.hi = centre_form(segment.value(field::point(ball.centre)), ball).hi;
  }
  if (count == list->segments.size() && list != &listed) return {range, nullptr};
  ActiveSet active;
  active.reserve(count);
  lower.append_near(most, active);
  return {range, std::make_shared<SweepNode>(traits(), parts_, std::move(active))};
}

field::BlockRange SweepNode::first_order(const field::LatticeBlock& block, double limit,
                                         const field::FirstOrderRuns& out,
                                         field::Scratch& scratch) const {
  if (!many_) return first_order_minimum({*parts_, block, limit, scratch}, active_, out);
  thread_local ActiveSet near;
  const Ball ball = block.ball();
  const double most = limit + ball.radius + tolerance(ball.centre, ball.radius);
  near.segments.clear();
  parts_->bvh.collect(ball.centre, limit_with_fillet(most, parts_->widest_joint),
                      parts_->sweep.segments.size(), near.segments);
  fill_capsules(*parts_, near);
  return first_order_minimum({*parts_, block, limit, scratch}, near, out);
}

std::optional<field::VariesInThickness::Thin> SweepNode::thinner_than(double thickness) const {
  Thin thin{.thickness = kInfinity};
  double whole = 0, part = 0;
  for (const Segment& segment : parts_->sweep.segments) {
    const double length = (segment.end() - segment.start()).length();
    const auto [size, at] = segment.thinnest();
    whole += length;
    if (!(size < thickness)) continue;
    part += length;
    if (size < thin.thickness) {
      thin.thickness = size;
      thin.at = at;
    }
  }
  if (part == 0) return std::nullopt;
  thin.share = part / whole;
  return thin;
}

field::Traits sweep_traits(const Sweep& sweep) {
  field::Traits traits;
  double scale = 1, widest = 0;
  bool uniform = true;
  for (const Segment& segment : sweep.segments) {
    traits.bounds = united(traits.bounds, segment.bounds());
    scale = std::min(scale, segment.scale());
    uniform = uniform && segment.uniform();
  }
  for (const Joint& joint : sweep.joints) widest = std::max(widest, joint.radius);
  const double bulge = field::Blend{field::Profile::smooth, widest}.depth();
  traits.bounds = grown(traits.bounds, bulge / scale);
  traits.growth = scale;
  traits.exactness =
      uniform && sweep.joints.empty() ? field::Exactness::eikonal : field::Exactness::bound;
  return traits;
}

}  // namespace

field::Field sweep(Sweep parts) {
  if (parts.segments.empty())
    throw Error(ErrorCode::bad_input, "a network without legs has no passages", {},
                "add at least one leg between two stations");
  field::Traits traits = sweep_traits(parts);
  return field::Field(std::make_shared<SweepNode>(
      std::move(traits), std::make_shared<const SweepParts>(std::move(parts))));
}

}  // namespace vug::passages
