// Which attributes the cells of a plan have, told before any work.
#pragma once

#include <vug/shot/cells_plan.h>

#include <string>
#include <vector>

namespace vug::shot {

inline constexpr const char* kExposure = "exposure";
inline constexpr const char* kOcclusion = "occlusion";
inline constexpr const char* kCurvature = "curvature";

/// exposure: the light of an even sky as a share of what falls on open level ground; occlusion: the
/// share of the directions above a cell in which rock stands within 50 cm, weighted by cosines;
/// curvature: the mean of the surface's, by how normals turn from a cell to its neighbours, in 1/m:
/// 1/r on a ball, below 0 in hollows. It needs no level set, as the masks cavity and edge do.
const std::vector<std::string>& context_attribute_names();

/// Fills plan.surroundings, and tells of attributes that rules or masks of the plan name and nobody
/// brings, where the text does so, and of rules that disagree about the type of one.
void resolve_attribute_names(CellsPlan& plan, Diagnostics& diagnostics);

}  // namespace vug::shot
