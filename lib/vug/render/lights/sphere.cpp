// A ball that shines outwards, sampled by the cone it fills: Shirley, Wang, Zimmerman 1996,
// "Monte Carlo techniques for direct lighting calculations".
#include <vug/render/kind.h>
#include <vug/render/sampling.h>

namespace vug::render {
namespace {

struct Sphere {
  Vec3d center{0, 0, 0};
  double radius = 0.1;
  Vec3d radiance{1, 1, 1};
  bool visible = true;

  static void describe(Schema<Sphere>& s) {
    s.doc("A ball that shines outwards; it does not block light.")
        .cite("shirley1996direct")
        .param("center", &Sphere::center, any_length("Its middle."))
        .param("radius", &Sphere::radius, positive_length("Its radius."))
        .param("radiance", &Sphere::radiance,
               {.doc = "Radiance of red, green, blue in W/sr/m^2.", .min = 0})
        .param("visible", &Sphere::visible, {.doc = "Whether the camera sees the lamp itself."});
  }
};

class SphereLight final : public Light {
 public:
  explicit SphereLight(const Sphere& p)
      : center_(p.center),
        radius_(static_cast<float>(p.radius)),
        radiance_(p.radiance),
        power_(luminance(radiance_)),
        visible_(p.visible) {}

  LightSample sample(const LitPoint& point, const Vec2f& u) const override {
    LightSample s;
    const Vec3f to = center_ - point.position;
    const float part = cone(to);  // 1 - cos of the cone's half angle
    if (!(part > 0)) return s;
    s.direction = Frame(normalized(to)).to_world(direction_off_axis(u.x * part, u.y));
    s.pdf = 1 / (2 * kPif * part);
    s.radiance = radiance_;
    // On the cone's edge rounding may miss the ball; the nearest point is as good.
    const float along = dot(to, s.direction);
    const float rest = radius_ * radius_ - (dot(to, to) - along * along);
    s.distance = along - std::sqrt(std::max(0.0f, rest));
    return s;
  }
  float pdf(const LitPoint& point, const Vec3f& direction) const override {
    LightHit hit;
    const Vec3f to = center_ - point.position;
    if (!intersect({point.position, direction}, kFar, hit)) return 0;
    return 1 / (2 * kPif * cone(to));
  }
  float importance(const LitPoint& point) const override {
    const Vec3f to = center_ - point.position;
    const float squared = dot(to, to);
    if (!(squared > radius_ * radius_)) return 0;
    float cosine = 1;
    if (point.on_surface()) {
      const float height = dot(point.normal, to) + radius_;
      if (!(height > 0)) return 0;
      cosine = std::min(1.0f, height / std::sqrt(squared));
    }
    return power_ * cosine * (kPif * radius_ * radius_) / squared;
  }
  float importance_along(const Ray& ray, float begin, float end) const override {
    const float t = std::clamp(dot(center_ - ray.origin, ray.direction), begin, end);
    const float distance = std::max(length(center_ - ray.at(t)), radius_);
    return power_ * kPif * radius_ * radius_ / distance;
  }
  LightBounds bounds() const override {
    LightBounds out;
    out.box = {center_ - Vec3f(radius_), center_ + Vec3f(radius_)};
    out.strength = power_ * kPif * radius_ * radius_;
    return out;
  }
  Vec3f centre() const override { return center_; }
  bool intersect(const Ray& ray, float max_distance, LightHit& hit) const override {
    const Vec3f to = center_ - ray.origin;
    const float along = dot(to, ray.direction);
    const Vec3f off = to - ray.direction * along;  // more exact than |to|^2 - along^2
    const float rest = radius_ * radius_ - dot(off, off);
    if (!(along > 0 && rest >= 0) || dot(to, to) <= radius_ * radius_) return false;
    const float t = along - std::sqrt(rest);
    if (!(t > 0 && t < max_distance)) return false;
    hit = {t, radiance_};
    return true;
  }
  bool camera_visible() const override { return visible_; }

 private:
  /// 1 - cos of the half angle, without cancellation; 0 inside the ball, which shines outwards.
  float cone(const Vec3f& to) const {
    const float squared_sine = radius_ * radius_ / dot(to, to);
    return squared_sine < 1 ? squared_sine / (1 + std::sqrt(1 - squared_sine)) : 0;
  }

  Vec3f center_;
  float radius_;
  Rgb radiance_;
  float power_;
  bool visible_;
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(sphere, light, LightPtr, Sphere, SphereLight)
