// Files that are written piece by piece.
#pragma once

#include <vug/mesh/format.h>

#include <filesystem>
#include <functional>

namespace vug::mesh {

/// Hands `write` what takes the file's bytes; the file is there when it returns, whole, or as it
/// was when anything throws. Error(io).
void write_file(const std::filesystem::path& file,
                const std::function<void(const ByteSink&)>& write);

}  // namespace vug::mesh
