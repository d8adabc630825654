// SPDX-License-Identifier: Apache-2.0
// A station of a network as a point, e.g. for cameras and lights.
#include <vug/network/find_station.h>
#include <vug/shot/passage_line.h>

namespace vug::shot {
namespace {

struct StationPoint : PointLine {
  std::string name;
  double up = 0;

  static void describe(Schema<StationPoint>& s) {
    s.doc("The position of a station of a network, in the middle of its passage.");
    describe_network(s);
    s.param("name", &StationPoint::name,
            {.doc = "the station's name, or its last levels if they are unique", .required = true})
        .param("up", &StationPoint::up, any_length("how far above the middle of the passage"));
    describe_course(s);
  }
};

Vec3d station_position(const StationPoint& p) {
  const auto station = static_cast<size_t>(network::find_station(*p.of, p.name));
  return p.course()->stations[station].position + Vec3d(0, p.up, 0);
}

}  // namespace
}  // namespace vug::shot

VUG_POINT_KIND(station) {
  return make_kind<Vec3d, StationPoint>("station", "point", station_position);
}
