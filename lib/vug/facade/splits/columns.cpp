#include <vug/facade/sequence.h>

namespace vug::facade {
namespace {

struct Columns {
  std::vector<Step> parts;

  static void describe(Schema<Columns>& s) {
    s.doc(
         "One part beside the other, the first on the left. A size stands before its part: a "
         "length, a share of the whole in per cent, or a "
         "number, a share of what is left. Without any size all are free.")
        .cite("ripperda2009")
        .param("parts", &Columns::parts, {.doc = "sizes and parts by turns", .required = true});
  }
  std::string fault() const { return fault_of(parts); }

  Layout layout(double width, double height, RandomKey key) const {
    std::string none;
    const std::vector<Sized> all = pairs(parts, none);
    const std::vector<double> sizes = divide(all, width, key);
    Layout out;
    double at = 0;
    for (size_t i = 0; i < all.size(); ++i) {
      out.cells.push_back({.part = all[i].part.part,
                           .rect = {at, 0, sizes[i], height},
                           .given = {{"width", sizes[i]}},
                           .index = static_cast<int64_t>(i),
                           .total = static_cast<int64_t>(all.size())});
      at += sizes[i];
    }
    return out;
  }
};

}  // namespace
}  // namespace vug::facade

VUG_SPLIT_KIND(columns) { return split_kind<Columns>("columns"); }
