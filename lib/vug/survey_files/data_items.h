// SPDX-License-Identifier: Apache-2.0
// The data styles and the readings of data lines that Survex and Therion share.
#pragma once

#include <vug/survey/survey.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace vug::survey {

enum class DataStyle { none, normal, diving, cartesian, cylpolar, nosurvey, passage, ignore };

/// The style of a leg from a line of this style; unknown if the lines are not legs.
Style leg_style(DataStyle style);

/// A column of data lines.
enum class Item : uint8_t {
  from,
  to,
  station,
  newline,
  direction,
  tape,
  back_tape,
  compass,
  back_compass,
  clino,
  back_clino,
  from_count,
  to_count,
  count,
  from_depth,
  to_depth,
  depth,
  depth_change,
  easting,
  northing,
  altitude,
  left,
  right,
  up,
  down,
  ignore,
  ignore_all,
};
inline constexpr size_t kItems = static_cast<size_t>(Item::ignore_all) + 1;

/// The names of the items in lower case, with their synonyms.
const std::map<std::string, Item>& item_names();

}  // namespace vug::survey
