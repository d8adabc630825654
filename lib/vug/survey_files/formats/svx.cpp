// SPDX-License-Identifier: Apache-2.0
// Survex .svx: measurements of a cave as text.
#include <vug/survey_files/format_kind.h>
#include <vug/survey_files/svx/reader.h>
#include <vug/survey_files/svx/write.h>
#include <vug/survey_files/text_encoding.h>

namespace vug::survey {
namespace {

Contents read_svx(std::string_view bytes, const std::filesystem::path& file,
                  const ReadOptions& options, Diagnostics& warnings) {
  InputFiles files(file, bytes.size(), options);
  svx::Reader reader(files, warnings);
  reader.read(as_utf8(bytes));
  Observations observations = reader.finish();
  observations.files = files.all();
  return observations;
}

}  // namespace
}  // namespace vug::survey

VUG_SURVEY_FORMAT(svx) {
  return survey_format("svx",
                       "Survex data: measurements of all data styles, with their errors, read with "
                       "the included files",
                       "survex2024", read_svx, svx::write,
                       "'1 2 10.5 90 -5': from, to, tape, compass, clino");
}
