// SPDX-License-Identifier: Apache-2.0
// Passage sizes of four surveyed regions: the cross-sections of their .3d files, left and right
// summed to widths, up and down to heights; docs/explanation/karst.md describes the measurement.
#include <vug/network/section_statistics.h>

namespace vug::network {
namespace {

SectionModel model(double width, double width_spread, double height, double height_spread,
                   double correlation) {
  SectionModel model;
  model.width_median = width;
  model.width_spread = width_spread;
  model.height_median = height;
  model.height_spread = height_spread;
  model.correlation = correlation;
  return model;
}

}  // namespace

const std::vector<NamedSectionModel>& section_models() {
  static const std::vector<NamedSectionModel> models{
      {"giants", model(1.25, 0.67, 1.68, 1.09, 0.35)},  // Giants Hole and Oxlow Caverns, n = 758.
      {"peak", model(1.32, 0.83, 1.70, 1.04, 0.39)},    // Peak Cavern system, n = 4443.
      {"dales", model(1.20, 0.82, 2.00, 1.02, 0.07)},   // 90 km of the Yorkshire Dales, n = 6770.
      {"mulu", model(7.00, 1.03, 5.43, 0.96, 0.60)}};   // Clearwater and Api, Mulu, n = 10297.
  return models;
}

}  // namespace vug::network
