// SPDX-License-Identifier: Apache-2.0
// Converts a shot to an exchange::Assembly, the plain data for other programs.
#pragma once

#include <vug/building/builder.h>
#include <vug/exchange/assembly.h>

#include <string>
#include <vector>

namespace vug::delivery {

/// The shot with meshes instead of directly traced level sets, also in placed scenes, as required
/// by build_assembly. It must outlive the Builder that uses it.
shot::Shot with_meshes(shot::Shot shot);

/// The provenance from which the shot can be rebuilt.
exchange::Provenance provenance_of(const shot::Shot& shot);

struct AssemblyResult {
  exchange::Assembly assembly;           ///< In metres, y up; without volumes.
  std::vector<std::string> unsupported;  ///< Sentences about omitted features.
};

/// Converts objects with materials baked per vertex, instances as groups with one prototype each,
/// cameras with the aspect ratio of their render, and lights. Builds all meshes.
AssemblyResult build_assembly(building::Builder& builder);

}  // namespace vug::delivery
