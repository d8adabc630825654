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

/// The error of a file whose content is not what its format requires.
inline Error damage_error(const std::filesystem::path& path, const std::string& reason) {
  return read_error(path, reason, "write it again with the program that made it");
}

/// `ending`: the extension of the name, such as ".exr".
inline Error unreadable_beginning(const std::filesystem::path& path, const std::string& ending) {
  return damage_error(path, "it is not a " + ending + " image, or its beginning is damaged");
}

inline Error unreadable_pixels(const std::filesystem::path& path) {
  return damage_error(path, "its pixels are damaged or truncated");
}

}  // namespace vug::image
