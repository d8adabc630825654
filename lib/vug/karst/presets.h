// SPDX-License-Identifier: Apache-2.0
// Named geologies with options: patterns of caves, after the classes of palmer1991.
#pragma once

#include <vug/karst/geology.h>
#include <vug/karst/options.h>

#include <string_view>

namespace vug::karst {

struct Preset {
  const char* name;
  const char* doc;  ///< One line for people.
  Geology geology;
  KarstOptions options;
};

/// The presets branchwork, maze_rectilinear, maze_anastomotic, spongework, conduit, shafts and
/// tiers. They have random key points; change the seed for another cave.
const std::vector<Preset>& presets();

/// Throws Error(bad_input) with the known names for an unknown one.
const Preset& find_preset(std::string_view name);

}  // namespace vug::karst
