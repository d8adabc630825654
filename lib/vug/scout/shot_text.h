// SPDX-License-Identifier: Apache-2.0
// Shots as scene text.
#pragma once

#include <vug/scout/scout.h>

#include <string>

namespace vug::scout {

/// The names of lamps: their roles, from the second of a role on with a number: "key", "glow",
/// "glow2".
std::vector<std::string> lamp_names(const std::vector<Lamp>& lamps);

/// The declarations of lamps, whose names begin with `prefix`, after the include of
/// kit/lamps.vug under the name `module`.
std::string lamps_text(const std::vector<Lamp>& lamps, const std::string& prefix,
                       const std::string& module);

/// The text of a shot: `camera shotN` and its lamps, with a comment that says how it was judged.
/// `scene`: the name of the scene in the comment.
std::string shot_text(const ScoutedShot& shot, size_t number, const std::string& scene);

}  // namespace vug::scout
