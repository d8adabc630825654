// SPDX-License-Identifier: Apache-2.0
// Internal to image/: writing of EXR files with OpenEXR to an existing temporary file.
#pragma once

#include <vug/image/deep.h>
#include <vug/image/io.h>

#include <filesystem>
#include <vector>

namespace vug::image::exr {

/// See image::write_exr; errors refer to `path`.
void write_flat(const std::filesystem::path& path, const std::filesystem::path& temporary,
                const std::vector<ExrView>& views);
/// See image::write_deep_exr; errors refer to `path`.
void write_deep(const std::filesystem::path& path, const std::filesystem::path& temporary,
                const std::vector<DeepView>& views);

}  // namespace vug::image::exr
