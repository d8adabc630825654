// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/facade_bench.h>
#include <vug/workbench/query.h>

namespace vug::workbench {
namespace {

std::string undo_name_value(const FacadeBench& bench, const std::vector<std::string>&) {
  return bench.stack().undo_name();
}

}  // namespace
}  // namespace vug::workbench

VUG_QUERY(undo_name) {
  return {"undo_name", "Name of the step that undo takes back.", "", 0, undo_name_value};
}
