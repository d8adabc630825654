// SPDX-License-Identifier: Apache-2.0
// Surveys from .svx texts, for tests.
#pragma once

#include <vug/survey/adjust.h>
#include <vug/survey_files/format.h>

#include <gtest/gtest.h>

#include <string>

namespace vug::survey {

struct SvxResult {
  Survey survey;
  Diagnostics warnings;
};

inline Observations observe_svx(const std::string& text, Diagnostics& warnings) {
  return std::get<Observations>(format_of("x.svx").read(text, "x.svx", {}, warnings));
}

inline SvxResult read_svx_text(const std::string& text) {
  SvxResult out;
  out.survey = adjust(observe_svx(text, out.warnings), out.warnings);
  return out;
}

/// The position of a station; a failure and NaN if there is none of this name.
inline Vec3d position_of(const Survey& survey, const std::string& name) {
  for (const Station& each : survey.stations)
    if (each.name == name) return each.position;
  ADD_FAILURE() << "no station " << name;
  return Vec3d(std::numeric_limits<double>::quiet_NaN());
}

inline void expect_near(const Vec3d& found, const Vec3d& expected, double tolerance) {
  EXPECT_NEAR(found.x, expected.x, tolerance);
  EXPECT_NEAR(found.y, expected.y, tolerance);
  EXPECT_NEAR(found.z, expected.z, tolerance);
}

}  // namespace vug::survey
