// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/sequence.h>

namespace vug::facade {
namespace {

struct Rows {
  std::vector<SizeOrPart> parts;

  static void describe(Schema<Rows>& s) {
    s.doc(std::string("Parts one above the other, the first at the bottom. ") + kSizesDoc)
        .cite("ripperda2009")
        .param("parts", &Rows::parts, {.doc = "alternating sizes and parts", .required = true});
  }
  std::string fault() const { return fault_of(parts); }

  Layout layout(double width, double height, FreeNumbers& free) const {
    return lay_out_row(parts, false, width, height, free);
  }
};

}  // namespace
}  // namespace vug::facade

VUG_SPLIT_KIND(rows) { return split_kind<Rows>("rows"); }
