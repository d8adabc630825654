// SPDX-License-Identifier: Apache-2.0
#include <vug/survey_files/read_survey.h>

#include <vug/base/atomic_file.h>
#include <vug/survey/adjust.h>
#include <vug/survey_files/input_files.h>

#include <fmt/format.h>

namespace vug::survey {

Survey read_survey(const std::filesystem::path& file, const ReadOptions& options,
                   Diagnostics& warnings) {
  const Format& format = format_of(file);
  std::error_code unknown;
  const auto size = std::filesystem::file_size(file, unknown);
  if (!unknown) require_size(static_cast<size_t>(size), options, {file.string(), 1, 1});
  const std::string bytes = read_text(file);
  require_size(bytes.size(), options, {file.string(), 1, 1});
  Contents contents = format.read(bytes, file, options, warnings);
  Survey* read = std::get_if<Survey>(&contents);
  Survey survey =
      read ? std::move(*read) : adjust(std::get<Observations>(std::move(contents)), warnings);
  if (survey.files.empty()) survey.files = {file};
  if (survey.stations.empty())
    throw Error(ErrorCode::bad_input, "the survey has no stations", {file.string(), 1, 1},
                format.example ? fmt::format("write a leg, e.g. {}", format.example)
                               : "save the survey again with the program that wrote it");
  return survey;
}

const Format& writable_format_of(const std::filesystem::path& file) {
  const Format* format = find_format(file);
  if (format && format->write) return *format;
  std::vector<std::string> written;
  for (const Format* each : formats())
    if (each->write) written.push_back("." + each->info.name);
  throw Error(ErrorCode::bad_input, fmt::format("surveys cannot be written to '{}'", file.string()),
              {}, fmt::format("files that can be written: {}", fmt::join(written, ", ")));
}

void write_survey(const Survey& survey, const std::filesystem::path& file) {
  write_text(file, writable_format_of(file).write(survey));
}

}  // namespace vug::survey
