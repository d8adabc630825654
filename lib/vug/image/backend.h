// SPDX-License-Identifier: Apache-2.0
// Internal to image/: the functions that use OpenImageIO and OpenColorIO. They are in a shared
// library of their own, which is loaded on first use
// (docs/explanation/decisions/0031-image-libraries-on-first-use.md).
#pragma once

#include <vug/image/deep_info.h>
#include <vug/image/io.h>
#include <vug/image/ocio_view.h>
#include <vug/image/warp.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vug::image {

/// The functions as the library defines them; everything else calls them through backend(). The
/// library has its own copies of all static variables, so these functions neither create temporary
/// files nor change settings. They may throw Error.
namespace oiio {

struct Pixels {
  Image image;  ///< As stored; integers are scaled to [0, 1].
  bool integers = false;
};

/// Filtered lookups in one file.
class TextureLookup {
 public:
  virtual ~TextureLookup() = default;
  /// Sets `values` to the file's first channels, as stored; see Texture::at. Returns false if the
  /// file cannot be read.
  virtual bool sample(float s, float t, float width, float* values) const = 0;
};

// Reading: for existing files with sound headers (exr_check.h, png_check.h).
Pixels read(const std::filesystem::path& path);
FileInfo read_info(const std::filesystem::path& path);
std::optional<DeepInfo> read_deep_info(const std::filesystem::path& path);
/// For a file with at least `channels` channels.
std::shared_ptr<const TextureLookup> texture(const std::filesystem::path& path, int channels);

/// Resamples into all of `out`, which has the channels of `picture`; see warped.
void warp(const Image& picture, const Homography& to_target, Image& out);
/// view_options for a selection that needs OpenColorIO; `builtin` is the built-in view of that
/// name, which is used if the configuration has no such view.
ViewOptions ocio_view(const ViewSelection& selection, WorkingSpace space,
                      std::optional<ViewTransform> builtin);

}  // namespace oiio

/// The table through which the library is called.
struct Backend {
  decltype(&oiio::read) read;
  decltype(&oiio::read_info) read_info;
  decltype(&oiio::read_deep_info) read_deep_info;
  decltype(&oiio::texture) texture;
  decltype(&oiio::warp) warp;
  decltype(&oiio::ocio_view) ocio_view;
};

/// Loads the library on first use, for the rest of the process; thread-safe. Throws Error(io) if it
/// is missing, cannot be loaded, or has another interface.
const Backend& backend();

}  // namespace vug::image
