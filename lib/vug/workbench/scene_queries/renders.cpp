// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_query.h>

#include <fmt/format.h>

namespace vug::workbench {
namespace {

std::string renders_of_scene(const SceneBench& bench, const std::vector<std::string>&) {
  std::string out;
  if (!bench.queue) return out;
  for (const QueuedRender& each : bench.queue->all())
    out += fmt::format("{}{} {}", out.empty() ? "" : ", ", each.number,
                       render_state_names()[static_cast<size_t>(each.state)]);
  return out;
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(renders) {
  return {"renders", "The renders of the queue with their states.", "", 0, renders_of_scene};
}
