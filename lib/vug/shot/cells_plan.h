// SPDX-License-Identifier: Apache-2.0
// The plan of a `cells NAME on MESH { ... }` declaration.
#pragma once

#include <vug/base/hash.h>
#include <vug/base/rng.h>
#include <vug/cells/kind.h>
#include <vug/cells/relax.h>
#include <vug/cells/rule.h>
#include <vug/shot/shot.h>

#include <optional>
#include <string>
#include <vector>

namespace vug::shot {

/// A rule of `run` with its steps and its mask.
struct CellStage {
  cells::RulePtr rule;
  std::string name;
  int begin = 0;  ///< First step, counted from 0.
  std::optional<int>
      steps;          ///< Number of steps; default: to the end, or one for rules that act once.
  paint::Mask where;  ///< Probability of rewriting a cell; null: 1.
  mutable SourceLocation location{};  ///< Location of the rule in the text; see move_lines.

  /// Number of steps that the rule acts for; negative: to the end.
  int span() const { return steps.value_or(rule->is_single_step() ? 1 : -1); }
};
using CellStagePtr = std::shared_ptr<const CellStage>;

/// The outputs of cells that `vug build` can write: "points", "grids" next to the level set, and
/// the table "csv".
const std::vector<std::string>& cell_files();

struct CellsPlan {
  std::string name;
  std::vector<MeshPtr> on;          ///< The meshes that carry the cells.
  std::optional<cells::Grid> grid;  ///< Default: random.
  double spacing = 0.02;            ///< Distance of neighbouring cells in metres.
  std::optional<int> relax;         ///< Relaxation steps; default: those of the grid.
  cells::Force harmonise = cells::Force::squared;
  std::vector<CellStagePtr> run;  ///< In their order within a step.
  bool move = true;               ///< The mesh follows the displacement of cells.
  bool holes = false;             ///< Cut the mesh away where cells have been removed.
  std::optional<bool>
      refine;  ///< Subdivide triangles larger than cells; default: for meshes from files.
  std::optional<int> steps;                              ///< Steps of the whole run; see length.
  std::filesystem::path from;                            ///< Points to continue from; empty: none.
  std::vector<std::string> files = {"points", "grids"};  ///< Outputs, from cell_files().
  bool half = false;                                     ///< Store numbers with 16 bits.
  std::vector<std::string> attribute_names;              ///< Attributes that the cells will carry.
  RandomKey key{0};
  /// Only `steps` depends on the frame, so that the run of another frame can be continued.
  bool resumable = false;
  std::vector<std::string> context_attributes;  ///< Used names of context_attribute_names().
  mutable SourceLocation where;                 ///< Location of the name; see move_lines.
  mutable SourceLocation spacing_where;         ///< Location of `spacing`; see move_lines.
  int rescatter = 0;   ///< Times that the surface gets new cells during the run; see rescatter.h.
  CellsPtr before;     ///< The part of the run before this one; null: this is the first.
  int first_step = 0;  ///< The steps of the parts before.
  /// Identifies all that determines the run and its use, apart from the meshes that carry the
  /// cells; nothing: unknown.
  std::optional<Digest> inputs;

  /// Steps of the whole run: `steps`, else the end of the last stage, with 100 steps for open-ended
  /// stages.
  int length() const;
  /// Whether the output, one of cell_files(), is requested.
  bool writes(const std::string& what) const;
  std::string fault() const;  ///< Describes an unknown name in `files`; else empty.
};

/// The mesh below the topmost cell layer; null for a mesh without cells.
MeshPtr mesh_without_cells(const MeshPlan& mesh);

/// The parts of a combined mesh; else the mesh itself.
std::vector<MeshPtr> parts_of(const MeshPtr& mesh);

/// The part that becomes `support` when its cell layers are removed; null if there is none.
MeshPtr part_with_support(const MeshPtr& mesh, const MeshPtr& support);

}  // namespace vug::shot
