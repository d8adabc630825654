// SPDX-License-Identifier: Apache-2.0
// A level set read from a file; see sampled.h.
#include <vug/field/kind.h>
#include <vug/field/sampled.h>

namespace vug::field {
namespace {

struct Grid {
  std::filesystem::path file;
  std::string name;

  static void describe(Schema<Grid>& s) {
    s.doc("The solid of a level set in a .vdb file, interpolated between its voxels.")
        .param("file", &Grid::file, {.doc = "a .vdb file", .required = true})
        .param("name", &Grid::name, {.doc = "name of the grid; empty: the first level set"});
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(grid) {
  return field_kind<Grid>("grid", "primitive", [](const Grid& g) {
    return sampled(load_grid(g.file.string(), g.name));
  });
}
