// SPDX-License-Identifier: Apache-2.0
#include <vug/passages/sweep/active_set.h>

#include <algorithm>
#include <bit>

namespace vug::passages {

namespace {

std::vector<Capsule> capsules_of(const std::vector<Segment>& segments) {
  std::vector<Capsule> out;
  out.reserve(segments.size());
  for (const Segment& segment : segments) out.push_back(segment.capsule());
  return out;
}

}  // namespace

SweepParts::SweepParts(Sweep parts)
    : sweep(std::move(parts)),
      capsules(capsules_of(sweep.segments)),
      arms_of_segment(sweep.segments.size()),
      joints_of_arm(sweep.arms.size()),
      bvh(sweep.segments, capsules) {
  for (uint32_t arm = 0; arm < sweep.arms.size(); ++arm)
    for (size_t i = sweep.arms[arm].first; i < sweep.arms[arm].last; ++i)
      arms_of_segment[i].push_back(arm);
  for (uint32_t joint = 0; joint < sweep.joints.size(); ++joint) {
    joints_of_arm[sweep.joints[joint].a].push_back(joint);
    joints_of_arm[sweep.joints[joint].b].push_back(joint);
    widest_joint = std::max(widest_joint, sweep.joints[joint].radius);
  }
  all.reserve(sweep.segments.size());
  for (uint32_t i = 0; i < sweep.segments.size(); ++i) {
    double fillet = 0;
    for (const uint32_t arm : arms_of_segment[i])
      for (const uint32_t joint : joints_of_arm[arm])
        fillet = std::max(fillet, sweep.joints[joint].radius);
    all.segments.push_back(i);
    all.capsules.append(capsules[i], fillet);
  }
}

void link(const SweepParts& parts, ActiveSet& set) {
  set.links.clear();
  set.joints.clear();
  set.arms = 0;
  thread_local std::vector<uint32_t> arms;
  arms.clear();
  thread_local std::vector<uint32_t> members;  // Segments with a joint.
  members.clear();
  for (uint32_t k = 0; k < set.capsules.packs(); ++k)
    for (unsigned lanes = bits_of(set.capsules.fillets(k) > Pack(0.0)); lanes != 0;
         lanes &= lanes - 1)
      members.push_back(Pack::kLanes * k + static_cast<uint32_t>(std::countr_zero(lanes)));
  for (const uint32_t i : members) {
    const auto& own = parts.arms_of_segment[set.segments[i]];
    arms.insert(arms.end(), own.begin(), own.end());
  }
  if (arms.size() < 2) return;
  std::sort(arms.begin(), arms.end());
  arms.erase(std::unique(arms.begin(), arms.end()), arms.end());
  const auto slot = [&](size_t arm) {
    const auto at = std::lower_bound(arms.begin(), arms.end(), arm);
    return at != arms.end() && *at == arm ? static_cast<size_t>(at - arms.begin()) : arms.size();
  };
  for (size_t a = 0; a < arms.size(); ++a)
    for (const uint32_t index : parts.joints_of_arm[arms[a]]) {
      const Joint& joint = parts.sweep.joints[index];
      if (joint.a != arms[a]) continue;
      const size_t b = slot(joint.b);
      if (b < arms.size()) set.joints.push_back({a, b, joint.radius});
    }
  if (set.joints.empty()) return;
  set.arms = static_cast<uint32_t>(arms.size());
  for (const uint32_t i : members)
    for (const uint32_t arm : parts.arms_of_segment[set.segments[i]])
      set.links.push_back({i, static_cast<uint32_t>(slot(arm))});
}

void fill_capsules(const SweepParts& parts, ActiveSet& set) {
  set.capsules.clear();
  for (const uint32_t i : set.segments) set.capsules.append(parts.all.capsules, i);
}

void complete(const SweepParts& parts, ActiveSet& set) {
  fill_capsules(parts, set);
  link(parts, set);
}

}  // namespace vug::passages
