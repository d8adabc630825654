// SPDX-License-Identifier: Apache-2.0
#include <vug/field/kind.h>
#include <vug/field/lathe.h>

#include <fmt/format.h>

namespace vug::field {
namespace {

struct Lathe {
  std::vector<double> radii, heights;

  static void describe(Schema<Lathe>& s) {
    s.doc(
         "A polygon turned about the y axis: columns, drums, bowls. Its corners have a radius and "
         "a "
         "height each, in order around the outline.")
        .param("radii", &Lathe::radii,
               {.doc = "the corners' distances from the axis",
                .dimension = Dimension::length,
                .min = 0,
                .required = true})
        .param("heights", &Lathe::heights,
               {.doc = "the corners' heights", .dimension = Dimension::length, .required = true});
  }
  std::string fault() const {
    if (radii.size() != heights.size())
      return fmt::format("an outline of {0} radii needs {0} heights, not {1}", radii.size(),
                         heights.size());
    return lathe_fault(outline());
  }
  std::vector<Vec2d> outline() const {
    std::vector<Vec2d> out;
    for (size_t i = 0; i < radii.size(); ++i) out.emplace_back(radii[i], heights[i]);
    return out;
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(lathe) {
  return field_kind<Lathe>("lathe", "primitive",
                           [](const Lathe& l) { return lathe("lathe", l.outline()); });
}
