// SPDX-License-Identifier: Apache-2.0
// Filtered texture lookups through OpenImageIO's texture system, which loads tiles and MIP levels
// on demand and keeps them in a cache shared by all textures.
#pragma once

#include <vug/base/vec.h>

#include <filesystem>
#include <memory>

namespace vug::image {

class Texture {
 public:
  /// Throws Error(bad_input) with the file name if it is missing, not an image, or contains numbers
  /// that are not finite. Integer files are taken as sRGB, float files as linear light with the
  /// primaries given in the file, or Rec.709.
  explicit Texture(const std::filesystem::path& path);

  /// Linear Rec.709; grey files give three equal values. (0, 0) is the top left corner, (1, 1) the
  /// bottom right; the image repeats. `width` is the filter width as a fraction of the image. The
  /// filter is applied to the stored values, before sRGB is converted to linear light.
  Vec3d at(double s, double t, double width) const;

 private:
  struct File;
  std::shared_ptr<const File> file_;
};

}  // namespace vug::image
