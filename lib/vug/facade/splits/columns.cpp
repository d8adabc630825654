// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/sequence.h>

namespace vug::facade {
namespace {

struct Columns {
  std::vector<SizeOrPart> parts;

  static void describe(Schema<Columns>& s) {
    s.doc(std::string("Parts side by side, the first on the left. ") + kSizesDoc)
        .cite("ripperda2009")
        .param("parts", &Columns::parts, {.doc = "alternating sizes and parts", .required = true});
  }
  std::string fault() const { return fault_of(parts); }

  Layout layout(double width, double height, FreeNumbers& free) const {
    return lay_out_row(parts, true, width, height, free);
  }
};

}  // namespace
}  // namespace vug::facade

VUG_SPLIT_KIND(columns) { return split_kind<Columns>("columns"); }
