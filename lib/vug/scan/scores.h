// How well found rectangles agree with the true ones.
#pragma once

#include <vug/scan/mask.h>
#include <vug/scan/openings.h>

#include <optional>

namespace vug::scan {

/// Area of the common part by that of both together; 0 for boxes without area.
double iou(const Box& a, const Box& b);

/// Area that boxes cover together.
double union_area(const std::vector<Box>& boxes);

struct Match {
  double best = 0;                             ///< IoU with the found object that fits best.
  std::optional<size_t> found = std::nullopt;  ///< Which counts for this one, if any does.
};

struct Scores {
  std::vector<Match> truth;  ///< One for each true object.
  size_t found = 0;
  size_t matched = 0;
  double precision = 0;  ///< Of what was found the matched part; 0 when nothing was.
  double recall = 0;     ///< Of the true objects the matched part; 0 when there are none.
  double area_iou = 0;   ///< Of all found together with all true ones together.
};

/// Pairs count from an IoU above `least`, best first, each object once [@everingham2010].
Scores score(const std::vector<Box>& found, const std::vector<Box>& truth, double least = 0.5);

/// The same with the true objects as masks: pixels of `label` above 0 are those of object
/// label - 1; row 0 is the top row and `pixel` metres high, the lower left corner is (0, 0).
/// Error(bad_input) where sizes do not fit.
struct ObjectMap {
  int width = 0, height = 0;
  double pixel = 0.01;
  std::vector<uint32_t> label;
};
Scores score(const std::vector<Box>& found, const ObjectMap& truth, double least = 0.5);

}  // namespace vug::scan
