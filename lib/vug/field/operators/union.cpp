#include <vug/field/boolean.h>
#include <vug/field/kind.h>

namespace vug::field {
namespace {

struct Union {
  std::vector<Field> of;
  Blend blend;

  static void describe(Schema<Union>& s) {
    s.doc("All of the solids together: the least of their values.")
        .cite("zawadzki2012")
        .param("of", &Union::of, {.doc = "the solids", .required = true})
        .param("blend", &Union::blend, {.doc = "how the solids meet"});
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(union) {
  return field_kind<Union>("union", "operator",
                           [](const Union& u) { return unite(u.of, u.blend); });
}
