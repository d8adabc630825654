// SPDX-License-Identifier: Apache-2.0
#include <vug/passages/sweep/active_set.h>

#include <algorithm>

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
}

void link(const SweepParts& parts, ActiveSet& set) {
  set.links.clear();
  set.joints.clear();
  set.arms = 0;
  thread_local std::vector<uint32_t> arms;
  arms.clear();
  for (const uint32_t segment : set.segments)
    arms.insert(arms.end(), parts.arms_of_segment[segment].begin(),
                parts.arms_of_segment[segment].end());
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
  for (uint32_t i = 0; i < set.segments.size(); ++i)
    for (const uint32_t arm : parts.arms_of_segment[set.segments[i]])
      set.links.push_back({i, static_cast<uint32_t>(slot(arm))});
}

}  // namespace vug::passages
