// What `cells NAME on MESH { ... }` asks for.
#pragma once

#include <vug/base/rng.h>
#include <vug/cells/kind.h>
#include <vug/cells/relax.h>
#include <vug/cells/rule.h>
#include <vug/shot/shot.h>

#include <optional>
#include <string>
#include <vector>

namespace vug::shot {

/// A rule of `run` with when and where it works.
struct CellStage {
  cells::RulePtr rule;
  std::string name;
  int begin = 0;              ///< Its first step, from 0.
  std::optional<int> steps;   ///< How many; not given: to the end, or one for rules that say so.
  paint::Mask where;          ///< The chance of a cell to be rewritten by it; null: all are.
  SourceLocation location{};  ///< Its place in the text.

  /// How many steps it works for; below 0: to the end.
  int span() const { return steps.value_or(rule->is_single_step() ? 1 : -1); }
};
using CellStagePtr = std::shared_ptr<const CellStage>;

/// What `vug build` can write of cells: "points", "grids" beside the level set, a table, "csv".
const std::vector<std::string>& cell_files();

struct CellsPlan {
  std::string name;
  std::vector<MeshPtr> on;          ///< What they stand on.
  std::optional<cells::Grid> grid;  ///< Not given: random.
  double spacing = 0.02;            ///< Metres.
  std::optional<int> relax;         ///< Steps of harmonising; not given: the grid's own.
  cells::Force harmonise = cells::Force::squared;
  std::vector<CellStagePtr> run;  ///< In the order in which they work within a step.
  bool move = true;               ///< The mesh goes where cells go.
  bool holes = false;             ///< The mesh is cut away where cells are gone.
  std::optional<bool> refine;  ///< Cut triangles that are larger than cells; not given: of files.
  std::optional<int> steps;    ///< Of the whole run; see length.
  std::filesystem::path from;  ///< Points that they go on from; empty: none.
  std::vector<std::string> files = {"points", "grids"};  ///< See `writes`.
  bool half = false;                                     ///< Numbers in files have 16 bits.
  std::vector<std::string> attribute_names;  ///< Names of attributes that it will carry.
  RandomKey key{0};
  /// Nothing of it but `steps` depends on the frame: another frame's run can go on to this one's.
  bool resumable = false;
  std::vector<std::string> context_attributes;  ///< Those of building/cell_context.h that it names.
  SourceLocation where;                         ///< Its name in the text.
  SourceLocation spacing_where;                 ///< What `spacing` says there.

  /// Steps of the whole run: `steps`, else what the last stage needs: 100 if it says nothing.
  int length() const;
  /// One of cell_files().
  bool writes(const std::string& what) const;
  std::string fault() const;  ///< A sentence on `files` that are none; else empty.
};

/// The mesh without the last cells that it wears; null where it wears none.
MeshPtr mesh_without_cells(const MeshPlan& mesh);

/// What the mesh is made of: its parts, or itself.
std::vector<MeshPtr> parts_of(const MeshPtr& mesh);

/// Of its parts the one that is `ground` under what it wears; null where there is none.
MeshPtr part_with_support(const MeshPtr& mesh, const MeshPtr& support);

}  // namespace vug::shot
