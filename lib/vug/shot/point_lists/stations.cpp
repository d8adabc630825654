// SPDX-License-Identifier: Apache-2.0
// Stations of a network as a list of points.
#include <vug/network/reduction.h>
#include <vug/shot/passage_line.h>

namespace vug::shot {
namespace {

enum class Choice { all, junctions, ends };

struct Stations : PointLine {
  Choice only = Choice::all;
  double up = 0;

  static void describe(Schema<Stations>& s) {
    s.doc(
        "The positions of the stations of a network that have legs underground, in the order of "
        "the network: all, those where at least three legs meet, or the ends of passages.");
    describe_network(s);
    s.choice("only", &Stations::only,
             {{"all", Choice::all}, {"junctions", Choice::junctions}, {"ends", Choice::ends}},
             "which stations")
        .param("up", &Stations::up, any_length("how far above the middle of the passage"));
    describe_course(s);
  }
};

bool is_chosen(Choice only, size_t degree) {
  switch (only) {
    case Choice::all:
      return true;
    case Choice::junctions:
      return degree > 2;
    case Choice::ends:
      return degree == 1;
  }
  return false;
}

std::vector<Vec3d> positions(const Stations& p) {
  const network::PlacedGraph cave = network::cave_graph(*p.of);
  const std::vector<std::vector<int>> neighbours = network::neighbours(cave.graph);
  const network::Network course = p.course();
  std::vector<Vec3d> points;
  for (size_t node = 0; node < cave.stations.size(); ++node)
    if (is_chosen(p.only, neighbours[node].size()))
      points.push_back(course.stations[static_cast<size_t>(cave.stations[node])].position +
                       Vec3d(0, p.up, 0));
  return points;
}

}  // namespace
}  // namespace vug::shot

VUG_POINT_LIST_KIND(stations) {
  return make_kind<std::vector<Vec3d>, Stations>("stations", "points", positions);
}
