// SPDX-License-Identifier: Apache-2.0
// The .dat format of Compass: surveys with readings in feet and degrees.
#include <vug/survey_files/compass/dat.h>
#include <vug/survey_files/format_kind.h>
#include <vug/survey_files/text_encoding.h>

namespace vug::survey {
namespace {

Contents read_dat(std::string_view bytes, const std::filesystem::path& file, const ReadOptions&,
                  Diagnostics& warnings) {
  Observations result;
  NamedStations stations(result.stations);
  compass::DatTarget target{result, stations};
  compass::read_dat(as_utf8(bytes), file.string(), target, warnings);
  return result;
}

}  // namespace
}  // namespace vug::survey

VUG_SURVEY_FORMAT(dat) {
  return survey_format("dat", "Compass surveys: legs, splays and distances to the walls",
                       "compass2024", read_dat, nullptr,
                       "'A B 34.4 90 -5 1 2 3 4' below the header of a survey");
}
