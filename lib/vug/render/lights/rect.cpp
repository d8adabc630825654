// SPDX-License-Identifier: Apache-2.0
// One-sided rectangle light.
#include <vug/render/kind.h>
#include <vug/render/lighting/rectangle_shape.h>
#include <vug/render/lighting/shape_light.h>

namespace vug::render {
namespace {

struct Rect : RectangleParams, LightOutputParams {
  static void describe(Schema<Rect>& s) {
    s.doc("A rectangle light that emits from its front; it does not block light.")
        .cite("urena2013rectangle");
    describe_rectangle(s, "Direction of the side that emits.");
    describe_light_output(s);
  }
  std::string fault() const {
    const std::string shape = RectangleParams::fault();
    return shape.empty() ? LightOutputParams::fault() : shape;
  }
};

class RectLight final : public ShapeLight<RectangleShape> {
 public:
  explicit RectLight(const Rect& p)
      : ShapeLight(RectangleShape(p), p, p.radiance_for(kPi * p.width * p.height)) {}
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(rect, light, LightPtr, Rect, RectLight)
