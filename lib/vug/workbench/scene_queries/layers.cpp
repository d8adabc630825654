// SPDX-License-Identifier: Apache-2.0
#include <vug/viewport/shown_layer.h>
#include <vug/workbench/scene_query.h>

namespace vug::workbench {
namespace {

std::string layers_of_scene(const SceneBench& bench, const std::vector<std::string>&) {
  const viewport::PreviewPtr picture = bench.status().picture;
  std::string out;
  if (picture)
    for (const std::string& each : viewport::layers_to_show(*picture->light))
      out += (out.empty() ? "" : " ") + each;
  return out;
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(layers) {
  return {"layers", "The layers of the picture that can be shown.", "", 0, layers_of_scene};
}
