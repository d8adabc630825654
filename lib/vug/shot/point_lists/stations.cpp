// SPDX-License-Identifier: Apache-2.0
// Stations of a network as a list of points.
#include <vug/network/reduction.h>
#include <vug/shot/passage_line.h>

namespace vug::shot {
namespace {

enum class Choice { all, junctions, ends, entrances, sinks, springs };

struct Stations : PointLine {
  Choice only = Choice::all;
  double up = 0;

  static void describe(Schema<Stations>& s) {
    s.doc(
        "The positions of the stations of a network that have legs underground, in the order of "
        "the network: all, those where at least three legs meet, the ends of passages, or the "
        "entrances, sinks and springs.");
    describe_network(s);
    s.choice("only", &Stations::only,
             {{"all", Choice::all},
              {"junctions", Choice::junctions},
              {"ends", Choice::ends},
              {"entrances", Choice::entrances},
              {"sinks", Choice::sinks},
              {"springs", Choice::springs}},
             "which stations")
        .param("up", &Stations::up, any_length("how far above the middle of the passage"));
    describe_course(s);
  }
};

bool is_chosen(Choice only, size_t degree, const network::StationFlags& flags) {
  switch (only) {
    case Choice::all:
      return true;
    case Choice::junctions:
      return degree > 2;
    case Choice::ends:
      return degree == 1;
    case Choice::entrances:
      return flags.entrance;
    case Choice::sinks:
      return flags.sink;
    case Choice::springs:
      return flags.spring;
  }
  return false;
}

std::vector<Vec3d> positions(const Stations& p) {
  const network::PlacedGraph cave = network::cave_graph(*p.of);
  const std::vector<std::vector<int>> neighbours = network::neighbours(cave.graph);
  const NetworkPtr course = p.course();
  std::vector<Vec3d> points;
  for (size_t node = 0; node < cave.stations.size(); ++node) {
    const auto station = static_cast<size_t>(cave.stations[node]);
    if (is_chosen(p.only, neighbours[node].size(), p.of->stations[station].flags))
      points.push_back(course->stations[station].position + Vec3d(0, p.up, 0));
  }
  return points;
}

}  // namespace
}  // namespace vug::shot

VUG_POINT_LIST_KIND(stations) {
  return make_kind<std::vector<Vec3d>, Stations>("stations", "points", positions);
}
