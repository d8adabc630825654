// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/base/memory.h>
#include <vug/base/parallel.h>
#include <vug/drips/build_graph.h>
#include <vug/drips/chemistry.h>
#include <vug/drips/drop.h>
#include <vug/drips/film_network.h>
#include <vug/drips/growth.h>
#include <vug/drips/pools.h>
#include <vug/drips/surface.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace vug::drips {
namespace {

/// Stalagmites stand on floors that face up by this cosine; elsewhere drops run off.
constexpr double kStandingCosine = 0.45;
/// Standard deviation and maximum of the lean of stalactites in radians. They lean until their tip
/// is above the landing, which is aside of the root by the lean over this length in metres.
constexpr double kLean = 1.5 * kPi / 180, kMostLean = 3.4 * kPi / 180, kLeaning = 0.5;
/// Straws break or become stalactites: the median of their length in metres, its logarithm's
/// standard deviation, and the longest.
constexpr double kStraw = 0.12, kStrawSpread = 0.8, kLongestStraw = 1.5;
/// Bytes of a column that is searched, and of a drip with its films.
constexpr double kColumnBytes = 24, kDripBytes = 4000;

size_t index(int i) { return static_cast<size_t>(i); }

class Builder {
 public:
  Builder(const field::Field& rock, const GraphOptions& o)
      : rock_(rock), o_(o), film_(o.film), curve_(common_curve(o.girth)) {
    film_.temperature = o.temperature;
    film_.region = Box3d(o.from, o.to);
    graph_.drop = drop_volume(o.temperature, straw_diameter(o.temperature));
  }

  Graph build(const std::vector<Seep>& seeps) && {
    add(seeps);
    std::vector<int> walls = roofs();
    std::vector<int> floors;
    if (o_.run_out) floors = run_down(walls);
    const std::vector<int> landings = falls();
    if (o_.run_out && o_.over_floors) {
      floors.insert(floors.end(), landings.begin(), landings.end());
      run_over_floors(floors);
    }
    return std::move(graph_);
  }

 private:
  Node& node(int i) { return graph_.nodes[index(i)]; }

  void add(const std::vector<Seep>& seeps) {
    std::map<std::string, int> planes;
    for (const Seep& seep : seeps) {
      Node node;
      node.id = seep.id;
      node.position = seep.position;
      node.normal = seep.normal;
      node.water = {graph_.drop / seep.interval, seep_calcium(o_.temperature, o_.mixing),
                    o_.temperature, seep.age};
      if (seep.plane) {
        const auto [place, added] =
            planes.emplace(o_.planes->name(*seep.plane), static_cast<int>(graph_.planes.size()));
        if (added) graph_.planes.push_back(place->first);
        node.plane = place->second;
      }
      graph_.nodes.push_back(node);
    }
  }

  template <class Run>
  std::vector<Film> films(const std::vector<int>& sources, const Run& run) {
    std::vector<Film> out(sources.size());
    parallel_for(out.size(), [&](size_t i) { out[i] = run(node(sources[i])); });
    return out;
  }

  /// Returns the nodes in which roofs become walls.
  std::vector<int> roofs() {
    FilmNetwork network{.kind = EdgeKind::ceiling_film};
    for (size_t i = 0; i < graph_.nodes.size(); ++i) network.sources.push_back(static_cast<int>(i));
    const RandomKey key = RandomKey(o_.seed).at("film");
    network.films = films(network.sources, [&](const Node& seep) {
      return roof_film(rock_, seep.position, film_,
                       RandomStream(key.at(static_cast<uint64_t>(seep.id))));
    });
    network.merging = drip_spacing(o_.temperature, 1);
    std::vector<FilmEnd> kinds;
    for (const Film& film : network.films) kinds.push_back(film.end);
    std::vector<int> walls;
    const std::vector<int> ends = add_films(graph_, std::move(network));
    for (size_t i = 0; i < ends.size(); ++i) {
      if (ends[i] < 0) continue;
      ends_of_roofs(i, ends[i], kinds[i], walls);
    }
    return walls;
  }
  void ends_of_roofs(size_t seep, int end, FilmEnd kind, std::vector<int>& walls) {
    const bool drips = kind == FilmEnd::low || kind == FilmEnd::detached;
    // Water that drips where it seeps needs two nodes in the same place.
    if (static_cast<int>(seep) == end) {
      Node copy = node(end);
      const int from = end;
      end = static_cast<int>(graph_.nodes.size());
      graph_.edges.push_back(
          {EdgeKind::ceiling_film, from, end, {copy.position, copy.position}, copy.water});
      graph_.nodes.push_back(copy);
    }
    node(end).plane = node(static_cast<int>(seep)).plane;
    node(end).kind = drips                   ? NodeKind::drop
                     : kind == FilmEnd::wall ? NodeKind::bend
                                             : NodeKind::sink;
    if (kind == FilmEnd::wall) walls.push_back(end);
  }

