// SPDX-License-Identifier: Apache-2.0
#include <vug/render/film/motion_step.h>

#include <cmath>

namespace vug::render {

Vec2f MotionStep::motion(const Vec3f& point, uint32_t object, const InstanceTransform* instance,
                         float time, float aspect) const {
  Vec3f before = point, after = point;
  if (const auto found = transforms.find(object); found != transforms.end()) {
    const Vec3f own = instance ? Vec3f(instance->inverse(time).point(Vec3d(point))) : point;
    before = found->second.first.point(own), after = found->second.second.point(own);
  }
  const auto from = now->project(before, aspect), to = next->project(after, aspect);
  if (!from || !to) return Vec2f(0.0f);
  Vec2f motion = *to - *from;
  if (const float period = now->period(); period > 0)  // the short way across the seam
    motion.x -= period * std::floor(motion.x / period + 0.5f);
  return {motion.x, -motion.y};
}

}  // namespace vug::render
