// SPDX-License-Identifier: Apache-2.0
// Writer of Survex's .svx files.
#pragma once

#include <vug/survey/survey.h>

#include <string>

namespace vug::survey::svx {

/// A text from which cavern and the reader compute the coordinates of the survey again. Legs are
/// written as tape, compass and clino between the coordinates, in nested surveys. Each component
/// has at least one fixed station. Throws Error(bad_input) for coordinates and distances that are
/// not finite or beyond 1e9 metres, and for legs longer than 10000 km.
std::string write(const Survey& survey);

}  // namespace vug::survey::svx
