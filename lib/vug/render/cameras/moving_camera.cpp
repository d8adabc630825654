// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/render/cameras/moving_camera.h>

#include <algorithm>
#include <cmath>

namespace vug::render {
namespace {

class MovingCamera final : public Camera {
 public:
  explicit MovingCamera(std::vector<CameraPtr> moments) : moments_(std::move(moments)) {}

  Ray ray(const Vec2f& film, float aspect, const Vec2f& lens) const override {
    return ray_at(0.5f, film, aspect, lens);
  }
  std::optional<Vec2f> project(const Vec3f& point, float aspect) const override {
    return middle().project(point, aspect);
  }
  float period() const override { return middle().period(); }
  Vec3f position() const override { return middle().position(); }
  float depth(const Vec3f& point) const override { return depth_at(0.5f, point); }
  std::optional<CameraMatrices> matrices(float aspect) const override {
    return middle().matrices(aspect);
  }
  Shutter shutter() const override { return middle().shutter(); }
  CameraPtr stereo_view(int side) const override {
    std::vector<CameraPtr> views;
    for (const CameraPtr& moment : moments_) {
      views.push_back(moment->stereo_view(side));
      if (!views.back()) return nullptr;
    }
    return moving_camera(std::move(views));
  }
  bool moves() const override { return true; }
  bool as_data(exchange::Camera& camera) const override { return middle().as_data(camera); }
  Ray ray_at(float time, const Vec2f& film, float aspect, const Vec2f& lens) const override {
    const Interpolation at = interpolation(time);
    const Ray a = at.first.ray(film, aspect, lens), b = at.second.ray(film, aspect, lens);
    return {a.origin + (b.origin - a.origin) * at.weight,
            normalized(a.direction + (b.direction - a.direction) * at.weight)};
  }
  float depth_at(float time, const Vec3f& point) const override {
    const Interpolation at = interpolation(time);
    return at.first.depth(point) * (1 - at.weight) + at.second.depth(point) * at.weight;
  }

 private:
  struct Interpolation {
    const Camera &first, &second;
    float weight;
  };
  Interpolation interpolation(float time) const {
    const auto last = static_cast<float>(moments_.size() - 1);
    const float position = std::clamp(time, 0.0f, 1.0f) * last;
    const float first = std::min(std::floor(position), last - 1);
    const auto i = static_cast<size_t>(first);
    return {*moments_[i], *moments_[i + 1], position - first};
  }
  const Camera& middle() const { return *moments_[moments_.size() / 2]; }

  std::vector<CameraPtr> moments_;
};

}  // namespace

CameraPtr moving_camera(std::vector<CameraPtr> moments) {
  if (moments.empty())
    throw Error(ErrorCode::bad_input, "a moving camera needs at least one moment");
  if (moments.size() == 1) return moments.front();
  return std::make_shared<const MovingCamera>(std::move(moments));
}

}  // namespace vug::render
