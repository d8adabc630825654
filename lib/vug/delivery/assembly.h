// Everything a shot shows, as plain data for other programs.
#pragma once

#include <vug/building/builder.h>
#include <vug/exchange/assembly.h>

#include <string>
#include <vector>

namespace vug::delivery {

/// The shot with meshes for what it would trace directly, also in what it places: assemble wants
/// it so. Must outlive the Builder that is made of it.
shot::Shot with_meshes(shot::Shot shot);

/// What rebuilds all of the shot.
exchange::Provenance provenance_of(const shot::Shot& shot);

struct AssemblyResult {
  exchange::Assembly assembly;           ///< In metres, y up; without volumes.
  std::vector<std::string> unsupported;  ///< In sentences, what cannot be told.
};

/// Objects with their looks at every vertex, what is placed as groups of one part, cameras with
/// the shape of their render's picture, and lights. Builds all meshes.
AssemblyResult build_assembly(building::Builder& builder);

}  // namespace vug::delivery
