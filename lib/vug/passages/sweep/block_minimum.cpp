// SPDX-License-Identifier: Apache-2.0
// Each segment is evaluated at the voxels at which its lower bound is below the limit and below the
// minimum so far. They are packed without gaps, because thin passages cross most runs of a block
// with a few voxels, and most voxels have one segment that matters.
#include <vug/passages/sweep/block_minimum.h>
#include <vug/passages/sweep/packed_lanes.h>

#include <algorithm>
#include <array>
#include <type_traits>

namespace vug::passages {
namespace {

using field::FirstOrder;
using field::LatticeBlock;

constexpr size_t kRuns = LatticeBlock::kRuns;

/// A result of type T for each run of a block, as one array for each of its numbers.
template <class T>
class Results {
 public:
  static constexpr size_t kNumbers = numbers_of(static_cast<const T*>(nullptr));
  /// The arrays have room for kRuns packs each.
  explicit Results(const std::array<Pack*, kNumbers>& numbers) : numbers_(numbers) {
    constexpr bool kDistances = std::is_same_v<T, FirstOrder>;
    std::fill_n(numbers_[0], kRuns, Pack(kFar));
    for (size_t i = 1; i < kNumbers; ++i)
      std::fill_n(numbers_[i], kRuns, Pack(kDistances ? kFar : 0.0));
  }
  Pack* number(size_t i) const { return numbers_[i]; }
  const Pack* values() const { return numbers_[0]; }
  /// Takes over the lanes in which a segment has less.
  void combine(const PackedLanes& lanes) {
    for (size_t i = 0; i < lanes.runs(); ++i) {
      const PackedLanes::Run& run = lanes.run(i);
      const Pack value = lanes.result(0, run);
      const field::PackMask less = mask_of(run.lanes) & (value < numbers_[0][run.run]);
      for (size_t k = 0; k < kNumbers; ++k) {
        Pack& known = numbers_[k][run.run];
        known = select(less, lanes.result(k, run), known);
      }
    }
  }

