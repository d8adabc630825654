// SPDX-License-Identifier: Apache-2.0
// Internal to image/: errors of pictures that cannot be read.
#pragma once

#include <vug/base/error.h>

#include <filesystem>
#include <string>

namespace vug::image {

/// Error(bad_input); `reason` continues the sentence.
inline Error read_error(const std::filesystem::path& path, const std::string& reason,
                        const std::string& hint = {}) {
  return Error(ErrorCode::bad_input, "cannot read picture '" + path.string() + "': " + reason, {},
               hint);
}

}  // namespace vug::image
