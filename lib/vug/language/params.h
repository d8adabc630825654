// SPDX-License-Identifier: Apache-2.0
// The parameters of a text with their ranges, for sliders that write values back into it.
#pragma once

#include <vug/language/workspace.h>

#include <string>
#include <vector>

namespace vug::language {

/// The steps of a slider, for which slider_text writes enough digits.
constexpr int kSliderSteps = 200;

struct ParamSetting {
  std::string name;
  std::string doc;
  std::string text;      ///< Its value as written: "30cm", "2 * EDGE".
  SourceLocation where;  ///< The name in the text.
  Value value;           ///< Empty after an error.
  Value low, high;       ///< Empty without a range.
  std::string range;     ///< As written: "10cm..90cm"; empty without a range.
  bool whole = false;    ///< Value and range are whole numbers without a unit.

  /// Whether a slider can show it: a number between two different limits.
  bool has_slider() const;
  /// Its position in the range, 0..1. Only with a slider.
  double fraction() const;
};

/// The params of the text itself, without those of the files that it includes, in its order.
std::vector<ParamSetting> params_of(const Analysis& analysis);

/// The text of the value at a position of the range, 0..1, in the unit in which the param is
/// written now, with the digits that kSliderSteps steps need.
std::string slider_text(const ParamSetting& param, double fraction);

}  // namespace vug::language
