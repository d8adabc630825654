// SPDX-License-Identifier: Apache-2.0
// The learned light of a picture as a file, so that the parts of the picture do not learn it again.
#pragma once

#include <vug/render/film/partial_render.h>
#include <vug/render/paths/learned_light.h>

#include <filesystem>

namespace vug::render {

/// `picture` identifies the picture for which the light was learned. The file is complete or absent
/// (AtomicFile). Throws Error(io).
void write_guiding(const std::filesystem::path& path, const PartialRenderHeader& picture,
                   const LearnedLight& light);

/// Throws Error(bad_input) with the file and the fault: missing, another kind of file or version,
/// truncated, changed, or learned for another picture than `picture`.
LearnedLightPtr read_guiding(const std::filesystem::path& path, const PartialRenderHeader& picture);

/// The picture for which the light in the file was learned. Throws as read_guiding does.
PartialRenderHeader read_guiding_header(const std::filesystem::path& path);

/// True if the file starts like a guiding file; false if it cannot be read.
bool is_guiding(const std::filesystem::path& path);

}  // namespace vug::render
