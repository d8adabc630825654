// SPDX-License-Identifier: Apache-2.0
// The coefficients of the International Geomagnetic Reference Field, 14th generation [@igrf14].
#pragma once

#include <array>
#include <cstddef>

namespace vug::survey {

inline constexpr int kIgrfDegree = 13;
inline constexpr int kIgrfFirstYear = 1900;
inline constexpr int kIgrfYears = 5;       ///< Between epochs.
inline constexpr size_t kIgrfEpochs = 27;  ///< 1900 to 2030.
inline constexpr size_t kIgrfCoefficients = 195;

/// Gauss coefficients in nT, Schmidt semi-normalised, in the order g(1,0), g(1,1), h(1,1), g(2,0),
/// ... The values of 2030 are those of 2025 with the predicted change of five years.
extern const std::array<std::array<double, kIgrfEpochs>, kIgrfCoefficients> kIgrf;

}  // namespace vug::survey