  /// Follows films down walls; returns the nodes in which they reach floors.
  std::vector<int> run_down(const std::vector<int>& walls) {
    FilmNetwork network{.kind = EdgeKind::wall_film, .sources = walls};
    network.films =
        films(walls, [&](const Node& n) { return wall_film(rock_, n.position, film_); });
    network.merging = film_width(network.kind);
    std::vector<FilmEnd> kinds;
    for (const Film& film : network.films) kinds.push_back(film.end);
    const std::vector<int> ends = add_films(graph_, std::move(network));
    std::vector<int> floors;
    for (size_t i = 0; i < ends.size(); ++i) {
      if (ends[i] < 0) continue;
      const bool floor = kinds[i] == FilmEnd::floor;
      const bool drips = kinds[i] == FilmEnd::overhang || kinds[i] == FilmEnd::low;
      if (floor) floors.push_back(ends[i]);
      if (ends[i] == walls[i] && !floor) continue;
      node(ends[i]).kind = floor ? NodeKind::bend : drips ? NodeKind::drop : NodeKind::sink;
    }
    return floors;
  }

  /// Lets drops fall, and returns the landings.
  std::vector<int> falls() {
    std::vector<int> drops;
    for (size_t i = 0; i < graph_.nodes.size(); ++i)
      if (graph_.nodes[i].kind == NodeKind::drop) drops.push_back(static_cast<int>(i));
    std::vector<std::optional<Node>> landed(drops.size());
    parallel_for(drops.size(), [&](size_t i) { landed[i] = fall(node(drops[i])); });
    std::vector<int> landings;
    for (size_t i = 0; i < drops.size(); ++i) {
      if (!landed[i]) {
        node(drops[i]).kind = NodeKind::sink;  // The box contains no floor below it.
        continue;
      }
      landings.push_back(static_cast<int>(graph_.nodes.size()));
      const Node& drop = node(drops[i]);
      Edge edge{EdgeKind::fall, drops[i], landings.back(), {drop.position}, drop.water};
      if (drop.growth > 0) edge.path.push_back(drop.tip);
      edge.path.push_back(landed[i]->position);
      graph_.edges.push_back(std::move(edge));
      graph_.nodes.push_back(*landed[i]);
    }
    return landings;
  }

  /// Grows the stalactite at the drop, and finds the place below its tip. The place, and all random
  /// numbers, are independent of the age.
  std::optional<Node> fall(Node& drop) const {
    const Vec3d root = drop.position;
    const double interval = graph_.interval(drop);
    const auto below = [&](const Vec3d& from) {
      return VerticalLine(rock_, from, 0.1).crossing(from.y, o_.from.y);
    };
    // A point just below the roof, which is in the air.
    const Vec3d start = root + drop.normal * 0.005;
    const auto under = rock_.value(start) > 0 ? below(start) : std::nullopt;
    if (!under) return std::nullopt;
    RandomStream random(RandomKey(o_.seed).at("lean").at(static_cast<uint64_t>(drop.id)));
    double lean = std::clamp(kLean * random.normal(), -kMostLean, kMostLean);
    const double heading = random.uniform(0, kPi);
    drop.straw = random.uniform() < o_.straws;
    DripGrowth growth{.interval = interval, .curve = &curve_};
    if (drop.straw) {
      lean = 0;
      drop.longest = std::min(kStraw * maths::exp(kStrawSpread * random.normal()), kLongestStraw);
      growth.straw = drop.longest;
    }
    const Water arriving = drop.water;
    const StalactiteGrowth grown = growth.hanging(arriving);
    drop.arriving = arriving.calcium;
    drop.growth = grown.length;
    drop.water.calcium = grown.calcium;
    const double room = root.y - *under, reach = std::min(kLeaning, 0.5 * room);
    const double slope = maths::tan(lean);
    Vec3d aside = Vec3d(maths::cos(heading), 0, maths::sin(heading)) * (slope * reach);
    std::optional<double> floor;
    const Vec3d half = root + aside - Vec3d(0, 0.5 * room, 0);
    if (rock_.value(half) > 0) floor = below(half);
    if (!floor) {  // It would lean into the rock.
      aside = Vec3d(0, 0, 0);
      floor = under;
    }
    const double length = std::min(drop.growth, room);
    drop.tip = root + aside * std::min(1.0, length / reach) - Vec3d(0, length, 0);
    Node landing;
    landing.kind = NodeKind::landing;
    landing.id = drop.id;
    landing.position = Vec3d(root.x + aside.x, *floor, root.z + aside.z);
    landing.normal = normal_at(rock_, landing.position);
    landing.water = drop.water;
    landing.plane = drop.plane;
    landing.scatter = scatter_radius(std::max(0.0, root.y - *floor));
    if (landing.normal.y > kStandingCosine) {
      const double radius = trunk_radius(graph_.drop, o_.temperature, interval);
      landing.growth = growth.standing_height(arriving);
      landing.water.calcium = calcium_after(drop.water.calcium, o_.temperature,
                                            kPi * radius * radius, drop.water.discharge);
      if (const auto met = meeting_of(growth, arriving, root.y - *floor)) {
        landing.met = arriving.age * (1 - met->share);
        landing.met_at = met->height;
      }
    }
    return landing;
  }

