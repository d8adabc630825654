// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/survey_files/format.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::survey {

const Format* find_format(const std::filesystem::path& file) {
  const std::string extension = extension_of(file);
  const auto& all = formats();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Format* format) {
    return extension == "." + format->info.name;
  });
  return found == all.end() ? nullptr : *found;
}

const Format& format_of(const std::filesystem::path& file) {
  if (const Format* format = find_format(file)) return *format;
  std::error_code unknown;
  if (std::filesystem::is_directory(file, unknown))
    throw Error(ErrorCode::bad_input,
                fmt::format("'{}' is a folder, not the file of a survey", file.string()), {},
                "name the file that includes the others, for example cave/cave.svx");
  std::vector<std::string> known;
  for (const Format* format : formats()) known.push_back("." + format->info.name);
  throw Error(ErrorCode::bad_input,
              fmt::format("'{}' does not have the extension of a survey format", file.string()), {},
              fmt::format("known: {}", fmt::join(known, ", ")));
}

}  // namespace vug::survey
