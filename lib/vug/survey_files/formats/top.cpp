// SPDX-License-Identifier: Apache-2.0
// The .top format of PocketTopo, version 3: shots and reference points.
#include <vug/survey_files/format_kind.h>
#include <vug/survey_files/pockettopo/read.h>

namespace vug::survey {
namespace {

Contents read_top(std::string_view bytes, const std::filesystem::path& file, const ReadOptions&,
                  Diagnostics& warnings) {
  return pockettopo::read(bytes, file.string(), warnings);
}

}  // namespace
}  // namespace vug::survey

VUG_SURVEY_FORMAT(top) {
  return survey_format("top", "PocketTopo, version 3: legs, splays and reference points",
                       "heeb2010", read_top);
}
