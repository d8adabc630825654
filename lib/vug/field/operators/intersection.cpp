#include <vug/field/boolean.h>
#include <vug/field/kind.h>

namespace vug::field {
namespace {

struct Intersection {
  std::vector<Field> of;
  Blend blend;

  static void describe(Schema<Intersection>& s) {
    s.doc("What the solids have in common: the greatest of their values.")
        .cite("zawadzki2012")
        .param("of", &Intersection::of, {.doc = "the solids, at least one", .required = true})
        .param("blend", &Intersection::blend, {.doc = "the edge where the solids meet"});
  }
  std::string fault() const { return of.empty() ? "an intersection needs a solid" : ""; }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(intersection) {
  return field_kind<Intersection>("intersection", "operator",
                                  [](const Intersection& i) { return intersect(i.of, i.blend); });
}
