// SPDX-License-Identifier: Apache-2.0
// Portal: a rectangle that directs samples to the visible part of the sky and adds no light itself.
// The idea is that of Bitterli, Novak, Jarosz 2015, "Portal-masked environment map sampling"; here
// the rectangle's solid angle is sampled without regard to the sky behind it.
#include <vug/render/kind.h>
#include <vug/render/lighting/rectangle_shape.h>

namespace vug::render {
namespace {

struct Portal : RectangleParams {
  static void describe(Schema<Portal>& s) {
    s.doc("An opening to the sky: adds no light, but directs samples to the sky.")
        .cite("bitterli2015portal");
    describe_rectangle(s, "Direction from the portal into the scene.");
  }
};

class PortalLight final : public Light {
 public:
  explicit PortalLight(const Portal& p) : shape_(p) {}

  LightSample sample(const LightSampleContext& point, const Vec2f& u) const override {
    LightSample s = shape_.sample(point.position, u);
    s.distance = kFar;
    return s;
  }
  float pdf(const LightSampleContext& point, const Vec3f& direction) const override {
    return shape_.pdf(point.position, direction);
  }
  float importance(const LightSampleContext& point) const override {
    return shape_.importance(point);
  }
  float importance_along(const Ray& ray, float begin, float end) const override {
    return shape_.importance_along(ray, begin, end);
  }
  Vec3f center() const override { return shape_.center(); }
  bool is_infinite() const override { return true; }
  bool is_portal() const override { return true; }

 private:
  RectangleShape shape_;
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(portal, light, LightPtr, Portal, PortalLight)
