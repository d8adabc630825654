// Reading and writing picture files. Files with the same content have the same bytes: no time
// stamps and no host names are written.
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

/// Texts kept in a file's header, e.g. {"vug:seed", "7"}.
using Metadata = std::vector<std::pair<std::string, std::string>>;

struct ExrOptions {
  /// 16-bit floats (relative error 5e-4, largest value 65504); false: 32-bit.
  bool half = false;
  /// Channels or layers, also numbered ones, kept in 32 bits even when `half` is set: what 16 bits
  /// would spoil.
  std::vector<std::string> full_channels = {"Z", "P", "variance", "samples"};
  Metadata metadata;
  /// Where a crop lies: the image's top left pixel in a picture of full_width x full_height (EXR's
  /// data and display windows). Zeros: the image is the whole picture.
  struct Window {
    int x = 0, y = 0, full_width = 0, full_height = 0;
  } window;
  /// One part for each layer instead of all channels in one: readers that want one layer need not
  /// read the others.
  bool parts = false;
  /// Tiles of 64 x 64 pixels instead of lines.
  bool tiles = false;
  /// What red, green and blue mean: the standard attributes `chromaticities` and `colorInteropID`.
  WorkingSpace space = WorkingSpace::rec709;
  /// Standard attributes of the camera, row after row, for points as rows: p * M.
  std::optional<std::array<float, 16>> world_to_camera, world_to_ndc;
};

/// Multi-channel EXR, ZIP compression, whole or not there (AtomicFile).
/// Values beyond the range of half are clamped to it when they are stored as half.
/// Throws Error(io) when the file cannot be written, Error(bad_input) on an unusable image.
void write_exr(const std::filesystem::path& path, const Image& image,
               const ExrOptions& options = {});

/// One of several views of a picture, "left" and "right" for stereo.
struct ExrView {
  std::string name;
  const Image& image;
  ExrOptions options;
};

/// The same of several views, each in a part of its own (or in several, see ExrOptions::parts) that
/// says which it is by EXR's attribute `view`. The first is the one that readers of one view show.
void write_exr(const std::filesystem::path& path, const std::vector<ExrView>& views);

/// 8-bit PNG, sRGB unless a configured view says otherwise, of the channels R, G, B (or of the one
/// channel there is, as grey), through the view transform. Same errors as write_exr.
void write_png(const std::filesystem::path& path, const Image& image, const ViewOptions& view = {},
               const Metadata& metadata = {});

/// What write_png writes.
std::string png_bytes(const Image& image, const ViewOptions& view = {},
                      const Metadata& metadata = {});

/// Any file OpenImageIO reads, all channels as float; those of an EXR's parts together. Integer
/// files become [0, 1]; with `linear`, R, G, B of 8- and 16-bit files are turned from sRGB to
/// linear light. Error(bad_input) names the file and the reason (missing, no picture, cut short).
struct ReadOptions {
  bool linear = false;
};
Image read(const std::filesystem::path& path, const ReadOptions& options = {});

/// Size, channels and header texts without the pixels.
struct FileInfo {
  int width = 0;
  int height = 0;
  int left = 0, top = 0;  ///< Where its pixels begin in the whole picture, which may be larger.
  std::vector<std::string> channels;
  std::vector<std::string> formats;  ///< "half", "float", "uint8", one for each channel.
  Metadata metadata;
  std::optional<Chromaticities> chromaticities;  ///< Of an EXR that tells its primaries.
};
FileInfo read_info(const std::filesystem::path& path);

/// The way of the file's linear colours to Rec.709: plain for one that tells no primaries.
ColourMatrix to_rec709(const FileInfo& info);

/// One channel in [0, 1] for heightfields: the only channel, else the mean of R, G, B as stored
/// (no colour conversion).
Image read_grey(const std::filesystem::path& path);

}  // namespace vug::image
