// SPDX-License-Identifier: Apache-2.0
// Cell layers: a network of cells on meshes with the state after its rules have run.
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

/// A mesh that carries cells.
struct CellSupport {
  mesh::MeshPtr mesh;
  std::shared_ptr<const field::SampledGrid> solid;  ///< Level set of which it is the surface,
                                                    ///< for masks; null if there is none.
};

/// The cells of one plan after their run.
struct CellLayer {
  cells::Simulation simulation;              ///< State after the run; contains the network.
  std::vector<cells::RelaxStep> relaxation;  ///< Statistics of the relaxation steps.

  const cells::Network& network() const { return simulation.network(); }
};
using CellLayerPtr = std::shared_ptr<const CellLayer>;

class CellsCheckpoint;

/// Start and checkpoint of a run.
struct CellRunOptions {
  CellLayerPtr from = nullptr;  ///< Run of an equal plan with at most as many steps, to continue.
  CellsCheckpoint* checkpoint = nullptr;
  CellLayerPtr before = nullptr;  ///< The layer of plan.before.
};

/// Builds the network and runs the plan's rules on it. `object` of a cell is the index of its
/// support; empty meshes get no cells. Errors about the spacing have its location in the text;
/// Error(too_large) if `memory` bytes do not suffice.
CellLayer make_cell_layer(const shot::CellsPlan& plan, const std::vector<CellSupport>& supports,
                          uint64_t memory, Progress& progress, const CellRunOptions& how = {});

/// Error(too_large), located at the spacing, if cells on `area` square metres need more than
/// `memory` bytes.
void require_cell_memory(const shot::CellsPlan& plan, double area, uint64_t memory);
/// Whether it would not throw.
bool cells_fit(const shot::CellsPlan& plan, double area, uint64_t memory);

}  // namespace vug::building
