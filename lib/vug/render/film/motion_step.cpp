#include <vug/render/film/motion_step.h>

#include <cmath>

namespace vug::render {

Vec2f FrameStep::motion(const Vec3f& point, uint32_t object, const Placing* placing, float time,
                        float aspect) const {
  Vec3f before = point, after = point;
  if (const auto way = places.find(object); way != places.end()) {
    const Vec3f own = placing ? Vec3f(placing->to_own(time).point(Vec3d(point))) : point;
    before = way->second.first.point(own), after = way->second.second.point(own);
  }
  const auto from = now->place(before, aspect), to = next->place(after, aspect);
  if (!from || !to) return Vec2f(0.0f);
  Vec2f way = *to - *from;
  if (const float period = now->period(); period > 0)  // the short way over the seam
    way.x -= period * std::floor(way.x / period + 0.5f);
  return {way.x, -way.y};
}

}  // namespace vug::render
