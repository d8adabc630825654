// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/blocks.h>
#include <vug/field/boolean.h>

#include <algorithm>

namespace vug::facade {
namespace {

struct Window : Opening {
  double sash = 0.07;
  std::vector<int> panes = {2, 3};
  double bar = 0.035;

  static void describe(Schema<Window>& s) {
    s.doc(
         "A window: a hole with a sash, its bars and a sheet of glass; sill, lintel and moulding "
         "if "
         "their size is above 0.")
        .cite("ripperda2009")
        .param("sash", &Window::sash,
               {.doc = "width of the frame of the sash; 0: an empty hole",
                .dimension = Dimension::length,
                .min = 0})
        .param("panes", &Window::panes, {.doc = "columns and rows of panes", .min = 1, .max = 50})
        .param("bar", &Window::bar, positive_length("width of the bars between panes"));
    describe_opening(s);
  }
  std::string fault() const {
    if (panes.size() != 2) return "'panes' must be two numbers: columns and rows";
    return opening_fault();
  }

  Solids solids(double width, double height) const {
    Solids out = around(width, height, reveal + 0.12);
    if (!(sash > 0)) return out;
    const double front = reveal, back = reveal + 0.06,
                 edge = std::min({sash, width / 4, height / 4});
    std::vector<field::Field> holes;
    // Fewer panes if the bars would leave no space for them.
    const auto fitting = [&](int count, double room) {
      return std::clamp(static_cast<int>((room + bar) / (2 * bar)), 1, count);
    };
    const int across = fitting(panes[0], width - 2 * edge);
    const int up = fitting(panes[1], height - 2 * edge);
    // Bars extend over the whole height of the hole and are cut by its head.
    const double pane_width = (width - 2 * edge - (across - 1) * bar) / across;
    const double pane_height = (height - 2 * edge - (up - 1) * bar) / up;
    for (int i = 0; i < across; ++i)
      for (int j = 0; j < up; ++j) {
        const Rect pane{edge + i * (pane_width + bar), edge + j * (pane_height + bar), pane_width,
                        pane_height};
        // Panes below the head have its shape, inset by the edge.
        holes.push_back(j + 1 == up && up == 1 && across == 1
                            ? arched_block(pane, head, rise, -back - 1, -front + 1)
                            : block(pane, -back - 1, -front + 1));
      }
    out.add.push_back(field::subtract(sheet(width, height, back, front), std::move(holes)));
    const double glass = front + 0.028;
    out.fill.push_back(sheet(width, height, glass + kPane, glass));
    return out;
  }
};

}  // namespace
}  // namespace vug::facade

VUG_ELEMENT_KIND(window) { return element_kind<Window>("window"); }
