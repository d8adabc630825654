// SPDX-License-Identifier: Apache-2.0
// Points along a network.
#include <vug/network/along.h>
#include <vug/shot/passage_line.h>

namespace vug::shot {
namespace {

struct Along : PointLine {
  double spacing = 10;
  double up = 0;

  static void describe(Schema<Along>& s) {
    s.doc(
        "Points along the passages of a network at even distances, starting half a spacing after "
        "junctions and ends, e.g. for a row of lights.");
    describe_network(s);
    s.param("spacing", &Along::spacing, positive_length("between two points of a passage"))
        .param("up", &Along::up, any_length("how far above the middle of the passage"));
    describe_course(s);
  }
};

std::vector<Vec3d> points(const Along& p) {
  std::vector<Vec3d> all = network::points_along(*p.course(), p.spacing);
  for (Vec3d& point : all) point.y += p.up;
  return all;
}

}  // namespace
}  // namespace vug::shot

VUG_POINT_LIST_KIND(along) {
  return make_kind<std::vector<Vec3d>, Along>("along", "points", points);
}
