// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/cells/to_points.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vug::cells {
namespace {

using volume::PointAttribute;
using volume::Points;

constexpr const char* kFull = "P_full";
constexpr std::array kStates = {CellState::sleeping, CellState::receiving, CellState::distributing,
                                CellState::active, CellState::transparent};

template <class T>
const std::vector<T>* find(const Simulation& simulation, const std::string& name) {
  const Attribute* known = simulation.attributes().find(name);
  const auto* column = known ? std::get_if<Column<T>>(&known->column) : nullptr;
  return column ? &column->now : nullptr;
}

std::vector<float> radii(const Network& network) {
  std::vector<float> out(network.size());
  for (size_t i = 0; i < out.size(); ++i)
    out[i] = static_cast<float>(std::sqrt(static_cast<double>(network.area[i]) / kPi));
  return out;
}

/// 16 bits keep full precision (11 bits) only down to 6e-5.
bool half_suffices(const std::vector<float>& lengths) {
  return std::all_of(lengths.begin(), lengths.end(), [](float x) { return x > 1e-4f; });
}

void add_of_network(const Simulation& simulation, Points& out) {
  const Network& network = simulation.network();
  const auto* normals = find<Vec3f>(simulation, "N");
  out.attributes.push_back({"N", normals ? *normals : network.normal, true});
  if (!simulation.attributes().find("pscale")) {
    std::vector<float> pscale = radii(network);
    const bool half = half_suffices(pscale);
    out.attributes.push_back({"pscale", std::move(pscale), half});
  }
  const auto several = [](uint32_t object) { return object > 0; };
  if (std::any_of(network.object.begin(), network.object.end(), several) &&
      !simulation.attributes().find("object"))
    out.attributes.push_back(
        {"object", std::vector<int32_t>(network.object.begin(), network.object.end())});
}

/// Values of the points, sorted by cell index.
template <class T>
std::vector<T> by_cell(const std::vector<T>& values, const std::vector<int32_t>& id) {
  std::vector<T> out(values.size());
  for (size_t k = 0; k < values.size(); ++k) out[static_cast<size_t>(id[k])] = values[k];
  return out;
}

void require_ids(const std::vector<int32_t>& id, size_t cells) {
  if (id.size() != cells)
    throw Error(ErrorCode::bad_input,
                fmt::format("there are {} points, but {} cells", id.size(), cells), {},
                "points can be continued only with the cells they were made from: the same mesh, "
                "spacing and seed");
  std::vector<bool> seen(cells);
  for (const int32_t i : id) {
    const auto at = static_cast<size_t>(i);
    if (i < 0 || at >= cells || seen[at])
      throw Error(ErrorCode::bad_input, "the ids of the points are not consecutive from 0");
    seen[at] = true;
  }
}

template <class T>
void set_column(Simulation& simulation, const std::string& name, std::vector<T> values) {
  Column<T>& column = simulation.attributes().column<T>(name);
  column.now = std::move(values);
  column.next.clear();
}

bool differ(const std::vector<Vec3f>& a, const std::vector<Vec3f>& b, double limit) {
  return ordered_sum(a.size(), size_t{0}, [&](size_t i) -> size_t {
           return static_cast<double>((a[i] - b[i]).length()) > limit ? 1 : 0;
         }) > 0;
}

/// Restores positions and normals that differ from the network by more than 16-bit rounding.
void restore_places(Simulation& simulation, const Points& points, const std::vector<int32_t>& id,
                    double apart) {
  const Network& network = simulation.network();
  std::vector<Vec3f> position = by_cell(points.position, id);
  if (differ(position, network.position, apart)) set_column(simulation, "P", std::move(position));
  std::vector<Vec3f> normal = by_cell(points.values<Vec3f>("N"), id);
  if (differ(normal, network.normal, 0.1 * kPi / 180))
    set_column(simulation, "N", std::move(normal));
}

std::vector<CellState> states_of(const Points& points, const std::vector<int32_t>& id) {
  std::vector<CellState> states(points.size(), CellState::active);
  for (const CellState state : kStates) {
    const std::vector<uint8_t>& member = points.members(std::string(name_of(state)));
    for (size_t k = 0; k < id.size(); ++k)
      if (member[k]) states[static_cast<size_t>(id[k])] = state;
  }
  return states;
}

}  // namespace

volume::Points to_points(const Simulation& simulation, PointFormat keep) {
  const Network& network = simulation.network();
  Points out;
  const auto* moved = find<Vec3f>(simulation, "P");
  out.position = moved ? *moved : network.position;
  std::vector<int32_t> id(network.size());
  for (size_t i = 0; i < id.size(); ++i) id[i] = static_cast<int32_t>(i);
  out.attributes.push_back({"id", std::move(id)});
  if (keep == PointFormat::interchange) add_of_network(simulation, out);
  for (const Attribute& each : simulation.attributes().all()) {
    if (each.name == "id")
      throw Error(ErrorCode::bad_input,
                  "cells have an attribute 'id', which is reserved for the numbers of points", {},
                  "give it another name");
    const bool exact = keep == PointFormat::exact;
    if (!exact && (each.name == "P" || each.name == "N")) continue;
    const std::string name = each.name == "P" ? kFull : each.name;
    const bool half = !exact && each.name == "Cd";
    std::visit(
        [&](const auto& column) {
          out.attributes.push_back({name, column.now, half});
        },
        each.column);
  }
  for (const CellState state : kStates) {
    volume::PointGroup group{std::string(name_of(state)), std::vector<uint8_t>(network.size())};
    for (size_t i = 0; i < network.size(); ++i) group.member[i] = simulation.states()[i] == state;
    out.groups.push_back(std::move(group));
  }
  return out;
}

double voxel_of_points(const Network& network) {
  const double area = ordered_sum(network.size(), 0.0,
                                  [&](size_t i) { return static_cast<double>(network.area[i]); });
  const double each = network.size() > 0 ? area / static_cast<double>(network.size()) : 0;
  return volume::voxel_for_points(each > 0 ? each : 1);
}

void restore(Simulation& simulation, const volume::Points& points, int step, PointFormat keep,
             double apart) {
  const std::vector<int32_t>& id = points.values<int32_t>("id");
  require_ids(id, simulation.network().size());
  const bool shown = keep == PointFormat::interchange;
  if (shown) restore_places(simulation, points, id, apart);
  for (const PointAttribute& each : points.attributes) {
    const std::string& name = each.name;
    if (name == "id" || (shown && (name == "N" || name == "pscale" || name == "object"))) continue;
    std::visit(
        [&](const auto& values) {
          set_column(simulation, name == kFull ? "P" : name, by_cell(values, id));
        },
        each.values);
  }
  simulation.set_states(states_of(points, id));
  simulation.set_step(step);
}

}  // namespace vug::cells
