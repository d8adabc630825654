// SPDX-License-Identifier: Apache-2.0
// What holds for the reader of every survey format and any bytes: it fails with bad_input, or
// returns finite values and valid indices, also after the closure of loops; the result can be
// written and read again in its format and as .svx.
#pragma once

#include "require.h"

#include <vug/base/utf8.h>
#include <vug/survey/adjust.h>
#include <vug/survey/statistics.h>
#include <vug/survey_files/format.h>

#include <cmath>
#include <cstdint>

namespace vug::survey {

inline bool finite(const Vec3d& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

inline void check_names(const std::vector<Station>& stations) {
  for (const Station& station : stations)
    require(is_utf8(station.name) && is_utf8(station.comment), "names are UTF-8");
}

inline void check_tubes(const std::vector<Tube>& tubes, size_t stations) {
  for (const Tube& tube : tubes)
    for (const CrossSection& section : tube) {
      require(section.station >= 0 && static_cast<size_t>(section.station) < stations,
              "cross-sections name stations");
      for (const auto& side : {section.left, section.right, section.up, section.down})
        require(!side || std::isfinite(*side), "walls are finite");
    }
}

inline void check_leg(const Leg& leg, size_t stations) {
  for (const int end : {leg.from, leg.to})
    require(end >= 0 && static_cast<size_t>(end) < stations, "legs name stations");
  require(std::isfinite(leg.length), "lengths are finite");
}

inline void check(const Survey& survey) {
  const size_t n = survey.stations.size();
  check_names(survey.stations);
  for (const Station& station : survey.stations) require(finite(station.position), "finite");
  for (const Leg& leg : survey.legs) check_leg(leg, n);
  check_tubes(survey.tubes, n);
  for (const Scrap& scrap : survey.scraps)
    for (const auto& triangle : scrap.triangles)
      for (const int corner : triangle)
        require(corner >= 0 && static_cast<size_t>(corner) < scrap.points.size(), "corners");
  for (const Misclosure& misclosure : survey.misclosures)
    for (const int station : misclosure.stations)
      require(static_cast<size_t>(station) < n, "traverses name stations");
}

inline void check(const Observations& survey) {
  const size_t n = survey.stations.size();
  check_names(survey.stations);
  for (const ObservedLeg& leg : survey.legs) {
    check_leg(leg.leg, n);
    const Covariance& c = leg.covariance;
    require(finite(leg.vector), "vectors are finite");
    require(finite({c.xx, c.yy, c.zz}) && finite({c.xy, c.yz, c.zx}), "covariances are finite");
    require(c.xx >= 0 && c.yy >= 0 && c.zz >= 0, "variances are not negative");
  }
  for (const Equate& equate : survey.equates)
    require(static_cast<size_t>(equate.a) < n && static_cast<size_t>(equate.b) < n, "equates");
  for (const Fix& fix : survey.fixes)
    require(static_cast<size_t>(fix.station) < n && finite(fix.position), "fixes");
  check_tubes(survey.tubes, n);
}

/// The coordinates of a file: as it contains them, or from its measurements.
inline Survey survey_of(Contents contents, Diagnostics& warnings) {
  std::visit([](const auto& survey) { check(survey); }, contents);
  if (Survey* survey = std::get_if<Survey>(&contents)) return std::move(*survey);
  Survey survey = adjust(std::get<Observations>(std::move(contents)), warnings);
  check(survey);
  return survey;
}

/// A survey that a format can store is read again.
inline Survey write_and_read(const Survey& survey, const Format& format, const ReadOptions& options,
                             Diagnostics& warnings) {
  std::string written;
  try {
    written = format.write(survey);
  } catch (const Error& error) {
    require(error.code() == ErrorCode::bad_input, "the format cannot store the survey");
    return survey;
  }
  return survey_of(format.read(written, "again." + format.info.name, options, warnings), warnings);
}

inline void fuzz(const std::string& extension, const uint8_t* data, size_t size) {
  const std::string file = "fuzz." + extension;
  const Format& format = format_of(file);
  // No file lies in this folder, so that texts cannot read files.
  ReadOptions options;
  options.root = "/no/such/folder";
  Diagnostics warnings;
  std::optional<Survey> survey;
  try {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    survey = survey_of(format.read(bytes, file, options, warnings), warnings);
  } catch (const Error& error) {
    require(error.code() == ErrorCode::bad_input, "errors blame the input");
    require(error.where().file == file || error.where().file.empty(), "errors name the file");
    return;
  }
  const Statistics size_of_survey = measure(*survey);
  require(size_of_survey.loops >= 0 && size_of_survey.components >= 0, "counts");
  if (format.write) write_and_read(*survey, format, options, warnings);
  const Survey again = write_and_read(*survey, format_of("x.svx"), options, warnings);
  require(again.legs.size() <= survey->legs.size(), "the text has the legs of the survey");
}

}  // namespace vug::survey
