// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/quality.h>
#include <vug/delivery/describe_cells.h>
#include <vug/shot/queries.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace vug::delivery {
namespace {

using Json = nlohmann::ordered_json;

Json links(const cells::Quality& quality) {
  Json out = Json::object();
  for (size_t d = 0; d < quality.degrees.size(); ++d) {
    const bool last = d + 1 == quality.degrees.size();
    if (quality.degrees[d] > 0) out[fmt::format("{}{}", d, last ? "+" : "")] = quality.degrees[d];
  }
  return out;
}

Json harmonising(const std::vector<cells::RelaxStep>& steps) {
  Json out = Json::array();
  for (const cells::RelaxStep& step : steps)
    out.push_back(
        {{"nearest", step.nearest}, {"variation", step.variation}, {"moved", step.displacement}});
  return out;
}

Json states(const std::vector<cells::CellState>& all) {
  std::array<size_t, 5> counts{};
  for (const cells::CellState state : all) ++counts[static_cast<size_t>(state)];
  Json out = Json::object();
  for (size_t s = 0; s < counts.size(); ++s)
    if (counts[s] > 0)
      out[std::string(cells::name_of(static_cast<cells::CellState>(s)))] = counts[s];
  return out;
}

}  // namespace

Json describe_cells(building::Builder& builder, const std::string& name) {
  const shot::CellsPtr plan = shot::find_cells(builder.shot(), name);
  const building::CellLayerPtr layer = builder.cell_layer(plan);
  const cells::Network& network = layer->network();
  const cells::Quality quality = cells::quality(network);
  const auto pieces = cells::components(network.links);
  Json on = Json::object();
  for (uint32_t i = 0; i < plan->on.size(); ++i)
    on[plan->on[i]->name] = std::count(network.object.begin(), network.object.end(), i);
  return {{"cells", network.size()},
          {"on", on},
          {"spacing", network.spacing},
          {"components", pieces.empty() ? 0 : 1 + *std::max_element(pieces.begin(), pieces.end())},
          {"nearest", quality.nearest},
          {"variation", quality.variation},
          {"links", links(quality)},
          {"five_to_seven", quality.share(5, 7)},
          {"states", states(layer->simulation.states())},
          {"steps", layer->simulation.step()},
          {"harmonising", harmonising(layer->relaxation)}};
}

}  // namespace vug::delivery
