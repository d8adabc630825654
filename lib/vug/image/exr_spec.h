// What all our EXRs share: headers, and the way to the file. For sources of this module: it opens
// OpenImageIO.
#pragma once

#include <vug/image/io.h>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

namespace vug::image {

/// Size, windows, tiles, primaries and camera; ZIP, no channels, no texts.
OIIO::ImageSpec exr_spec(int width, int height, const ExrOptions& options);

/// A file of parts on its way out, under a temporary name; its faults as errors about `path`.
class ExrOutput {
 public:
  ExrOutput(const std::filesystem::path& path, const std::filesystem::path& temporary,
            const std::vector<OIIO::ImageSpec>& parts);
  /// Turns to a part; in order.
  void begin(size_t part);
  /// Error(io) unless what was asked of the file went well.
  void check(bool done) const;
  /// Error(io) unless all of it is in the file.
  void close();
  OIIO::ImageOutput* operator->() { return output_.get(); }

 private:
  std::filesystem::path path_, temporary_;
  const std::vector<OIIO::ImageSpec>& parts_;
  // OpenImageIO's own way to the file does not see when its last bytes find no room.
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  OIIO::Filesystem::IOFile io_;
  std::unique_ptr<OIIO::ImageOutput> output_;
};

}  // namespace vug::image
