// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/sequence.h>

#include <fmt/format.h>

namespace vug::facade {
namespace {

struct Inset {
  std::vector<SizeOrPart> parts;
  std::optional<PartRef> frame;

  static void describe(Schema<Inset>& s) {
    s.doc(
         "A part within margins: inset(30cm, Inner). Of two sizes the first is for the left and "
         "right, the second for below and above; four sizes are left, right, below, above.")
        .param("parts", &Inset::parts,
               {.doc = "one, two or four sizes followed by a part", .required = true})
        .param("frame", &Inset::frame, {.doc = "the part in each of the four margins"});
  }
  std::string fault() const {
    const size_t sizes = parts.size() - 1;
    if (!parts.back().is_part || (sizes != 1 && sizes != 2 && sizes != 4))
      return "'inset' needs one, two or four sizes followed by a part";
    for (size_t i = 0; i < sizes; ++i) {
      if (parts[i].is_part) return "'inset' needs a single part after the sizes";
      if (!(parts[i].size.value >= 0)) return "a margin must be 0 or more";
    }
    return "";
  }

  Layout layout(double width, double height, FreeNumbers&) const {
    const size_t count = parts.size() - 1;
    const auto margin = [&](size_t side) {  // left, right, below, above
      const size_t at = count == 4 ? side : count == 2 ? side / 2 : 0;
      return resolve_size(parts[at].size, side < 2 ? width : height);
    };
    const double left = margin(0), right = margin(1), below = margin(2), above = margin(3);
    const Rect inner{left, below, width - left - right, height - below - above};
    if (!(inner.width > 0 && inner.height > 0))
      throw Error(ErrorCode::bad_input, fmt::format("the margins leave no space of {} x {}",
                                                    quantity_text(width, Dimension::length),
                                                    quantity_text(height, Dimension::length)));
    Layout out;
    out.cells.push_back({.part = parts.back().part.part, .rect = inner});
    out.numbers = {{"left", left}, {"right", right}, {"below", below}, {"above", above}};
    if (!frame) return out;
    for (const Rect& strip :
         {Rect{0, 0, width, below}, Rect{0, inner.top(), width, above},
          Rect{0, below, left, inner.height}, Rect{inner.right(), below, right, inner.height}})
      if (strip.width > 0 && strip.height > 0)
        out.cells.push_back({.part = frame->part, .rect = strip});
    return out;
  }
};

}  // namespace
}  // namespace vug::facade

VUG_SPLIT_KIND(inset) { return split_kind<Inset>("inset"); }
