// SPDX-License-Identifier: Apache-2.0
// A network that the turtle of an L-system draws.
#include <vug/base/cell.h>
#include <vug/shot/lsystem_plan.h>
#include <vug/shot/networks.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace vug::shot {
namespace {

/// Points that are nearer than this are one station, so that drawings which return to a point close
/// a loop in spite of rounding, metres.
constexpr double kSamePlace = 1e-3;

struct Turtle {
  LSystemPtr of;
  double ratio = 1;
  bool upstream = false;

  static void describe(Schema<Turtle>& s) {
    s.doc(
         "The lines that the turtle of an L-system draws. Points within 1 mm are one station. "
         "Instances give their names to the stations at which they are; the other names are "
         "numbers, in the order of the drawing. The widths of lines are those of the passages.")
        .cite("prusinkiewicz1990")
        .param("of", &Turtle::of, {.doc = "the L-system", .required = true})
        .param("ratio", &Turtle::ratio,
               {.doc = "width by height of the passages", .min = 0.01, .max = 100})
        .param("upstream", &Turtle::upstream,
               {.doc = "the turtle draws against the water, from the spring to the sinks"});
  }
};

/// Finds the station at a point; cells of the size of the tolerance bound the search.
class StationIndex {
 public:
  std::optional<int> find(const Vec3d& point, const network::Network& network) const {
    std::optional<int> found;
    const auto visit = [&](const Cell& cell) {
      const auto stations = cells_.find(cell);
      if (found || stations == cells_.end()) return;
      for (const int station : stations->second)
        if (!found && (network.stations[static_cast<size_t>(station)].position - point).length() <=
                          kSamePlace)
          found = station;
    };
    const Vec3d reach(kSamePlace);
    for_each_cell(cell_at(point - reach, kSamePlace), cell_at(point + reach, kSamePlace), visit);
    return found;
  }
  void add(const Vec3d& point, int station) {
    cells_[cell_at(point, kSamePlace)].push_back(station);
  }

 private:
  CellMap<std::vector<int>> cells_;
};

/// The index of the station at a point, which is added if it is new.
int station_at(const lsystem::Station& drawn, double ratio, StationIndex& index,
               network::Network& network) {
  const std::optional<int> known = index.find(drawn.position, network);
  const int at = known.value_or(static_cast<int>(network.stations.size()));
  if (!known) {
    network.stations.emplace_back().position = drawn.position;
    index.add(drawn.position, at);
  }
  // Where lines of several widths meet, the widest one gives the section.
  auto& section = network.stations[static_cast<size_t>(at)].section;
  if (drawn.radius > 0 && drawn.radius > (section ? *section->left : 0)) {
    const double half_height = drawn.radius / ratio;
    section = network::CrossSection{drawn.radius, drawn.radius, half_height, half_height};
  }
  return at;
}

/// Names the stations at which instances are; equal names are numbered in the order of the drawing.
void name_by_instances(const lsystem::Drawing& drawing, const StationIndex& index,
                       network::Network& network) {
  std::map<std::string, std::set<int>> places;
  std::map<std::string, std::vector<int>> stations_of;
  for (const lsystem::Instance& instance : drawing.instances) {
    const std::string& name = drawing.names[instance.name];
    const auto at = index.find(instance.position, network);
    if (at && places[name].insert(*at).second) stations_of[name].push_back(*at);
  }
  for (const auto& [name, stations] : stations_of)
    for (size_t i = 0; i < stations.size(); ++i) {
      network::Station& station = network.stations[static_cast<size_t>(stations[i])];
      std::string own = stations.size() == 1 ? name : fmt::format("{}.{}", name, i + 1);
      if (station.name.empty())
        station.name = std::move(own);
      else
        station.equated.push_back(std::move(own));
    }
  for (size_t i = 0; i < network.stations.size(); ++i)
    if (network.stations[i].name.empty()) network.stations[i].name = fmt::format("{}", i + 1);
}

void require_valid_widths(const lsystem::Drawing& drawing, const std::string& name) {
  for (const lsystem::Axis& axis : drawing.axes)
    for (const lsystem::Station& station : axis.stations)
      if (!(2 * station.radius <= kLargestPassage))
        throw Error(ErrorCode::bad_input,
                    fmt::format("the turtle of '{}' draws a passage of {:g} m width", name,
                                2 * station.radius),
                    {}, fmt::format("passages are at most {:g} m wide", kLargestPassage));
}

NetworkPtr network_drawn_by(const Turtle& turtle) {
  const lsystem::DrawingPtr drawing = turtle.of->drawing();
  require_valid_widths(*drawing, turtle.of->name);
  auto network = std::make_shared<network::Network>();
  StationIndex index;
  std::set<std::pair<int, int>> joined;  // Lines that are drawn twice are one leg.
  for (const lsystem::Axis& axis : drawing->axes) {
    if (axis.stations.size() < 2) continue;
    std::optional<int> previous;
    for (const lsystem::Station& station : axis.stations) {
      const int at = station_at(station, turtle.ratio, index, *network);
      if (previous && *previous != at && joined.insert(std::minmax(*previous, at)).second)
        network->legs.push_back(
            {.from = turtle.upstream ? at : *previous, .to = turtle.upstream ? *previous : at});
      previous = at;
    }
  }
  if (network->legs.empty())
    throw Error(ErrorCode::bad_input,
                fmt::format("the turtle of '{}' draws no line, so that the network has no legs",
                            turtle.of->name),
                {}, "add a line to its word, such as F(5m)");
  name_by_instances(*drawing, index, *network);
  return network;
}

}  // namespace
}  // namespace vug::shot

VUG_NETWORK_KIND(turtle) {
  return make_kind<NetworkPtr, Turtle>("turtle", "network", network_drawn_by);
}
