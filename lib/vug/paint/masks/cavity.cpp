// The solid's own field, read a step outside the surface: where less room is left than the step,
// rock is near on other sides too (after Evans 2006, "Fast approximations for global
// illumination on dynamic scenes").
#include <vug/paint/kind.h>

#include <algorithm>

namespace vug::paint {
namespace {

struct Cavity {
  field::Field field;
  double reach = 0.1;

  static void describe(Schema<Cavity>& s) {
    s.doc("0 on flat and convex rock, rising to 1 in hollows, corners and cracks.")
        .cite("evans2006")
        .param("field", &Cavity::field, {.doc = "the solid whose surface it is", .required = true})
        .param("reach", &Cavity::reach, positive_length("size of the hollows that count"));
  }
};

}  // namespace

const MaskKind& cavity_mask() {
  static const MaskKind kind = mask_kind<Cavity>("cavity", [](const Cavity& c) {
    return make_mask([c](const Spot& spot) {
      const double room = c.field.value(spot.position + spot.normal * c.reach);
      return std::clamp(1 - room / c.reach, 0.0, 1.0);
    });
  });
  return kind;
}

}  // namespace vug::paint
