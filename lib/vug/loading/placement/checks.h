// SPDX-License-Identifier: Apache-2.0
// Inside placement/ only: the single checks.
#pragma once

#include <vug/loading/placement/check.h>
#include <vug/loading/placement/set.h>

namespace vug::loading {

void check_cameras(const Loaded& scene, const Set& set, const PlacementOptions& options,
                   Diagnostics& diagnostics);
void check_lights(const Set& set, Accuracy accuracy, Diagnostics& diagnostics);
void check_props(const Set& set, Accuracy accuracy, Diagnostics& diagnostics);
void check_voids(const Loaded& scene, const shot::Shot& part, Accuracy accuracy,
                 Diagnostics& diagnostics);

void check_ground(const Loaded& scene, const shot::Shot& part, Diagnostics& diagnostics);

/// "(0, 1.5, -2)", rounded to centimetres.
std::string position_text(const Vec3d& p);

}  // namespace vug::loading
