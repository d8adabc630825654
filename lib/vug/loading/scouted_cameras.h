// SPDX-License-Identifier: Apache-2.0
// Cameras that are shots of `vug scout`: camera NAME { scout N }.
#pragma once

#include <vug/scene/document.h>

#include <filesystem>
#include <string>
#include <vector>

namespace vug {
class Diagnostics;
}

namespace vug::loading {

/// The folder of the shots of a scene: "caves/my_cave_shots" for "caves/my_cave.vug".
std::filesystem::path shots_folder(const std::filesystem::path& scene);

/// The file of shot `number` in that folder, counted from 1: "shot3.vug".
std::string shot_file(size_t number);

/// The statements by which the shots of a document's scouted cameras become part of it, one for
/// each camera: include "my_cave_shots/shot3.vug" as main_shot. Reports entries that are not a
/// number, other entries of such a camera, and shots whose files do not exist.
std::vector<std::string> scouted_includes(const scene::Document& document,
                                          const std::filesystem::path& scene,
                                          Diagnostics& diagnostics);

/// Replaces each scouted camera by that of the included shot, as if the text were
/// camera main = main_shot.shot3.
void use_scouted_cameras(scene::Document& document);

/// Makes scouted cameras default cameras, for the search of new shots.
void forget_scouted_cameras(scene::Document& document);

}  // namespace vug::loading
