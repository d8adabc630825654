// SPDX-License-Identifier: Apache-2.0
// Drawings of a survey as SVG, at a scale of one user unit to a metre.
#pragma once

#include <vug/survey/survey.h>

#include <string>

namespace vug::survey {

/// The legs seen from above, north at the top, with the widths of cross-sections. An arrow
/// points to the north. Entrances have labels; other stations show their names under the mouse
/// pointer.
std::string plan_svg(const Survey& survey);

/// The extended elevation: each leg continues to the right by its horizontal length, at its true
/// altitude, starting at the entrances. Loops are cut where two ways around them meet;
/// a station there has a dot at both places.
std::string elevation_svg(const Survey& survey);

}  // namespace vug::survey
