// SPDX-License-Identifier: Apache-2.0
// The attributes that the cells of a plan will have, determined before any work.
#pragma once

#include <vug/shot/cells_plan.h>

#include <string>
#include <vector>

namespace vug::shot {

inline constexpr const char* kExposure = "exposure";
inline constexpr const char* kOcclusion = "occlusion";
inline constexpr const char* kCurvature = "curvature";

/// The names of the attributes that describe the surroundings of cells; they are computed on
/// demand. exposure: irradiance under a uniform sky relative to unoccluded level ground. occlusion:
/// cosine-weighted fraction of the directions above a cell that hit rock within 50 cm. curvature:
/// mean curvature in 1/m from the change of normals between neighbouring cells: 1/r on a sphere,
/// negative in hollows. Unlike the masks cavity and edge it needs no level set.
const std::vector<std::string>& context_attribute_names();

/// Fills plan.attribute_names and plan.context_attributes. Reports attributes that rules or masks
/// of the plan name but nothing creates, at their location in the text, and rules that disagree
/// about the type of an attribute.
void resolve_attribute_names(CellsPlan& plan, Diagnostics& diagnostics);

}  // namespace vug::shot