 private:
  std::array<Pack*, kNumbers> numbers_;
};

Dual<Pack> dual_at(const Results<Dual<Pack>>& results, size_t run) {
  return {results.number(0)[run], results.number(1)[run], results.number(2)[run],
          results.number(3)[run]};
}

/// A segment of the set with a lower bound of its values in the block.
struct Bounded {
  float least = 0, fillet = 0;
  uint32_t segment = 0;
  bool operator<(const Bounded& other) const {  // A total order.
    return least < other.least || (least == other.least && segment < other.segment);
  }
};

/// Fills `out` with the segments that can matter, the nearest first; returns their number. The
/// plane across the offset of the middle from the axis bounds the distances of the block from the
/// axis.
size_t near_segments(const BlockTask& task, const ActiveSet& set, Bounded* out) {
  using field::max;
  const double half = 3.5 * task.block.step;
  const Vec3d middle = task.block.ball().centre;
  const Point<Pack> centre = field::constant<Pack>(middle),
                    size = field::constant<Pack>(Vec3d(half));
  const Pack rounding(1e-5 * (1 + middle.length() * 0.1 + half)), most(task.limit),
      fillets(limit_with_fillet(0, 1));
  size_t count = 0;
  for (size_t k = 0; k < set.capsules.packs(); ++k) {
    const CapsulePack capsule = set.capsules.pack(k);
    const Point<Pack> offset = capsule.offset(centre);
    const Pack distance = field::length(offset),
               depth = dot(abs(offset), size) / max(distance, Pack(1e-18)),
               bound = capsule.least_at(distance - depth) - rounding;
    float least[Pack::kLanes], fillet[Pack::kLanes];
    capsule.least_at(distance).store(least);
    capsule.fillet.store(fillet);
    for (unsigned lanes = bits_of(bound <= most + fillets * capsule.fillet); lanes != 0;
         lanes &= lanes - 1) {
      const auto lane = static_cast<size_t>(std::countr_zero(lanes));
      const size_t i = Pack::kLanes * k + lane;
      if (i < set.segments.size())
        out[count++] = {least[lane], fillet[lane], static_cast<uint32_t>(i)};
    }
  }
  std::sort(out, out + count);
  return count;
}

/// True if a block lies inside of one of the nearest segments, beyond the limit. Small blocks of
/// wide passages often do.
bool contains_block(const BlockTask& task, const ActiveSet& set, const Bounded* near,
                    size_t count) {
  constexpr size_t kTried = 2;
  const field::Ball ball = task.block.ball();
  const double reach = task.limit + ball.radius + tolerance(ball.centre, ball.radius);
  const Point<double> centre = field::point(ball.centre);
  return std::any_of(near, near + std::min(count, kTried), [&](const Bounded& at) {
    return static_cast<double>(at.least) < -reach &&
           task.parts.sweep.segments[set.segments[at.segment]].value(centre) < -reach;
  });
}

/// Some segments of a set, in the order of their evaluation.
struct NearSegments {
  const ActiveSet& set;
  Bounded* first;
  size_t count;
  Bounded* begin() const { return first; }
  Bounded* end() const { return first + count; }
};

PackedLanes& packed_lanes() {
  thread_local PackedLanes lanes;
  return lanes;
}

/// The minimum of the segments in `out`, and that of each arm in `arms` if joints matter.
template <class T>
void find_minimum(const BlockTask& task, const NearSegments& near, Results<T>& out,
                  Results<T>* arms) {
  PackedLanes& lanes = packed_lanes();
  for (const Bounded& at : near) {
    const Segment& segment = task.parts.sweep.segments[near.set.segments[at.segment]];
    const double fillet = arms ? static_cast<double>(at.fillet) : 0;
    segment.pack_below(task.block, limit_with_fillet(task.limit, fillet), fillet,
                       &at == near.begin() ? nullptr : out.values(), lanes);
    if (lanes.runs() == 0) continue;
    segment.fill_packed<T>(lanes, task.scratch);
    out.combine(lanes);
    if (!arms) continue;
    for (const ActiveSet::Link& link : near.set.links)
      if (link.segment == at.segment) arms[link.arm].combine(lanes);
  }
}

void find_minimum_with_joints(const BlockTask& task, const NearSegments& near,
                              const field::FirstOrderRuns& out) {
  using Duals = Results<Dual<Pack>>;
  field::Scratch::Frame frame(task.scratch);
  const auto room = [&] {
    std::array<Pack*, Duals::kNumbers> numbers;
    for (Pack*& number : numbers) number = frame.take<Pack>(kRuns);
    return numbers;
  };
  Duals least(room());
  std::vector<Duals> arms;
  for (uint32_t i = 0; i < near.set.arms; ++i) arms.emplace_back(room());
  find_minimum<Dual<Pack>>(task, near, least, arms.data());
  const Pack far(kFar);
  for (size_t run = 0; run < kRuns; ++run) {
    Dual<Pack> value = dual_at(least, run);
    for (const Joint& joint : near.set.joints) {
      const Dual<Pack> a = dual_at(arms[joint.a], run), b = dual_at(arms[joint.b], run);
      const field::Blend blend{field::Profile::smooth, joint.radius};
      // Operands that differ by more than the radius do not blend, and most runs have one arm.
      const bool blends =
          any(abs(a.v - b.v) < Pack(1.001 * joint.radius)) && any(min(a.v, b.v) < far);
      value = min(value, blends ? blend.smin(a, b) : min(a, b));
    }
    const FirstOrder first = field::first_order_of(value);
    out.values[run] = first.value;
    out.distances[run] = first.distance;
  }
}

/// The segments of `near` as a set of their own with the joints between them. Renumbers `near`.
void select_segments(const SweepParts& parts, const NearSegments& near, ActiveSet& out) {
  thread_local std::vector<Bounded*> order;
  order.clear();
  for (Bounded& at : near) order.push_back(&at);
  std::sort(order.begin(), order.end(),
            [](const Bounded* a, const Bounded* b) { return a->segment < b->segment; });
  out.clear();
  for (Bounded* at : order) {
    const size_t from = at->segment;
    at->segment = static_cast<uint32_t>(out.segments.size());
    out.append(near.set, from / Pack::kLanes, 1u << from % Pack::kLanes);
  }
  link(parts, out);
}

}  // namespace

field::BlockRange first_order_minimum(const BlockTask& task, const ActiveSet& set,
                                      const field::FirstOrderRuns& out) {
  field::Scratch::Frame frame(task.scratch);
  auto* near = frame.take<Bounded>(set.segments.size());
  const size_t count = near_segments(task, set, near);
  if (count == 0) return field::BlockRange::above;
  if (contains_block(task, set, near, count)) return field::BlockRange::below;
  thread_local ActiveSet joined;
  const ActiveSet* chosen = &set;
  const auto filleted = [](const Bounded& segment) { return segment.fillet > 0; };
  if (std::count_if(near, near + count, filleted) > 1) {
    select_segments(task.parts, {set, near, count}, joined);
    chosen = &joined;
    if (!joined.joints.empty()) {
      find_minimum_with_joints(task, {joined, near, count}, out);
      return field::BlockRange::near;
    }
  }
  Results<FirstOrder> least({out.values, out.distances});
  find_minimum<FirstOrder>(task, {*chosen, near, count}, least, nullptr);
  return field::BlockRange::near;
}

}  // namespace vug::passages
