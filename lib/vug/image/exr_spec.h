// What the headers of all our EXRs share. For sources of this module: it opens OpenImageIO.
#pragma once

#include <vug/image/io.h>

#include <OpenImageIO/imageio.h>

namespace vug::image {

/// Size, windows, tiles, primaries and camera; ZIP, no channels, no texts.
OIIO::ImageSpec exr_spec(int width, int height, const ExrOptions& options);

}  // namespace vug::image
