// SPDX-License-Identifier: Apache-2.0
// A station of a network as a point, e.g. for cameras and lights.
#include <vug/network/find_station.h>
#include <vug/shot/networks.h>

namespace vug::shot {
namespace {

struct StationPoint {
  NetworkPtr of;
  std::string name;
  double up = 0;

  static void describe(Schema<StationPoint>& s) {
    s.doc("The position of a station of a network.")
        .param("of", &StationPoint::of, {.doc = "the network", .required = true})
        .param(
            "name", &StationPoint::name,
            {.doc = "the station's name, or its last levels if they are unique", .required = true})
        .param("up", &StationPoint::up, any_length("how far above the station"));
  }
};

Vec3d station_position(const StationPoint& p) {
  const network::Station& station =
      p.of->stations[static_cast<size_t>(network::find_station(*p.of, p.name))];
  return station.position + Vec3d(0, p.up, 0);
}

}  // namespace
}  // namespace vug::shot

VUG_POINT_KIND(station) {
  return make_kind<Vec3d, StationPoint>("station", "point", station_position);
}
