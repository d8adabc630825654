// SPDX-License-Identifier: Apache-2.0
// Internal to image/oiio: headers (compression, windows, primaries) and output shared by all EXR
// writers. Includes OpenImageIO.
#pragma once

#include <vug/image/io.h>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

namespace vug::image::oiio {

/// Size, windows, tiles, primaries and camera, with ZIP compression and without channels or texts.
OIIO::ImageSpec exr_spec(int width, int height, const ExrOptions& options);

/// A multi-part file being written under a temporary name; errors refer to `path`.
class ExrOutput {
 public:
  ExrOutput(const std::filesystem::path& path, const std::filesystem::path& temporary,
            const std::vector<OIIO::ImageSpec>& parts);
  /// Starts a part; parts are written in order.
  void begin(size_t part);
  /// Throws Error(io) if `done` is false.
  void check(bool done) const;
  /// Throws Error(io) unless the file is complete.
  void close();
  OIIO::ImageOutput* operator->() { return output_.get(); }

 private:
  std::filesystem::path path_, temporary_;
  const std::vector<OIIO::ImageSpec>& parts_;
  // OpenImageIO's own file output does not notice if the last bytes do not fit on the disk.
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  OIIO::Filesystem::IOFile io_;
  std::unique_ptr<OIIO::ImageOutput> output_;
};

}  // namespace vug::image::oiio
