// SPDX-License-Identifier: Apache-2.0
// Writes the bytes of a mesh file in chunks.
#pragma once

#include <vug/mesh/format.h>

#include <filesystem>
#include <functional>
#include <string>

namespace vug::mesh {

/// Calls `write` with a sink for the file's bytes. The file is complete on return; if anything
/// throws, the previous file remains unchanged. Throws Error(io).
void write_file(const std::filesystem::path& file,
                const std::function<void(const ByteSink&)>& write);

/// The same for a file that begins with offsets of later data: the bytes that `write` returns
/// replace the first bytes of the file.
void write_file_with_header(const std::filesystem::path& file,
                            const std::function<std::string(const ByteSink&)>& write);

}  // namespace vug::mesh
