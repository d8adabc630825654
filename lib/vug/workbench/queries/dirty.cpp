// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/facade_bench.h>
#include <vug/workbench/query.h>

namespace vug::workbench {
namespace {

std::string dirty_value(const FacadeBench& bench, const std::vector<std::string>&) {
  return bench.has_document() && !bench.stack().is_clean() ? "yes" : "no";
}

}  // namespace
}  // namespace vug::workbench

VUG_QUERY(dirty) {
  return {"dirty", "Whether the document differs from its file.", "", 0, dirty_value};
}
