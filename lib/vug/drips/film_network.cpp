// SPDX-License-Identifier: Apache-2.0
#include <vug/base/cell.h>
#include <vug/drips/chemistry.h>
#include <vug/drips/film_network.h>
#include <vug/field/path.h>

#include <algorithm>
#include <map>

namespace vug::drips {
namespace {

/// A film that runs into the point of another film.
struct Join {
  int film = -1;
  size_t point = 0;
};

/// Cuts each film where it meets an earlier one, which is thus never cut again.
std::vector<Join> join_films(std::vector<Film>& films, double merging) {
  struct Place {
    Vec3d at;
    Join join;
  };
  CellMap<std::vector<Place>> places;
  std::vector<Join> joins(films.size());
  const auto nearest_lower = [&](const Vec3d& p) {
    Join best;
    double least = merging * merging;
    const Cell cell = cell_at(p, merging);
    for_each_cell({cell[0] - 1, cell[1] - 1, cell[2] - 1}, {cell[0] + 1, cell[1] + 1, cell[2] + 1},
                  [&](const Cell& c) {
                    const auto found = places.find(c);
                    if (found == places.end()) return;
                    for (const Place& place : found->second) {
                      const double square = (place.at - p).length2();
                      if (square < least && place.at.y <= p.y + 0.1 * merging) {
                        least = square;
                        best = place.join;
                      }
                    }
                  });
    return best;
  };
  for (size_t i = 0; i < films.size(); ++i) {
    std::vector<Vec3d>& path = films[i].path;
    for (size_t k = 0; k < path.size(); ++k) {
      const Join join = nearest_lower(path[k]);
      if (join.film < 0) continue;
      path.resize(k + 1);
      path.push_back(films[static_cast<size_t>(join.film)].path[join.point]);
      joins[i] = join;
      break;
    }
    const size_t own = path.size() - (joins[i].film < 0 ? 0 : 1);
    for (size_t k = 0; k < own; ++k)
      places[cell_at(path[k], merging)].push_back({path[k], {static_cast<int>(i), k}});
  }
  return joins;
}

}  // namespace

double film_width(EdgeKind kind) {
  switch (kind) {
    case EdgeKind::wall_film:
      return 0.03;
    case EdgeKind::floor_film:
      return 0.05;
    case EdgeKind::overflow:
      return 0.1;
    default:
      return 0.012;
  }
}

Water after_film(Water water, const std::vector<Vec3d>& path, double width) {
  if (water.discharge > 0)
    water.calcium = calcium_after(water.calcium, water.temperature,
                                  width * field::path_length(path), water.discharge);
  return water;
}

Water mixed(const Water& a, const Water& b) {
  Water out = a.discharge > 0 ? a : b;
  out.discharge = a.discharge + b.discharge;
  if (!(out.discharge > 0)) return out;
  const double part = b.discharge / out.discharge;
  out.calcium = (1 - part) * a.calcium + part * b.calcium;
  out.temperature = (1 - part) * a.temperature + part * b.temperature;
  out.age = std::max(a.age, b.age);
  return out;
}

std::vector<int> add_films(Graph& graph, FilmNetwork network) {
  std::vector<Film>& films = network.films;
  const std::vector<Join> joins = join_films(films, network.merging);
  // The nodes of each film by the index of their point: its source, the confluences and its end.
  std::vector<std::map<size_t, int>> nodes(films.size());
  std::vector<int> ends(films.size(), -1);
  for (size_t i = 0; i < films.size(); ++i) {
    nodes[i][0] = network.sources[i];
    if (joins[i].film >= 0) {
      auto& others = nodes[static_cast<size_t>(joins[i].film)];
      const Film& other = films[static_cast<size_t>(joins[i].film)];
      if (!others.contains(joins[i].point)) {
        Node node;
        node.kind = NodeKind::confluence;
        node.id = graph.nodes[static_cast<size_t>(network.sources[i])].id;
        node.position = other.path[joins[i].point];
        node.normal = other.normal;
        others[joins[i].point] = static_cast<int>(graph.nodes.size());
        graph.nodes.push_back(node);
      }
      nodes[i][films[i].path.size() - 1] = others[joins[i].point];
    } else if (films[i].path.size() > 1) {
      Node node;
      node.kind = NodeKind::sink;
      node.id = graph.nodes[static_cast<size_t>(network.sources[i])].id;
      node.position = films[i].path.back();
      node.normal = films[i].normal;
      ends[i] = static_cast<int>(graph.nodes.size());
      nodes[i][films[i].path.size() - 1] = ends[i];
      graph.nodes.push_back(node);
    } else {
      ends[i] = network.sources[i];  // It ends where it starts.
    }
  }
  // Films run into earlier ones only, so that all inflows of a film are known before it is added.
  for (size_t i = films.size(); i-- > 0;) {
    for (auto from = nodes[i].begin(), to = std::next(from); to != nodes[i].end(); ++from, ++to) {
      const auto& path = films[i].path;
      Edge edge{network.kind, from->second, to->second, {}, {}};
      edge.path.assign(path.begin() + static_cast<std::ptrdiff_t>(from->first),
                       path.begin() + static_cast<std::ptrdiff_t>(to->first) + 1);
      edge.water = graph.nodes[static_cast<size_t>(from->second)].water;
      const Water arrived = after_film(edge.water, edge.path, film_width(network.kind));
      Water& there = graph.nodes[static_cast<size_t>(to->second)].water;
      there = mixed(there, arrived);
      graph.edges.push_back(std::move(edge));
    }
  }
  return ends;
}

}  // namespace vug::drips
