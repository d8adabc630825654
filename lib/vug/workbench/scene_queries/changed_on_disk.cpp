// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_query.h>

namespace vug::workbench {
namespace {

std::string scene_changed_on_disk(const SceneBench& bench, const std::vector<std::string>&) {
  return bench.changed_on_disk();
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(changed_on_disk) {
  return {"changed_on_disk", "The lines of the file that another program has changed; empty: none.",
          "", 0, scene_changed_on_disk};
}
