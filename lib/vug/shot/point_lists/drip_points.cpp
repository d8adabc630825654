// SPDX-License-Identifier: Apache-2.0
// Places of the graph of drips as a list of points.
#include <vug/shot/drips_plan.h>
#include <vug/shot/networks.h>

namespace vug::shot {
namespace {

enum class Place { drops, tips, landings, seeps, pools };

struct DripPoints {
  DripsPtr of;
  Place only = Place::landings;
  double up = 0;

  static void describe(Schema<DripPoints>& s) {
    s.doc(
         "Places of named drips, in their order: where drops leave the roof, the tips of straws "
         "and "
         "stalactites, where drops land, where water seeps out, or its pools.")
        .param("of", &DripPoints::of, {.doc = "the drips", .required = true})
        .choice("only", &DripPoints::only,
                {{"drops", Place::drops},
                 {"tips", Place::tips},
                 {"landings", Place::landings},
                 {"seeps", Place::seeps},
                 {"pools", Place::pools}},
                "which places")
        .param("up", &DripPoints::up, any_length("how far above them"));
  }
};

drips::NodeKind kind_of(Place place) {
  switch (place) {
    case Place::drops:
      return drips::NodeKind::drop;
    case Place::seeps:
      return drips::NodeKind::seep;
    case Place::pools:
      return drips::NodeKind::pool;
    default:
      return drips::NodeKind::landing;
  }
}

std::vector<Vec3d> tips(const DripsPlan& drips) {
  std::vector<Vec3d> points;
  for (const drips::Form& form : drips.grown().forms)
    if (form.kind == drips::FormKind::straw || form.kind == drips::FormKind::stalactite)
      points.push_back(form.bottom + (form.top - form.bottom) * form.broken);
  return points;
}

std::vector<Vec3d> nodes(const DripsPlan& drips, drips::NodeKind kind) {
  std::vector<Vec3d> points;
  for (const drips::Node& node : drips.graph().nodes)
    if (node.kind == kind) points.push_back(node.position);
  return points;
}

std::vector<Vec3d> places(const DripPoints& p) {
  std::vector<Vec3d> points = p.only == Place::tips ? tips(*p.of) : nodes(*p.of, kind_of(p.only));
  for (Vec3d& point : points) point.y += p.up;
  return points;
}

}  // namespace
}  // namespace vug::shot

VUG_POINT_LIST_KIND(drip_points) {
  return make_kind<std::vector<Vec3d>, DripPoints>("drip_points", "points", places);
}
