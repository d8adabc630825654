// A rectangle lamp that shines from its front.
#include <vug/render/kind.h>
#include <vug/render/rectangle.h>

namespace vug::render {
namespace {

struct Rect : RectangleParams {
  Vec3d radiance{1, 1, 1};
  bool visible = true;

  static void describe(Schema<Rect>& s) {
    s.doc("A rectangle lamp that shines from its front; it does not block light.")
        .cite("urena2013rectangle");
    describe_rectangle(s, "The side it shines to.");
    s.param("radiance", &Rect::radiance,
            {.doc = "Radiance of red, green, blue in W/sr/m^2.", .min = 0})
        .param("visible", &Rect::visible, {.doc = "Whether the camera sees the lamp itself."});
  }
};

class RectLight final : public Light {
 public:
  explicit RectLight(const Rect& p)
      : shape_(p), radiance_(p.radiance), power_(luminance(radiance_)), visible_(p.visible) {}

  LightSample sample(const LitPoint& point, const Vec2f& u) const override {
    LightSample s = shape_.sample(point.position, u);
    s.radiance = radiance_;
    return s;
  }
  float pdf(const LitPoint& point, const Vec3f& direction) const override {
    return shape_.pdf(point.position, direction);
  }
  float importance(const LitPoint& point) const override {
    return power_ * shape_.importance(point);
  }
  float importance_along(const Ray& ray, float begin, float end) const override {
    return power_ * shape_.importance_along(ray, begin, end);
  }
  LightBounds bounds() const override { return shape_.bounds(power_); }
  Vec3f centre() const override { return shape_.center(); }
  bool intersect(const Ray& ray, float max_distance, LightHit& hit) const override {
    const float t = shape_.hit(ray);
    if (!(t > 0 && t < max_distance)) return false;
    hit = {t, radiance_};
    return true;
  }
  bool camera_visible() const override { return visible_; }

 private:
  Rectangle shape_;
  Rgb radiance_;
  float power_;
  bool visible_;
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(rect, light, LightPtr, Rect, RectLight)
