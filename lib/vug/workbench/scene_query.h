// SPDX-License-Identifier: Apache-2.0
// The queries of the scene bench; see workbench/query.h.
#pragma once

#include <vug/workbench/query.h>
#include <vug/workbench/scene_bench.h>

namespace vug::workbench {

using SceneQuery = QueryOf<SceneBench>;

/// The queries in scene_queries/; generated from the list in CMakeLists.txt.
const std::vector<const SceneQuery*>& scene_queries();

/// Evaluates an assertion; see `expect` for a facade bench.
void expect(const SceneBench& bench, const std::vector<std::string>& words);

}  // namespace vug::workbench

/// Opens the one definition that the file of a query exports; see VUG_EXPORT_KIND.
#define VUG_SCENE_QUERY(name) VUG_EXPORT_KIND(vug::workbench, SceneQuery, name##_scene_query)
