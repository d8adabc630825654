// SPDX-License-Identifier: Apache-2.0
// The ground of a place on the Earth, from a file of elevations.
#include <vug/shot/networks.h>
#include <vug/terrain/terrain.h>

namespace vug::shot {
namespace {

struct Terrain : terrain::TerrainOptions {
  std::optional<NetworkPtr> network;
  field::Sampling interpolation = field::Sampling::bicubic;

  static void describe(Schema<Terrain>& s) {
    s.doc(
         "A block of ground whose top has the heights of a file (GeoTIFF, ASC, HGT or another "
         "raster that GDAL reads), north towards -z. Around a network, it lies where the "
         "coordinate systems of both put it.")
        .cite("gdal2022")
        .param("file", &Terrain::file, {.doc = "the elevations", .required = true})
        .param("around", &Terrain::network,
               {.doc = "the network whose space the scene has; by default the middle of the file "
                       "is the origin"})
        .param("margin", &Terrain::margin,
               {.doc = "ground around the stations of the network",
                .dimension = Dimension::length,
                .min = 0})
        .param("base", &Terrain::base,
               positive_length("rock below the lowest ground and the lowest station"))
        .param("system", &Terrain::system,
               {.doc = "coordinate system of the file, named as in surveys (\"EPSG:25833\"); by "
                       "default the one that it states"})
        .param("band", &Terrain::band,
               {.doc = "band with the heights, from 1; 0: the only one", .min = 0, .max = 65535})
        .param("raise", &Terrain::raise, any_length("added to the heights"))
        .param("fill", &Terrain::fill, any_length("height of cells without data"))
        .choice("sampling", &Terrain::interpolation,
                {{"bilinear", field::Sampling::bilinear}, {"bicubic", field::Sampling::bicubic}},
                "interpolation of heights between cells");
  }
};

field::Field place(Terrain p) {
  if (p.network) p.around = *p.network;
  p.sampling = p.interpolation;
  return terrain::terrain(p);
}

}  // namespace
}  // namespace vug::shot

VUG_NETWORK_FIELD_KIND(terrain) {
  return field::field_kind<Terrain>("terrain", "primitive", place);
}
