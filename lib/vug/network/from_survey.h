// SPDX-License-Identifier: Apache-2.0
// The conversion between surveys (survey space, z up) and networks (scene space, y up).
#pragma once

#include <vug/network/network.h>
#include <vug/network/scene_origin.h>
#include <vug/survey/survey.h>

namespace vug::network {

struct FromSurveyOptions {
  bool surface = false;    ///< Keeps legs over the surface.
  bool duplicates = true;  ///< Keeps legs that repeat a passage.
  OriginOptions place{};   ///< Network::origin states the result.
};

/// The network of a survey. A leg is a splay if it is flagged as one or leads to an anonymous
/// station; the station at its end becomes a point of Station::splays. Stations without legs remain
/// if they have a name. Equated stations become one, and a leg between them disappears. A station
/// in several tubes gets the cross-section with the most distances, the first of several. Throws
/// Error(bad_input) for indices of missing stations, for positions that are not finite, and like
/// scene_origin.
Network from_survey(const survey::Survey& survey, const FromSurveyOptions& options = {});

/// The survey of a network, at Network::origin. Splays become splay legs to anonymous stations on
/// the wall, and each branch with cross-sections becomes tubes. Stations without a name are
/// numbered, with names that no other station has; each name of Station::equated is a station that
/// is equated. Throws like require_valid.
survey::Survey to_survey(const Network& network);

}  // namespace vug::network
