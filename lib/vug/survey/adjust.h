// SPDX-License-Identifier: Apache-2.0
// The closure of loops: coordinates of all stations from measured legs, by least squares.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/survey/observations.h>

namespace vug::survey {

/// The coordinates that minimise the sum of squared residuals, each weighted by the inverse of its
/// leg's covariance. Fixes without a covariance are met exactly. Legs of the style nosurvey have no
/// effect. Reports a misclosure for every traverse that is part of a loop or lies between fixed
/// stations, and likely blunders [@baarda1968].
/// If nothing is fixed, the first station of the first leg is at the origin. Other
/// components without a fix get a warning and are placed in a row east of the rest, 10 m apart, so
/// that their stations do not share places. Throws Error(bad_input) for a station that is fixed at
/// two places.
Survey adjust(Observations observations, Diagnostics& warnings);

}  // namespace vug::survey
