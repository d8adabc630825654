// SPDX-License-Identifier: Apache-2.0
// The part of a shot that a picture shows: the lights, objects and medium that its render block
// selects.
#pragma once

#include <vug/shot/shot.h>

#include <memory>
#include <string>
#include <vector>

namespace vug::shot {

/// The value of `air` for a picture without a medium.
inline constexpr const char* kNoAir = "none";

/// A name of the settings that the shot does not have, or a medium that they must choose.
struct SelectionFault {
  std::string setting;  ///< "lights", "objects" or "air".
  std::string name;     ///< The unknown name; empty if a name is missing.
  std::string message, hint;
};
std::vector<SelectionFault> find_selection_faults(const Shot& shot, const RenderSettings& settings);

/// The names that `objects` may select: shown objects and places, in the order of the text.
std::vector<std::string> selectable_objects(const Shot& shot);

/// The medium that fills the scene; null: none. With several media, the settings choose one.
const MediumPlan* find_air(const Shot& shot, const RenderSettings& settings);

/// The shot without the lights, objects, places and media that the settings do not select, nor the
/// meshes and volumes that only these need. The shot itself if they select everything; it must
/// outlive the result.
std::shared_ptr<const Shot> selected_part(const Shot& shot, const RenderSettings& settings);

/// The names of the objects and places of the shot that its part lacks.
std::vector<std::string> omitted_objects(const Shot& shot, const Shot& part);

}  // namespace vug::shot
