// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_query.h>

namespace vug::workbench {
namespace {

std::string samples_of_scene(const SceneBench& bench, const std::vector<std::string>&) {
  return std::to_string(bench.status().counters.samples);
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(samples) {
  return {"samples", "The number of samples of all pixels since the file was opened.", "", 0,
          samples_of_scene};
}
