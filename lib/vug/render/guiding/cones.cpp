#include <vug/render/guiding/cones.h>
#include <vug/render/sampling.h>

namespace vug::render {

void Cones::add(const Vec3f& to, float radius, float share, uint32_t name) {
  const float distance = length(to), sine = std::min(radius / distance, 1.0f);
  x_[size_] = to.x / distance, y_[size_] = to.y / distance, z_[size_] = to.z / distance;
  open_[size_] = sine * sine / (1 + std::sqrt(1 - sine * sine));
  density_[size_] = share;
  names_[size_] = name;
  until_[size_] = share + (size_ > 0 ? until_[size_ - 1] : 0);
  ++size_;
}

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
