#include <vug/field/boolean.h>
#include <vug/field/kind.h>

namespace vug::field {
namespace {

struct Complement {
  Field field;

  static void describe(Schema<Complement>& s) {
    s.doc("Rock for air and air for rock.")
        .param("field", &Complement::field, {.doc = "what is turned inside out", .required = true});
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(complement) {
  return field_kind<Complement>("complement", "operator",
                                [](const Complement& c) { return complement(c.field); });
}
