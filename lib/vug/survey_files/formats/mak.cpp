// SPDX-License-Identifier: Apache-2.0
// The .mak format of Compass: a project with .dat files and fixed stations.
#include <vug/survey_files/compass/mak.h>
#include <vug/survey_files/format_kind.h>
#include <vug/survey_files/text_encoding.h>

namespace vug::survey {
namespace {

Contents read_mak(std::string_view bytes, const std::filesystem::path& file,
                  const ReadOptions& options, Diagnostics& warnings) {
  InputFiles files(file, bytes.size(), options);
  Observations observations = compass::read_mak(as_utf8(bytes), files, warnings);
  observations.files = files.all();
  return observations;
}

}  // namespace
}  // namespace vug::survey

VUG_SURVEY_FORMAT(mak) {
  return survey_format("mak", "Compass projects: .dat files and fixed stations", "compass2024",
                       read_mak, nullptr, "'#cave.dat;', which names a file with legs");
}
