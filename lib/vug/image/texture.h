// Pictures looked up at places, blurred to what one look takes in: OpenImageIO's texture system,
// whose tiles and smaller copies of the picture are read when needed and kept in a cache that all
// textures share.
#pragma once

#include <vug/base/vec.h>

#include <filesystem>
#include <memory>

namespace vug::image {

class Texture {
 public:
  /// Error(bad_input), naming the file: missing, no picture, or holding numbers that are not
  /// finite. Integer files are taken for sRGB, files of floats for linear light of the primaries
  /// that they tell, or of Rec.709.
  explicit Texture(const std::filesystem::path& path);

  /// Linear Rec.709, of grey files three times the same. (0, 0) is the top left corner, (1, 1) the
  /// bottom right; the picture repeats. `width`: of the look, as a part of the picture's. The
  /// blur is taken of the numbers in the file, before sRGB is turned to linear light.
  Vec3d at(double s, double t, double width) const;

 private:
  struct File;
  std::shared_ptr<const File> file_;
};

}  // namespace vug::image
