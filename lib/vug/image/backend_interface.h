// SPDX-License-Identifier: Apache-2.0
// Internal to image/: what the library of backend.h and its caller must agree on.
#pragma once

namespace vug::image {

/// Both sides must come from the same version, because classes cross the boundary.
inline constexpr const char* kBackendInterface = "picture library of vug " VUG_VERSION;

/// Names of the two functions that the library exports: `const char* ()` returns its
/// kBackendInterface, `const Backend* ()` the table.
inline constexpr const char* kBackendInterfaceFunction = "vug_image_files_interface";
inline constexpr const char* kBackendFunction = "vug_image_files";

}  // namespace vug::image
