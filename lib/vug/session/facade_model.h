// Facades modelled by hand, where files come in: grammars that sessions name, and carved walls.
#pragma once

#include <vug/modeller/session.h>
#include <vug/session/load.h>

#include <filesystem>

namespace vug::session {

/// Finds a session's grammar: a relative name in the session's folder, else among the data that
/// comes with us, in facades/ too. Lets of the grammar's text may hold whatever scenes know.
modeller::StyleLoader facade_styles(const std::filesystem::path& folder);

/// As facade_styles finds it; without a folder only among the data. Error(bad_input) where there is
/// none.
std::filesystem::path find_grammar(const std::filesystem::path& folder, const std::string& file);

struct FacadeCarving {
  double voxel = 0.04;      ///< Metres.
  double thickness = 0.6;   ///< Of the wall, metres.
  std::string prefix = {};  ///< Of the volumes' names.
};

/// The volumes `stone`, a wall with the facade carved into it, and `panes`, what fills its openings
/// (with voxels of a centimetre at most; only where the wall's are fine enough for their frames).
/// Nodes that are open are plain wall.
Shot facade_shot(const facade::Tree& tree, const FacadeCarving& options);

/// The same with the recipe of a scene that carves it, and what was said of that scene. `scene` is
/// its text, empty for one of the tree alone; `file` names it.
Loaded load_carving(const facade::Tree& tree, const FacadeCarving& options, std::string scene,
                    const std::string& file);

}  // namespace vug::session
