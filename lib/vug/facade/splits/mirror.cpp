// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/sequence.h>

namespace vug::facade {
namespace {

struct Mirror {
  std::vector<SizeOrPart> parts;

  static void describe(Schema<Mirror>& s) {
    s.doc(
         "A side and its mirror image, derived once, with an optional middle between both: "
         "mirror(Side), mirror(Side, 3m, Middle), mirror(2m, Side, Middle). Without any size the "
         "width of the middle is free.")
        .cite("ripperda2009")
        .param("parts", &Mirror::parts,
               {.doc = "the side and the middle, each preceded by its size", .required = true});
  }
  std::string fault() const {
    std::string fault;
    const size_t count = sized_parts(parts, fault).size();
    if (fault.empty() && count > 2) fault = "'mirror' needs a side and at most one middle";
    return fault;
  }

  static void add_sides(int part, double side, double width, double height, const FreeNumbers& free,
                        Layout& out) {
    Cell left{.part = part, .rect = {0, 0, side, height}};
    if (!free.apart()) left.copies = {Placement::mirror(width / 2)};
    out.cells.push_back(left);
    if (!free.apart()) return;
    left.rect.x = width - side;
    left.column = 1;
    left.mirrored = true;
    out.cells.push_back(left);
  }

  Layout layout(double width, double height, FreeNumbers& free) const {
    std::string none;
    const std::vector<SizedPart> all = sized_parts(parts, none);
    Layout out;
    if (all.size() == 1) {
      const double half = divide({all[0], all[0]}, width)[0];
      add_sides(all[0].part.part, half, width, height, free, out);
      return out;
    }
    std::vector<double> sizes(3);
    if (all_free(all)) {
      const double middle = free.length("width", 0, width, width / 3, [&] {
        return RandomStream(free.key()).uniform(0.15, 0.5) * width;
      });
      sizes = {(width - middle) / 2, middle, (width - middle) / 2};
    } else {
      sizes = divide({all[0], all[1], all[0]}, width);
    }
    add_sides(all[0].part.part, sizes[0], width, height, free, out);
    out.cells.push_back({.part = all[1].part.part,
                         .rect = {sizes[0], 0, sizes[1], height},
                         .given = {{"width", sizes[1]}}});
    return out;
  }
};

}  // namespace
}  // namespace vug::facade

VUG_SPLIT_KIND(mirror) { return split_kind<Mirror>("mirror"); }
