// SPDX-License-Identifier: Apache-2.0
// Ground with the heights of an image.
#include <vug/field/ground.h>
#include <vug/field/opaque.h>
#include <vug/image/io.h>

#include <cmath>

namespace vug::field {
namespace {

struct Heightfield {
  std::filesystem::path file;
  Vec3d size{10, 1, 10};
  double base = 0.1;
  Sampling sampling = Sampling::bicubic;

  static void describe(Schema<Heightfield>& s) {
    s.doc(
         "A block of ground whose top follows the brightness of an image: black at y = 0, the top "
         "edge of the image towards -z.")
        .cite("catmull1974")
        .param(
            "file", &Heightfield::file,
            {.doc = "any image; one channel, or the mean of three, from 0 to 1", .required = true})
        .param("size", &Heightfield::size,
               positive_length("size of the ground along x and z, and along y from black to white"))
        .param("base", &Heightfield::base, positive_length("thickness of the block below black"))
        .choice("sampling", &Heightfield::sampling,
                {{"bilinear", Sampling::bilinear}, {"bicubic", Sampling::bicubic}},
                "interpolation of heights between pixels");
  }
};

Field ground(const Heightfield& params) {
  image::Image picture = image::read_grey(params.file);
  if (picture.width < 2 || picture.height < 2)
    throw Error(ErrorCode::bad_input,
                "'" + params.file.string() +
                    "' is too small for a heightfield: it needs at least 2 x 2 pixels");
  for (float& height : picture.pixels) {
    height *= static_cast<float>(params.size.y);
    if (!std::isfinite(height))
      throw Error(ErrorCode::bad_input,
                  "'" + params.file.string() + "' contains values that are not finite");
  }
  const Ground source{Heightmap(picture.width, picture.height, std::move(picture.pixels),
                                params.size.x, params.size.z, params.sampling),
                      Vec3d(0), params.size, params.base};
  return Field(std::make_shared<OpaqueNode<Ground>>("heightfield", source.traits(), source));
}

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(heightfield) { return field_kind<Heightfield>("heightfield", "primitive", ground); }
