// SPDX-License-Identifier: Apache-2.0
// One-sided disk light. Points are sampled uniformly by area, so the density over solid angle is
// distance^2 / (area * cosine at the light).
#include <vug/render/kind.h>
#include <vug/render/lighting/shape_light.h>
#include <vug/render/sampling.h>

namespace vug::render {
namespace {

struct Disk : LightOutputParams {
  Vec3d center{0, 0, 0};
  Vec3d normal{0, -1, 0};
  double radius = 0.5;

  static void describe(Schema<Disk>& s) {
    s.doc("A disk light that emits from its front; it does not block light.")
        .cite("shirley1997disk")
        .param("center", &Disk::center, any_length("Centre."))
        .param("normal", &Disk::normal, {.doc = "Direction of the side that emits."})
        .param("radius", &Disk::radius, positive_length("Radius."));
    describe_light_output(s);
  }
  std::string fault() const {
    return is_direction(normal) ? LightOutputParams::fault()
                                : "the disk's normal must be finite and not zero";
  }
};

class DiskShape {
 public:
  explicit DiskShape(const Disk& p)
      : center_(p.center),
        radius_(static_cast<float>(p.radius)),
        axes_(Vec3f(p.normal.normalized())) {}

  LightSample sample(const Vec3f& point, const Vec2f& u) const {
    const Vec2f d = sample_disk(u);
    const Vec3f to = center_ + (axes_.x * d.x + axes_.y * d.y) * radius_ - point;
    LightSample s;
    s.distance = length(to);
    if (!(s.distance > 0)) return s;
    s.direction = to * (1 / s.distance);
    s.pdf = density(s.distance, s.direction);
    return s;
  }
  float pdf(const Vec3f& point, const Vec3f& direction) const {
    const float t = hit({point, direction});
    return t > 0 ? density(t, direction) : 0;
  }
  float hit(const Ray& ray) const {
    const float facing = dot(axes_.z, ray.direction);
    if (!(facing < 0)) return 0;
    const float t = dot(axes_.z, center_ - ray.origin) / facing;
    return t > 0 && length(ray.at(t) - center_) <= radius_ ? t : 0;
  }
  float importance(const LightSampleContext& point) const {
    const Vec3f to = center_ - point.position;
    const float squared = dot(to, to), distance = std::sqrt(squared);
    const float front = -dot(axes_.z, to);
    if (!(front > 0)) return 0;
    float cosine = 1;
    if (point.on_surface()) {
      // The highest point of the rim above the horizon decides.
      const float slope = dot(point.normal, axes_.z);
      const float height =
          dot(point.normal, to) + radius_ * std::sqrt(std::max(0.0f, 1 - slope * slope));
      if (!(height > 0)) return 0;
      cosine = std::min(1.0f, height / std::max(distance, radius_));
    }
    const float light_cosine = std::max(std::min(1.0f, front / distance), 0.05f);
    return cosine *
           std::min(2 * kPif, area() * light_cosine / std::max(squared, 0.25f * radius_ * radius_));
  }
  float importance_along(const Ray& ray, float begin, float end) const {
    const auto front = [&](float t) { return dot(ray.at(t) - center_, axes_.z) > 0; };
    if (!front(begin) && !front(end)) return 0;
    const float t = std::clamp(dot(center_ - ray.origin, ray.direction), begin, end);
    return area() / std::max(length(center_ - ray.at(t)), 0.5f * radius_);
  }
  LightBounds bounds(float luminance) const {
    const auto reach = [&](float n) { return radius_ * std::sqrt(std::max(0.0f, 1 - n * n)); };
    const Vec3f half(reach(axes_.z.x), reach(axes_.z.y), reach(axes_.z.z));
    LightBounds out;
    out.box = {center_ - half, center_ + half};
    out.axis = axes_.z;
    out.cos_spread = 1;
    out.strength = luminance * area();
    return out;
  }
  void export_to(exchange::Light& light) const {
    light.shape = exchange::Light::Shape::disk;
    light.place = exchange::look_along(Vec3d(center_), Vec3d(axes_.z));
    light.radius = static_cast<double>(radius_);
  }
  const Vec3f& center() const { return center_; }
  float radius() const { return radius_; }

 private:
  float area() const { return kPif * radius_ * radius_; }
  float density(float distance, const Vec3f& direction) const {
    const float facing = -dot(axes_.z, direction);
    return facing > 0 ? distance * distance / (area() * facing) : 0;
  }

  Vec3f center_;
  float radius_;
  Frame axes_;
};

class DiskLight final : public ShapeLight<DiskShape> {
 public:
  explicit DiskLight(const Disk& p)
      : ShapeLight(DiskShape(p), p, p.radiance_for(kPi * kPi * p.radius * p.radius)) {}
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(disk, light, LightPtr, Disk, DiskLight)
