// SPDX-License-Identifier: Apache-2.0
// Reading and writing of image files. Equal content gives equal bytes: neither time stamps nor host
// names are written.
#pragma once

#include <vug/image/colour_space.h>
#include <vug/image/image.h>
#include <vug/image/view.h>

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vug::image {

/// Texts in a file's header, e.g. {"vug:seed", "7"}.
using Metadata = std::vector<std::pair<std::string, std::string>>;

struct ExrOptions {
  /// 16-bit floats (relative error 5e-4, largest value 65504) instead of 32-bit floats.
  bool half = false;
  /// Channels or layers, including numbered ones, that stay in 32 bits even if `half` is set
  /// because 16 bits are not precise enough.
  std::vector<std::string> full_channels = {"Z", "P", "variance", "samples"};
  Metadata metadata;
  /// Position of a crop: the image's top left pixel in an image of full_width x full_height (EXR's
  /// data and display windows). Zeros: the image is complete.
  struct Window {
    int x = 0, y = 0, full_width = 0, full_height = 0;
  } window;
  /// One part per layer instead of all channels in one part, so that readers of one layer can skip
  /// the others.
  bool parts = false;
  /// Tiles of 64 x 64 pixels instead of scan lines.
  bool tiles = false;
  /// Primaries of red, green and blue: the standard attributes `chromaticities` and
  /// `colorInteropID`.
  WorkingSpace space = WorkingSpace::rec709;
  /// Standard camera attributes, row by row, for row vectors: p * M.
  std::optional<std::array<float, 16>> world_to_camera, world_to_ndc;
};

/// Writes a multi-channel EXR with ZIP compression; the file is complete or absent (AtomicFile).
/// Values beyond the range of half are clamped when stored as half. Throws Error(io) if the file
/// cannot be written, Error(bad_input) for an unusable image.
void write_exr(const std::filesystem::path& path, const Image& image,
               const ExrOptions& options = {});

/// One of several views of an image, "left" and "right" for stereo.
struct ExrView {
  std::string name;
  const Image& image;
  ExrOptions options;
};

/// Writes several views, each in a part of its own (or in several, see ExrOptions::parts) with the
/// EXR attribute `view`. Readers of a single view show the first one.
void write_exr(const std::filesystem::path& path, const std::vector<ExrView>& views);

/// Writes an 8-bit PNG, sRGB unless an OpenColorIO view specifies otherwise, from the channels R,
/// G, B (or a single channel as grey) after the view transform. Throws the same errors as
/// write_exr.
void write_png(const std::filesystem::path& path, const Image& image, const ViewOptions& view = {},
               const Metadata& metadata = {});

/// Writes numbers, such as class labels, as an 8-bit grey PNG without a colour space; row 0 is the
/// top row. Throws the same errors as write_exr.
void write_grey_png(const std::filesystem::path& path, const std::vector<uint8_t>& values,
                    int width, int height);

/// R, G and B as displayed, a byte each, row by row from the top, with dither if the view has it.
std::vector<uint8_t> display_codes(const Image& image, const ViewOptions& view);

/// The bytes that write_png writes.
std::string png_bytes(const Image& image, const ViewOptions& view = {},
                      const Metadata& metadata = {});

/// Reads any file supported by OpenImageIO, with all channels as float and all parts of an EXR
/// combined. Integer files are scaled to [0, 1]; with `linear`, R, G, B of 8- and 16-bit files are
/// converted from sRGB to linear light. Throws Error(bad_input) with the file and the reason
/// (missing, not an image, truncated).
struct ReadOptions {
  bool linear = false;
};
Image read(const std::filesystem::path& path, const ReadOptions& options = {});

/// Size, channels and header texts without the pixels.
struct FileInfo {
  int width = 0;
  int height = 0;
  int left = 0, top = 0;  ///< Position of its pixels in the whole image, which may be larger.
  std::vector<std::string> channels;
  std::vector<std::string> formats;  ///< "half", "float", "uint8", one per channel.
  Metadata metadata;
  std::optional<Chromaticities> chromaticities;  ///< Set for an EXR with the attribute.
};
FileInfo read_info(const std::filesystem::path& path);

/// The conversion of the file's linear colours to Rec.709; the identity if the file has no
/// primaries.
ColourMatrix to_rec709(const FileInfo& info);

/// One channel in [0, 1] for heightfields: the only channel, or the mean of R, G, B as stored (no
/// colour conversion).
Image read_grey(const std::filesystem::path& path);

}  // namespace vug::image
