// A rectangle lamp that shines from its front.
#include <vug/render/kind.h>
#include <vug/render/lighting/rectangle_shape.h>
#include <vug/render/lighting/shape_light.h>

namespace vug::render {
namespace {

struct Rect : RectangleParams, LampParams {
  static void describe(Schema<Rect>& s) {
    s.doc("A rectangle lamp that shines from its front; it does not block light.")
        .cite("urena2013rectangle");
    describe_rectangle(s, "The side it shines to.");
    describe_lamp(s);
  }
  std::string fault() const {
    const std::string shape = RectangleParams::fault();
    return shape.empty() ? LampParams::fault() : shape;
  }
};

class RectLight final : public ShapeLamp<Rectangle> {
 public:
  explicit RectLight(const Rect& p)
      : ShapeLamp(Rectangle(p), p, p.radiance_of(kPi * p.width * p.height)) {}
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(rect, light, LightPtr, Rect, RectLight)
