// SPDX-License-Identifier: Apache-2.0
#include <vug/scene/text_at.h>
#include <vug/workbench/scene_query.h>

namespace vug::workbench {
namespace {

std::string scene_selected(const SceneBench& bench, const std::vector<std::string>&) {
  return std::string(scene::text_at(bench.text(), bench.selection()));
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(selected) { return {"selected", "The selected text.", "", 0, scene_selected}; }
