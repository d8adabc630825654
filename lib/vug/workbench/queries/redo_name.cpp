// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/facade_bench.h>
#include <vug/workbench/query.h>

namespace vug::workbench {
namespace {

std::string redo_name_value(const FacadeBench& bench, const std::vector<std::string>&) {
  return bench.stack().redo_name();
}

}  // namespace
}  // namespace vug::workbench

VUG_QUERY(redo_name) {
  return {"redo_name", "Name of the step that redo repeats.", "", 0, redo_name_value};
}
