// SPDX-License-Identifier: Apache-2.0
// Measured light distributions from ANSI/IES LM-63 files (cite ies2002lm63).
#pragma once

#include <vug/render/vectors.h>

#include <filesystem>
#include <string_view>
#include <vector>

namespace vug::render {

/// Intensities in candela over vertical angles (0: straight down) and horizontal angles, extended
/// to the whole sphere by the file's symmetry. Outside the measured vertical angles the intensity
/// is 0.
class IesProfile {
 public:
  /// Type C photometry of LM-63-1986 to 2002. Error(bad_input) with `name` and the line number if
  /// the text is not a valid file.
  IesProfile(std::string_view text, const std::string& name);

  /// `down` is the cosine of the vertical angle, `turn` the horizontal angle in turns. Interpolates
  /// linearly between the angles of the file.
  float candela(float down, float turn) const;
  /// Largest intensity in the file, in candela.
  float peak() const { return peak_; }
  /// Total luminous flux, by integration of the interpolated intensities.
  double lumen() const { return lumen_; }
  /// Rated flux of the file's lamps: their number times the lumen of each; negative if the file
  /// gives none (absolute photometry).
  double rated_lumen() const { return rated_; }
  /// Cosine of the largest vertical angle at which any direction has light.
  float lowest_cosine() const { return lowest_cosine_; }

 private:
  double at(double vertical, double horizontal) const;

  std::vector<double> vertical_, horizontal_;  ///< Degrees, ascending.
  std::vector<double> candela_;  ///< Row by row: all vertical angles of the first horizontal angle,
                                 ///< then of the next.
  float peak_ = 0, lowest_cosine_ = -1;
  double lumen_ = 0, rated_ = -1;
};

IesProfile read_ies(const std::filesystem::path& file);

}  // namespace vug::render
