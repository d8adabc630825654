// SPDX-License-Identifier: Apache-2.0
// The empty solid, the neutral element of unions.
#include <vug/field/boolean.h>
#include <vug/field/kind.h>

namespace vug::field {
namespace {

struct Empty {
  static void describe(Schema<Empty>& s) { s.doc("The empty solid."); }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(empty) {
  return field_kind<Empty>("empty", "primitive", [](const Empty&) { return empty(); });
}
