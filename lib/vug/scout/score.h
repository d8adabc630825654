// SPDX-License-Identifier: Apache-2.0
// The composition of a view as numbers. Each term is 0 to 1; l is the logarithm of the distance.
#pragma once

#include <vug/scout/view.h>

#include <array>
#include <map>

namespace vug::scout {

/// Values of the objects of a scene for a picture, by their index; others are the surroundings.
struct Landmarks {
  std::map<uint32_t, double> weights;   ///< 0 to 1: how much a picture gains by the object.
  std::map<uint32_t, bool> known_size;  ///< Objects whose size everybody knows, such as a figure.
};

/// The terms of the score.
struct ScoreTerms {
  double depth = 0;         ///< ln(P90/P10) / ln 8 of the distances.
  double layers = 0;        ///< Entropy of three classes of l (Otsu) times their separation.
  double lead = 0;          ///< The deepest part is near a point of thirds, or the centre.
  double clear = 0;         ///< Few edges: 1 up to a quarter of the pixels, 0 from one half.
  double size_known = 0.5;  ///< 1 if something of known size is in the picture, 0.1 if the edge of
                            ///< the picture cuts a large one, else 0.5.
  double lines = 0;         ///< Edges of floor and walls run towards the deepest part.
  double frame = 0;         ///< Near surfaces at the border rather than in the middle.
  double landmarks = 0;     ///< Weights of the visible landmarks, relative to 3.
  double sizes = 0;         ///< Different sizes of the parts.
  double directions = 0;    ///< Entropy of the normals, best at three quarters.
  double balance = 0;       ///< The edges have their centre in the middle of the picture.

  /// (depth layers lead)^(1/3) clear size_known (0.25 lines + 0.2 frame + 0.2 landmarks + 0.15
  /// sizes
  /// + 0.1 directions + 0.1 balance): the factors are all necessary, the summands replace each
  /// other.
  double total() const;
};

ScoreTerms score(const View& view, const Landmarks& landmarks = {});

/// Where the deepest twentieth of the pixels has its centre, from (0, 0) at the top left to (1, 1).
Vec2d deepest_part(const View& view);

/// The thresholds that divide values into three classes with the largest variance between them
/// (Otsu 1979, cite otsu1979), found on a histogram of 64 bins, with the shares of the classes.
struct OtsuClasses {
  double low = 0, high = 0;  ///< Class 0 is below `low`, class 2 from `high`.
  std::array<double, 3> shares{};
  double separation = 0;  ///< Variance between the classes relative to the total variance.
};
OtsuClasses otsu_classes(const std::vector<double>& values);

}  // namespace vug::scout
