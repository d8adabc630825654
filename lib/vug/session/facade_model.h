// Facades modelled by hand, where files come in: grammars that sessions name, and carved walls.
#pragma once

#include <vug/modeller/session.h>

#include <filesystem>

namespace vug::session {

/// Finds a session's grammar: a relative name in the session's folder, else among the data that
/// comes with us, in facades/ too. Lets of the grammar's text may hold whatever scenes know.
modeller::StyleLoader facade_style_loader(const std::filesystem::path& folder);

/// As facade_style_loader finds it; without a folder only among the data. Error(bad_input) where
/// there is none.
std::filesystem::path find_grammar_file(const std::filesystem::path& folder,
                                        const std::string& file);

struct CarvingOptions {
  double voxel = 0.04;     ///< Metres.
  double thickness = 0.6;  ///< Of the wall, metres.
  std::string name = {};   ///< Of the grammar; empty: the tree's.
};

/// A scene of the volumes `stone`, a wall with the facade carved into it, and `panes`, what fills
/// its openings (only where the wall's voxels are fine enough for their frames). What is carved is
/// built from this text, so that its recipe tells the very sizes. Nodes that are open are plain
/// wall.
std::string carving_scene(const facade::Tree& tree, const CarvingOptions& options);

/// The voxels of what fills openings, as an expression of the wall's: finer, as panes are sheets of
/// 6 cm, but not so fine that they take longer than the wall.
std::string pane_voxel(const std::string& voxel);

}  // namespace vug::session
