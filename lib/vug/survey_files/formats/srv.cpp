// SPDX-License-Identifier: Apache-2.0
// The .srv format of Walls: legs, walls and fixed stations.
#include <vug/survey_files/format_kind.h>
#include <vug/survey_files/text_encoding.h>
#include <vug/survey_files/walls/read.h>

namespace vug::survey {
namespace {

Contents read_srv(std::string_view bytes, const std::filesystem::path& file, const ReadOptions&,
                  Diagnostics& warnings) {
  return walls::read(as_utf8(bytes), file.string(), warnings);
}

}  // namespace
}  // namespace vug::survey

VUG_SURVEY_FORMAT(srv) {
  return survey_format("srv", "Walls surveys: legs, splays, walls and fixed stations",
                       "mckenzie2008", read_srv, nullptr,
                       "'1 2 10.5 90 -5': from, to, distance, azimuth, inclination");
}
