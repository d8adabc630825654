// A skin: a network of cells on meshes and what its rules have made of it.
#pragma once

#include <vug/base/progress.h>
#include <vug/cells/build.h>
#include <vug/cells/simulation.h>
#include <vug/field/sampled.h>
#include <vug/mesh/mesh.h>
#include <vug/shot/cells_plan.h>

#include <memory>
#include <vector>

namespace vug::building {

/// What cells stand on.
struct CellSupport {
  mesh::MeshPtr mesh;
  std::shared_ptr<const field::SampledGrid> solid;  ///< The level set whose surface it is, for
                                                    ///< masks; null where there is none.
};

struct CellLayer {
  cells::Simulation simulation;            ///< After its run; it holds the network.
  std::vector<cells::RelaxStep> relaxation;  ///< How harmonising went.

  const cells::Network& network() const { return simulation.network(); }
};
using CellLayerPtr = std::shared_ptr<const CellLayer>;

class CellsCheckpoint;

/// Where a run begins, and where it is kept.
struct CellRunOptions {
  CellLayerPtr from =
      nullptr;  ///< Of an equal plan with as many steps or fewer: goes on from there.
  CellsCheckpoint* checkpoint = nullptr;
};

/// Makes the network and runs the plan's rules on it. Errors of the spacing are told where the text
/// gives it; Error(too_large) where `memory` bytes do not suffice. `object` of a cell is its
/// ground's number; there are no cells on meshes that are empty.
CellLayer make_cell_layer(const shot::CellsPlan& plan, const std::vector<CellSupport>& supports,
                          uint64_t memory, Progress& progress, const CellRunOptions& how = {});

/// Error(too_large) at the spacing where cells on so many square metres need more than `memory`
/// bytes.
void require_cell_memory(const shot::CellsPlan& plan, double area, uint64_t memory);

}  // namespace vug::building
