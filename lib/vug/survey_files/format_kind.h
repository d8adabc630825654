// SPDX-License-Identifier: Apache-2.0
// Definitions for the source file of a survey format. The macro opens its one exported definition,
// outside of any namespace:
//   VUG_SURVEY_FORMAT(svx) { return survey_format("svx", "...", "...", read, write); }
#pragma once

#include <vug/base/kind.h>
#include <vug/survey_files/format.h>

#define VUG_SURVEY_FORMAT(name) VUG_EXPORT_KIND(vug::survey, Format, name##_format)

namespace vug::survey {

/// `name` is the extension in lower case; `write` is null if the format is only read;
/// see Format for `example`.
inline Format survey_format(std::string name, std::string doc, std::string cite,
                            Contents (*read)(std::string_view, const std::filesystem::path&,
                                             const ReadOptions&, Diagnostics&),
                            std::string (*write)(const Survey&) = nullptr,
                            const char* example = nullptr) {
  return {{std::move(name), "survey format", std::move(doc), std::move(cite), {}},
          read,
          write,
          example};
}

}  // namespace vug::survey
