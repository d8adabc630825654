#include <vug/render/guiding/cones.h>
#include <vug/render/sampling.h>

namespace vug::render {

void Cones::settle(float trust) {
  if (size_ == 0) return;
  trust_ = trust;
  const float all = 1 / until_[size_ - 1];
  for (size_t i = 0; i < size_; ++i) {
    density_[i] *= all / (2 * kPif * open_[i]);
    until_[i] *= all;
  }
}

Vec3f Cones::sample(const Vec2f& u) const {
  const size_t i = choose(u.x);
  const float before = i > 0 ? until_[i - 1] : 0;
  const float within = std::clamp((u.x - before) / (until_[i] - before), 0.0f, 0.99999994f);
  return Frame({x_[i], y_[i], z_[i]}).to_world(direction_off_axis(open_[i] * within, u.y));
}

}  // namespace vug::render
