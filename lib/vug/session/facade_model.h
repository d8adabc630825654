// SPDX-License-Identifier: Apache-2.0
// Finds the grammars of modelling sessions, and writes scenes of carved walls, with the voxels of
// wall and glass.
#pragma once

#include <vug/modeller/session.h>

#include <filesystem>

namespace vug::session {

/// A loader of session grammars. Relative names are searched in the session's folder, then in the
/// installed data and its facades/ folder. The `let`s of the grammar may use all kinds of scenes.
modeller::StyleLoader facade_style_loader(const std::filesystem::path& folder);

/// The file that facade_style_loader finds; with an empty folder, only in the installed data.
/// Error(bad_input) if there is none.
std::filesystem::path find_grammar_file(const std::filesystem::path& folder,
                                        const std::string& file);

/// Path of a file relative to a folder, e.g. of the photo of a session.
std::string relative_path_from(const std::filesystem::path& folder,
                               const std::filesystem::path& file);

/// The header for a session that moves to another folder: paths of the grammar, if it is a file of
/// the old folder, and of the photo are relative to the new folder.
modeller::SessionHeader moved_header(modeller::SessionHeader header,
                                     const std::filesystem::path& from,
                                     const std::filesystem::path& to);

/// Turns a file name into a valid name for a grammar in a scene text.
std::string valid_grammar_name(const std::string& text);

struct CarvingOptions {
  double voxel = 0.04;     ///< Voxel edge in metres.
  double thickness = 0.6;  ///< Thickness of the wall in metres.
  std::string name = {};   ///< Name of the grammar; empty: the tree's.
};

/// A scene with the volumes `stone`, a wall with the facade carved into it, and `panes`, the infill
/// of its openings (only if the voxels of the wall are fine enough for frames). The carving is
/// built from this text, so its recipe contains the exact sizes. Open nodes become plain wall.
std::string carving_scene(const facade::Tree& tree, const CarvingOptions& options);

/// The voxel size of the infill as an expression of the wall's voxel size: finer, since panes are
/// sheets of 6 cm, but not so fine that they take longer than the wall.
std::string pane_voxel(const std::string& voxel);

}  // namespace vug::session
