// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/inherit.h>
#include <vug/cells/transfer_to_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vug::cells {
namespace {

constexpr std::array<std::string_view, 4> kAnew = {kPlace, "N", kHeight, "outlet"};

bool starts_anew(const std::string& name) {
  return std::find(kAnew.begin(), kAnew.end(), name) != kAnew.end();
}

/// The cells where they are now, with the attributes to inherit.
Simulation displaced(const Simulation& from) {
  Network network = from.network();
  const Attributes& all = from.attributes();
  if (all.find(kPlace)) network.position = all.values<Vec3f>(std::string(kPlace));
  if (all.find(kHeight)) {
    const auto& height = all.values<float>(std::string(kHeight));
    for (size_t i = 0; i < height.size(); ++i) network.position[i] += network.normal[i] * height[i];
  }
  Simulation out(std::make_shared<const Network>(std::move(network)), RandomKey(0));
  for (const Attribute& each : all.all())
    if (!starts_anew(each.name))
      std::visit(
          [&]<class T>(const Column<T>& column) {
            out.attributes().column<T>(each.name).now = column.now;
          },
          each.column);
  out.set_states(from.states());
  return out;
}

template <class T>
T value_at(const std::vector<float>& values, size_t i) {
  if constexpr (std::is_same_v<T, Vec3f>)
    return {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
  else if constexpr (std::is_same_v<T, int32_t>)
    return static_cast<int32_t>(std::lround(values[i]));
  else
    return values[i];
}

}  // namespace

void inherit_attributes(const Simulation& from, Simulation& to, Progress& progress) {
  const Simulation now = displaced(from);
  mesh::Mesh points;
  points.positions = to.network().position;
  points.normals = to.network().normal;
  transfer_to_mesh(now, points, {}, progress);
  for (const Attribute& each : now.attributes().all()) {
    const auto found =
        std::find_if(points.attributes.begin(), points.attributes.end(),
                     [&](const mesh::Attribute& other) { return other.name == each.name; });
    std::visit(
        [&]<class T>(const Column<T>&) {
          std::vector<T>& values = to.attributes().column<T>(each.name).now;
          for (size_t i = 0; i < values.size(); ++i) values[i] = value_at<T>(found->values, i);
        },
        each.column);
  }
  const mesh::Attribute* gone = mesh::find_attribute(points, kTransparent, 1);
  std::vector<CellState> states(to.network().size(), CellState::active);
  for (size_t i = 0; gone && i < states.size(); ++i)
    if (gone->values[i] > 0.5f) states[i] = CellState::transparent;
  to.set_states(std::move(states));
}

}  // namespace vug::cells
