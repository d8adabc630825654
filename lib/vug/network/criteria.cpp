// SPDX-License-Identifier: Apache-2.0
// The distributions of the measures among 31 surveyed three-dimensional networks: quantiles of the
// statistics that the karstnet project publishes with collon2017karst (update of 2021). The
// extremes of the normalised path length are two standard deviations (0.34 of its logarithm) from
// the median.
#include <vug/network/score.h>

#include <cmath>

namespace vug::network {

const std::vector<Criterion>& criteria() {
  static const std::vector<Criterion> list{
      {"orientation entropy",
       {0.746, 0.907, 0.948, 0.981, 0.988, 0.996, 0.997},
       "the passages have too few directions",
       "the directions of the passages are too uniform",
       [](const Metrics& m) { return m.orientation_entropy; }},
      {"branch length",
       {8.5, 20.7, 33.2, 55.6, 69.7, 171, 332},
       "the branches are too short",
       "the branches are too long",
       [](const Metrics& m) { return m.branch_length; }},
      {"length entropy",
       {0.07, 0.205, 0.324, 0.415, 0.543, 0.598, 0.667},
       "a few branches are much longer than all others",
       "the lengths of branches are too evenly distributed",
       [](const Metrics& m) { return m.length_entropy; }},
      {"length variation",
       {0.90, 0.94, 1.14, 1.32, 1.57, 1.85, 2.56},
       "the branches are too similar in length",
       "the lengths of branches differ too much",
       [](const Metrics& m) { return m.length_variation; }},
      {"tortuosity",
       {1.121, 1.183, 1.212, 1.268, 1.361, 1.415, 1.535},
       "the legs are too straight",
       "the legs wind too much",
       [](const Metrics& m) { return m.tortuosity; }},
      {"mean degree",
       {1.75, 2.00, 2.03, 2.125, 2.26, 2.34, 2.57},
       "the network has too few loops",
       "the network has too many loops",
       [](const Metrics& m) { return m.degree; }},
      {"degree variation",
       {0.353, 0.460, 0.471, 0.500, 0.536, 0.592, 0.603},
       "the network has too few dead ends and junctions of many branches",
       "the network has too many junctions of many branches",
       [](const Metrics& m) { return m.degree_variation; }},
      {"degree correlation",
       {-0.556, -0.455, -0.369, -0.286, -0.236, -0.168, -0.150},
       "dead ends start at junctions of many branches too often",
       "dead ends start at large junctions too rarely",
       [](const Metrics& m) { return m.degree_correlation; }},
      {"path length by the root of nodes",
       {0.47, 0.63, 0.81, 0.93, 1.08, 1.24, 1.84},
       "the ways between junctions are too short",
       "the ways between junctions are too long",
       [](const Metrics& m) { return m.path_length / std::sqrt(static_cast<double>(m.nodes)); }},
      {"central point dominance",
       {0.022, 0.196, 0.315, 0.436, 0.493, 0.544, 0.572},
       "the network has no main passage",
       "too many ways lead through one junction",
       [](const Metrics& m) { return m.dominance; }}};
  return list;
}

const std::vector<SectionCriterion>& section_criteria() {
  using Summary = SectionSummary;
  static const std::vector<SectionCriterion> list{
      {"median width", 0.3, 1.20, 7.00, 15, "the passages are too narrow",
       "the passages are too wide", [](const Summary& s) { return s.width_median; }},
      {"spread of widths", 0.3, 0.67, 1.03, 1.6, "the widths are too uniform",
       "the widths differ too much", [](const Summary& s) { return s.width_spread; }},
      {"median height", 0.4, 1.68, 5.43, 14, "the passages are too low",
       "the passages are too high", [](const Summary& s) { return s.height_median; }},
      {"spread of heights", 0.4, 0.96, 1.09, 1.6, "the heights are too uniform",
       "the heights differ too much", [](const Summary& s) { return s.height_spread; }},
      {"median of width by height", 0.2, 0.67, 1.31, 4, "the passages are too tall for their width",
       "the passages are too flat for their width",
       [](const Summary& s) { return s.ratio_median; }},
      {"correlation of width and height", -0.4, 0.07, 0.60, 1, "wide passages are too rarely high",
       "the passages are all of one shape", [](const Summary& s) { return s.correlation; }},
      {"correlation of widths along a leg", 0, 0.40, 0.71, 1, "the width changes too abruptly",
       "the width changes too slowly", [](const Summary& s) { return s.width_lag; }},
      {"correlation of heights along a leg", 0, 0.40, 0.71, 1, "the height changes too abruptly",
       "the height changes too slowly", [](const Summary& s) { return s.height_lag; }},
      {"horizontal offset of the line", 0, 0.39, 0.59, 1,
       "the survey line follows the middle of the passages too closely",
       "the survey line follows the side walls too closely",
       [](const Summary& s) { return s.off_centre_width; }},
      {"vertical offset of the line", 0, 0.25, 0.45, 1,
       "the survey line follows half the height of the passages too closely",
       "the survey line follows floors and roofs too closely",
       [](const Summary& s) { return s.off_centre_height; }}};
  return list;
}

}  // namespace vug::network
