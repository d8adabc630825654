// SPDX-License-Identifier: Apache-2.0
// The .plt format of Compass: stations, legs and distances to the walls, in feet.
#include <vug/survey_files/compass/plt.h>
#include <vug/survey_files/format_kind.h>
#include <vug/survey_files/text_encoding.h>

namespace vug::survey {
namespace {

Contents read_plt(std::string_view bytes, const std::filesystem::path& file, const ReadOptions&,
                  Diagnostics& warnings) {
  return compass::read_plt(as_utf8(bytes), file.string(), warnings);
}

}  // namespace
}  // namespace vug::survey

VUG_SURVEY_FORMAT(plt) {
  return survey_format("plt", "Compass plots: stations, legs and distances to the walls",
                       "compass2024", read_plt);
}
