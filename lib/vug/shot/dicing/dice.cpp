// SPDX-License-Identifier: Apache-2.0
// Micro-displacement of an object by dicing (cook1987reyes).
#include <vug/shot/dicing.h>

namespace vug::shot {
namespace {

struct Dice : Dicing {
  static void describe(Schema<Dice>& s) {
    s.doc(
         "Micro-displacement, for the entry `detail` of an object: before a picture is rendered, "
         "the triangles of the mesh are divided down to the size of pixels, and each new vertex "
         "moves onto the field. Large voxels then show all the detail of the field.")
        .cite("cook1987reyes")
        .param("pixels", &Dice::pixels,
               {.doc = "longest edge of a triangle, in pixels of the whole picture",
                .min = 0.1,
                .max = 100})
        .param("edge", &Dice::edge,
               positive_length("longest edge of a triangle in the scene, instead of `pixels`; "
                               "exports are diced only with it"))
        .param("least", &Dice::least, positive_length("edges are not made shorter than this"))
        .param("levels", &Dice::levels,
               {.doc = "number of times that an edge may be halved", .min = 1, .max = 12})
        .param("off_screen", &Dice::off_screen,
               {.doc = "factor on `pixels` far outside the picture and behind the camera, for "
                       "reflections and indirect light",
                .min = 1,
                .max = 1000})
        .param("field", &Dice::field,
               {.doc = "onto which the vertices move; default: the field of the volume, with all "
                       "its detail"})
        .param("camera", &Dice::camera,
               {.doc = "the camera that defines the pixels, for sequences in which the triangles "
                       "must not change; default: the camera of the picture"});
  }
  std::string fault() const {
    return edge && *edge < least ? "'edge' is shorter than 'least'" : "";
  }
};

}  // namespace
}  // namespace vug::shot

VUG_DICING_KIND(dice) {
  return make_kind<Dicing, Dice>("dice", "dicing", [](const Dice& p) { return Dicing(p); });
}
