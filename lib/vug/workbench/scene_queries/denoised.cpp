// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_query.h>

namespace vug::workbench {
namespace {

std::string denoised_of_scene(const SceneBench& bench, const std::vector<std::string>&) {
  const viewport::PreviewPtr picture = bench.status().picture;
  return std::to_string(picture ? picture->denoised_samples : 0);
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(denoised) {
  return {"denoised", "The samples per pixel of the denoised light; 0 without it.", "", 0,
          denoised_of_scene};
}
