// SPDX-License-Identifier: Apache-2.0
// Known facts about the scenes of data/scenes, from tests/data/scene_facts.json, and their
// comparison with meshes.
#pragma once

#include <vug/loading/load.h>
#include <vug/metrics/report.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace vug::session {

/// Every scene of data/scenes and its folders, as "teaching/morph.vug", in order.
std::vector<std::string> scene_names();

/// Loads a scene of data/scenes; fails the test if it has faults.
loading::Loaded load_scene(const std::string& name,
                           const std::vector<scene::Override>& overrides = {},
                           std::optional<uint64_t> seed = {});

/// The file: {"scenes": {NAME: {"defines": {...}, "external": {...}, "meshes": {MESH: FACTS}}},
/// "shared": {MESH: FACTS}}. "external" gives parameters that are files of the external test data;
/// without the data, the scene is skipped. FACTS hold components, genus, area, volume, bounds and,
/// where 1 % is not right, "tolerance", a share. A count may be a range [least, most]. "residual"
/// is how far vertices may lie from the exact field (rms, voxels); 0.01 unless a scene is built far
/// coarser than it is meant to be. "attributes" are ranges that the means over the vertices lie in,
/// by name.
const nlohmann::json& scene_facts();

/// Fails the test if the report differs from the facts, and prints the report.
void expect_facts(const metrics::Report& report, const nlohmann::json& facts);

/// The same for the words of the scene's L-systems: "words" of a scene's facts are {GRAMMAR:
/// {"modules": N, "symbols": {NAME: N}}}, as they are drawn where "drawn" is true.
void expect_words(const shot::Shot& shot, const nlohmann::json& facts);

/// Compares the attributes of the mesh with the facts.
void expect_attributes(const mesh::Mesh& mesh, const nlohmann::json& facts);

}  // namespace vug::session
