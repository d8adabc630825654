// SPDX-License-Identifier: Apache-2.0
// The faults of a scene: of its text, and of the products that it asks for.
#pragma once

#include <vug/language/workspace.h>
#include <vug/loading/load.h>

namespace vug::language {

struct CheckOptions {
  /// Also run the checks that take seconds: the memory of level sets, the points of cells and the
  /// drawings of L-systems.
  bool thorough = false;
};

/// Adds the faults of a loaded scene without errors, as `vug render` with default options finds
/// them: cameras and lights in rock, settings of pictures, scenes without products.
void check_products(loading::Loaded& loaded, const std::string& file, const CheckOptions& options);

/// The faults of a text and of the open or saved texts that it includes, and the texts.
struct CheckResult {
  Diagnostics diagnostics;
  std::vector<std::shared_ptr<const scene::Source>> sources;
};

/// Loads and checks a scene of a workspace. Nothing is thrown for faults of the scene.
CheckResult check_scene(const Workspace& workspace, const std::filesystem::path& file,
                        const CheckOptions& options = {});

}  // namespace vug::language
