#include <vug/facade/sequence.h>

namespace vug::facade {
namespace {

struct Columns {
  std::vector<Step> parts;

  static void describe(Schema<Columns>& s) {
    s.doc(std::string("One part beside the other, the first on the left. ") + kSizesDoc)
        .cite("ripperda2009")
        .param("parts", &Columns::parts, {.doc = "sizes and parts by turns", .required = true});
  }
  std::string fault() const { return fault_of(parts); }

  Layout layout(double width, double height, Free& free) const {
    return in_a_row(parts, true, width, height, free);
  }
};

}  // namespace
}  // namespace vug::facade

VUG_SPLIT_KIND(columns) { return split_kind<Columns>("columns"); }
