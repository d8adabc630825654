// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_query.h>

namespace vug::workbench {
namespace {

std::string kept_pictures_of_scene(const SceneBench& bench, const std::vector<std::string>&) {
  std::string out;
  for (const KeptPicturePtr& each : bench.history().all())
    out += (out.empty() ? "" : " ") + std::to_string(each->number);
  return out;
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(kept_pictures) {
  return {"kept_pictures", "The numbers of the kept pictures.", "", 0, kept_pictures_of_scene};
}
