// Measured light distributions: files of the form ANSI/IES LM-63 (cite ies2002lm63).
#pragma once

#include <vug/render/vectors.h>

#include <filesystem>
#include <string_view>
#include <vector>

namespace vug::render {

/// Intensities in candela over vertical angles (0: straight down) and horizontal ones, spread to
/// the whole sphere as the file's symmetry tells; 0 beyond the vertical angles that were measured.
class IesProfile {
 public:
  /// Type C photometry of LM-63-1986 to 2002. Error(bad_input) with the name and the line for a
  /// text that is no such file.
  IesProfile(std::string_view text, const std::string& name);

  /// `down` is the cosine of the vertical angle; `turn` the horizontal angle in turns. Linear
  /// between the angles of the file.
  float candela(float down, float turn) const;
  /// The largest of the file.
  float peak() const { return peak_; }
  /// Of all light, by integrating the interpolated intensities.
  double lumen() const { return lumen_; }
  /// What the file says of its lamps: their number times the lumen of each; negative when it gives
  /// none (absolute photometry).
  double rated_lumen() const { return rated_; }
  /// Cosine of the largest vertical angle with light in any direction.
  float lowest_cosine() const { return lowest_cosine_; }

 private:
  double at(double vertical, double horizontal) const;

  std::vector<double> vertical_, horizontal_;  ///< Degrees, rising.
  std::vector<double> candela_;                ///< Vertical angles of the first horizontal one, ...
  float peak_ = 0, lowest_cosine_ = -1;
  double lumen_ = 0, rated_ = -1;
};

IesProfile read_ies(const std::filesystem::path& file);

}  // namespace vug::render
