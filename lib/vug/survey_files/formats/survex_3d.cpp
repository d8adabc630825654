// SPDX-License-Identifier: Apache-2.0
// The .3d format of Survex, version 8: stations, legs, cross-sections and misclosures.
#include <vug/survey_files/format_kind.h>
#include <vug/survey_files/survex3d/read.h>
#include <vug/survey_files/survex3d/write.h>

namespace vug::survey {
namespace {

Contents read_3d(std::string_view bytes, const std::filesystem::path& file, const ReadOptions&,
                 Diagnostics& warnings) {
  return survex3d::read(bytes, file.string(), warnings);
}

}  // namespace
}  // namespace vug::survey

VUG_SURVEY_FORMAT(survex_3d) {
  return survey_format("3d",
                       "Survex image, version 8: stations, legs, cross-sections and misclosures, "
                       "in whole centimetres",
                       "survex2024", read_3d, survex3d::write);
}
