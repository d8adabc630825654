// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/survey/format.h>

#include <fmt/format.h>

namespace vug::survey {

const Format& format_of(const std::filesystem::path& file) {
  std::string extension = extension_of(file);
  if (!extension.empty()) extension.erase(0, 1);
  std::vector<std::string> known;
  for (const Format* format : formats()) {
    if (format->info.name == extension) return *format;
    known.push_back(format->info.name);
  }
  throw Error(ErrorCode::bad_input,
              fmt::format("'{}' does not have the extension of a survey format", file.string()), {},
              fmt::format("known: {}", fmt::join(known, ", ")));
}

}  // namespace vug::survey
