// SPDX-License-Identifier: Apache-2.0
// Files from which a level set returns unchanged, without the metadata of files for other programs.
#pragma once

#include <vug/volume/level_set.h>

#include <filesystem>

namespace vug::volume {

/// Writes the samples; equal level sets have files of equal bytes. Throws Error(io).
void write_exact(const std::filesystem::path& target, const LevelSet& level_set);
/// The level set that was written: the same tree with the same bits. Throws Error(bad_input).
LevelSet read_exact(const std::filesystem::path& source);

}  // namespace vug::volume
