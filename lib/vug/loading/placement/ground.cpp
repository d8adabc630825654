// SPDX-License-Identifier: Apache-2.0
// Terrain: passages that leave the ground, and warnings about its heights and place.
#include <vug/base/pluralize.h>
#include <vug/loading/placement/checks.h>
#include <vug/terrain/exits.h>
#include <vug/terrain/terrain.h>

#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>

namespace vug::loading {
namespace {

/// The share of a cell by which heights between the cells are uncertain, and the least height.
constexpr double kShareOfCell = 0.1, kLeast = 0.5;

void check_terrain(const terrain::TerrainSource& ground, const SourceLocation& where,
                   Diagnostics& diagnostics) {
  for (const terrain::TerrainWarning& warning : ground.warnings)
    diagnostics.warning(where, warning.message, warning.hint);
  if (!ground.around) return;
  const std::vector<terrain::Exit> exits =
      terrain::exits(*ground.around, ground, std::max(kLeast, kShareOfCell * ground.cell));
  if (exits.empty()) return;
  const terrain::Exit& worst = exits.front();
  const std::string others = exits.size() == 1
                                 ? ""
                                 : fmt::format(", and passages at {} leave it as well",
                                               pluralize(exits.size() - 1, "other place"));
  const std::string at = worst.station.empty() ? "" : fmt::format("station '{}', ", worst.station);
  diagnostics.warning(
      where,
      fmt::format("the roof of a passage is {:.1f} m above the ground at {}{}{}", worst.height, at,
                  position_text(worst.position), others),
      "compare the heights of the survey and the terrain, correct them with 'raise', or mark the "
      "station as an entrance");
}

}  // namespace

void check_ground(const Loaded& scene, const shot::Shot& part, Diagnostics& diagnostics) {
  std::unordered_set<const field::Node*> seen;
  for (const shot::VolumePtr& volume : part.volumes) {
    if (volume->source_mesh || !volume->field.node()) continue;
    std::vector<field::NodePtr> pending = {volume->field.node()};
    while (!pending.empty()) {
      const field::NodePtr node = std::move(pending.back());
      pending.pop_back();
      if (!seen.insert(node.get()).second) continue;
      for (field::NodePtr& child : node->children()) pending.push_back(std::move(child));
      const auto* const ground = dynamic_cast<const terrain::TerrainNode*>(node.get());
      if (!ground) continue;
      const scene::Provenance* const made = scene.provenance.find(node);
      check_terrain(ground->source(), made ? made->where : volume->where, diagnostics);
    }
  }
}

}  // namespace vug::loading