  void run_over_floors(const std::vector<int>& sources) {
    FilmNetwork network{.kind = EdgeKind::floor_film, .sources = sources};
    network.films =
        films(sources, [&](const Node& n) { return floor_film(rock_, n.position, film_); });
    network.merging = film_width(network.kind);
    std::vector<FilmEnd> kinds;
    for (const Film& film : network.films) kinds.push_back(film.end);
    const std::vector<int> ends = add_films(graph_, std::move(network));
    std::vector<int> lows;
    for (size_t i = 0; i < ends.size(); ++i)
      if (ends[i] >= 0 && kinds[i] == FilmEnd::low && ends[i] != sources[i])
        lows.push_back(ends[i]);
    fill_pools(graph_, rock_, lows, film_, o_.spacing);
  }

  const field::Field& rock_;
  const GraphOptions& o_;
  FilmOptions film_;
  field::StalactiteCurve curve_;
  Graph graph_;
};

void require_buildable(const GraphOptions& o) {
  require_valid(o);
  if (!(o.temperature >= kColdest && o.temperature <= kWarmest))
    throw Error(ErrorCode::bad_input,
                fmt::format("a cave of {:g} degrees: dripstone grows at 0 to 30", o.temperature),
                {}, "give the temperature in degrees Celsius");
  if (!(o.mixing >= 0 && o.mixing <= 1 && o.girth > 0.004 && o.girth <= 1))
    throw Error(ErrorCode::bad_input,
                "the mixing of waters must be 0 to 1, and the girth of stalactites 4 mm to 1 m", {},
                "try a mixing of 0.5 and a girth of 5cm");
  require_memory(graph_memory(o), o.memory, "the graph of the drips", "use a larger spacing");
}

}  // namespace

double graph_memory(const SeepOptions& o) {
  const double columns =
      std::ceil((o.to.x - o.from.x) / o.spacing) * std::ceil((o.to.z - o.from.z) / o.spacing);
  return columns * (kColumnBytes + std::min(1.0, 2 * o.density) * kDripBytes);
}

Graph build_graph(const field::Field& rock, const GraphOptions& o) {
  require_buildable(o);
  return Builder(rock, o).build(edited(find_seeps(rock, o), rock, o, o.edits));
}

Graph ways_of_edits(const field::Field& rock, const GraphOptions& options) {
  require_buildable(options);
  GraphOptions o = options;
  o.run_out = true, o.over_floors = false;
  const bool refers = !o.edits.moved.empty() || !o.edits.removed.empty();
  std::vector<Seep> seeps =
      edited(refers ? find_seeps(rock, o) : std::vector<Seep>(), rock, o, o.edits);
  std::set<int64_t> moved;
  for (const DripEdits::Move& each : o.edits.moved) moved.insert(each.drip);
  std::erase_if(seeps, [&](const Seep& each) { return each.id >= 0 && !moved.contains(each.id); });
  return Builder(rock, o).build(seeps);
}

}  // namespace vug::drips
