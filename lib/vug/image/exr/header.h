// SPDX-License-Identifier: Apache-2.0
// Internal to image/: what the headers of all EXR files that we write have in common. Includes
// OpenEXR.
#pragma once

#include <vug/image/io.h>

#include <OpenEXR/ImfHeader.h>

#include <string>

namespace vug::image::exr {

/// Windows, primaries, camera and the view's name, with ZIP compression and without channels, texts
/// or a type. Part names are required in files with several parts.
Imf::Header header_of(int width, int height, const ExrOptions& options, const std::string& view);

}  // namespace vug::image::exr
