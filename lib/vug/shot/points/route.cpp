// SPDX-License-Identifier: Apache-2.0
// A point on the way from one station of a network to another, e.g. for a camera that moves.
#include <vug/network/find_station.h>
#include <vug/passages/lines/route.h>
#include <vug/shot/passage_line.h>

namespace vug::shot {
namespace {

struct RoutePoint : PassageLine {
  std::string from, to;
  double at = 0;
  double ahead = 0;
  double up = 0;

  static void describe(Schema<RoutePoint>& s) {
    s.doc(
        "A point on the shortest way through the passages from one station to another. With a "
        "fraction that depends on `frame`, a camera flies along it, e.g. at: (frame - 1) / 99.");
    describe_network(s);
    s.param("from", &RoutePoint::from, {.doc = "the first station", .required = true})
        .param("to", &RoutePoint::to, {.doc = "the last station", .required = true})
        .param("at", &RoutePoint::at, {.doc = "fraction of the length; below 0 as 0, above 1 as 1"})
        .param("ahead", &RoutePoint::ahead,
               {.doc = "how much farther along the way; straight on beyond its ends",
                .dimension = Dimension::length,
                .min = -1e5,
                .max = 1e5})
        .param("up", &RoutePoint::up, any_length("how far above the axis of the passage"));
    describe_axes(s);
  }
};

Vec3d point_on_route(const RoutePoint& p) {
  const passages::Route route(*p.axes(), network::find_station(*p.of, p.from),
                              network::find_station(*p.of, p.to));
  const double fraction = p.at < 0 ? 0 : p.at > 1 ? 1 : p.at;
  return route.point(fraction * route.length() + p.ahead) + Vec3d(0, p.up, 0);
}

}  // namespace
}  // namespace vug::shot

VUG_POINT_KIND(route) { return make_kind<Vec3d, RoutePoint>("route", "point", point_on_route); }
