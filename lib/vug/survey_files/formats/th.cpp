// SPDX-License-Identifier: Apache-2.0
// The .th format of Therion: centrelines in nested surveys.
#include <vug/survey_files/format_kind.h>
#include <vug/survey_files/therion/read.h>

namespace vug::survey {
namespace {

Contents read_th(std::string_view bytes, const std::filesystem::path& file,
                 const ReadOptions& options, Diagnostics& warnings) {
  InputFiles files(file, bytes.size(), options);
  Observations observations = therion::read(bytes, files, warnings);
  observations.files = files.all();
  return observations;
}

}  // namespace
}  // namespace vug::survey

VUG_SURVEY_FORMAT(th) {
  return survey_format("th", "Therion texts: centrelines in nested surveys", "therion2024", read_th,
                       nullptr,
                       "'1 2 10.5 90 -5' below 'data normal from to length compass clino' in a "
                       "centreline");
}
