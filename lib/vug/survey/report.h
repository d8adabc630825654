// SPDX-License-Identifier: Apache-2.0
// The description of a survey for people and programs.
#pragma once

#include <vug/survey/survey.h>

#include <nlohmann/json_fwd.hpp>

namespace vug::survey {

/// Counts, lengths and ranges in metres, misclosures (the largest first), and likely blunders with
/// their errors in metres or degrees.
nlohmann::ordered_json report(const Survey& survey);

/// The named stations in the order of the survey: name, east, north and up in metres, and flags.
nlohmann::ordered_json station_list(const Survey& survey);

}  // namespace vug::survey
