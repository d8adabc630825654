// SPDX-License-Identifier: Apache-2.0
// The .lox format of Loch, Therion's viewer: stations, legs, cross-sections and walls.
#include <vug/survey_files/format_kind.h>
#include <vug/survey_files/lox/read.h>
#include <vug/survey_files/lox/write.h>

namespace vug::survey {
namespace {

Contents read_lox(std::string_view bytes, const std::filesystem::path& file, const ReadOptions&,
                  Diagnostics& warnings) {
  return lox::read(bytes, file.string(), warnings);
}

}  // namespace
}  // namespace vug::survey

VUG_SURVEY_FORMAT(lox) {
  return survey_format("lox",
                       "Loch model of Therion: stations, legs, cross-sections, and the walls of "
                       "scraps",
                       "therion2024", read_lox, lox::write);
}
