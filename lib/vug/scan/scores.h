// SPDX-License-Identifier: Apache-2.0
// Agreement of detected rectangles with the ground truth.
#pragma once

#include <vug/scan/mask.h>
#include <vug/scan/openings.h>

#include <optional>

namespace vug::scan {

/// Intersection over union; 0 for boxes without area.
double iou(const Box& a, const Box& b);

/// Area of the union of the boxes.
double union_area(const std::vector<Box>& boxes);

struct Match {
  double best = 0;                             ///< Largest IoU with any detection.
  std::optional<size_t> found = std::nullopt;  ///< The matched detection, if any.
};

struct Scores {
  std::vector<Match> truth;  ///< One per true object.
  size_t found = 0;
  size_t matched = 0;
  double precision = 0;  ///< Share of detections that are matched; 0 without detections.
  double recall = 0;     ///< Share of true objects that are matched; 0 without objects.
  double area_iou = 0;   ///< IoU of the union of all detections and the union of all true objects.
};

/// Matches pairs with an IoU above `min_iou`, best first, each object once [@everingham2010].
Scores score(const std::vector<Box>& found, const std::vector<Box>& truth, double min_iou = 0.5);

/// Ground truth as masks: pixels with `label` above 0 belong to object label - 1. Row 0 is the top
/// row and `pixel` metres high; the lower left corner is (0, 0). Error(bad_input) if the sizes do
/// not match.
struct ObjectMap {
  int width = 0, height = 0;
  double pixel = 0.01;
  std::vector<uint32_t> label;
};
Scores score(const std::vector<Box>& found, const ObjectMap& truth, double min_iou = 0.5);

}  // namespace vug::scan
