// SPDX-License-Identifier: Apache-2.0
// Terrain in the space of networks, compared with planes in the coordinate system of the file.
#include "geotiff.h"

#include <vug/base/error.h>
#include <vug/base/scratch_folder.h>
#include <vug/network/survey_space.h>
#include <vug/terrain/terrain.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::terrain {
namespace {

class Terrains : public testing::Test {
 protected:
  const TerrainNode& build(const TerrainOptions& options) {
    field_ = terrain(options);
    return dynamic_cast<const TerrainNode&>(*field_.node());
  }
  std::string fault_of(const TerrainOptions& options) {
    try {
      terrain(options);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::bad_input);
      return error.what();
    }
    return "";
  }
  std::filesystem::path write(const std::string& name, const GeoTiff& tiff) {
    tiff.write(folder_.file(name));
    return folder_.file(name);
  }

  ScratchFolder folder_{"vug_terrain"};
  field::Field field_;
};

/// A place near Postojna in two systems, computed by cs2cs from latitude and longitude.
struct Known {
  Vec3d slovenian;  ///< EPSG:3794
  Vec3d utm;        ///< EPSG:32633
};
const Known kKnown[] = {
    {{437479.8339, 40319.9828, 0}, {437498.5918, 5038807.7357, 0}},   // 45.5 N 14.2 E
    {{437795.7383, 40650.2682, 0}, {437814.4014, 5039137.9220, 0}},   // 45.503 N 14.204 E
    {{437242.6062, 40044.4966, 0}, {437261.4353, 5038532.3322, 0}}};  // 45.4975 N 14.197 E

double plane(const Vec3d& utm) { return 500 + 0.2 * (utm.x - 437500) - 0.1 * (utm.y - 5038800); }

std::shared_ptr<network::Network> network_at(const std::vector<Vec3d>& places,
                                             const std::string& system) {
  auto out = std::make_shared<network::Network>();
  out->coordinate_system = system;
  out->origin = network::rounded_middle(places) + Vec3d(0, 0, 480);
  for (const Vec3d& p : places)
    out->stations.push_back({.position = network::to_scene(p + Vec3d(0, 0, 490) - out->origin)});
  return out;
}

/// The plane as cells of 10 m, with rows to the south or with a grid turned by `angle` radians.
GeoTiff plane_file(double angle = 0) {
  const double c = std::cos(angle), s = std::sin(angle);
  const std::array<double, 6> to = {436300 - 2000 * s, 10 * c,  10 * s,
                                    5040000 + 0.0,     -10 * s, -10 * c};
  return {.columns = 260,
          .rows = 260,
          .epsg = 32633,
          .transform = to,
          .height = [to](int column, int row) {
            const double i = column + 0.5, j = row + 0.5;
            return static_cast<float>(
                plane({to[0] + to[1] * i + to[2] * j, to[3] + to[4] * i + to[5] * j, 0}));
          }};
}

double height_at(const TerrainNode& node, const network::Network& network, const Vec3d& place) {
  const Vec3d p = network::to_scene(place - network.origin);
  return node.source().height(p.x, p.z) + network.origin.z;
}

TEST_F(Terrains, SurveyAndTerrainInDifferentSystemsAlign) {
  const auto network =
      network_at({kKnown[0].slovenian, kKnown[1].slovenian, kKnown[2].slovenian}, "EPSG:3794");
  for (const double angle : {0.0, 0.3, -0.1})
    for (const auto sampling : {field::Sampling::bilinear, field::Sampling::bicubic}) {
      const TerrainNode& node = build({.file = write("plane.tif", plane_file(angle)),
                                       .around = network,
                                       .margin = 50,
                                       .sampling = sampling});
      for (const Known& known : kKnown)
        EXPECT_NEAR(height_at(node, *network, known.slovenian), plane(known.utm), 2e-3) << angle;
    }
}

TEST_F(Terrains, CellsOfTheSameSystemAreKept) {
  const auto network = network_at({kKnown[0].utm, kKnown[1].utm}, "UTM33N");
  GeoTiff file = plane_file();
  file.height = [](int column, int row) { return static_cast<float>((column * 7 + row * 5) % 11); };
  const TerrainNode& node =
      build({.file = write("cells.tif", file), .around = network, .margin = 60});
  EXPECT_EQ(node.source().cell, 10);
  EXPECT_TRUE(node.source().warnings.empty());
  for (int i = 120; i < 130; ++i) {  // Centres of cells near the first place.
    const double x = 436300 + 10 * i + 5, y = 5040000 - 10 * 119 - 5;
    EXPECT_NEAR(height_at(node, *network, {x, y, 0}), (i * 7 + 119 * 5) % 11, 1e-4) << i;
  }
}

TEST_F(Terrains, RowsToTheNorthAndColumnsToTheWestAreTurned) {
  const auto network = network_at({{437500, 5038800, 0}}, "EPSG:32633");
  GeoTiff file = plane_file();
  const std::array<double, 6> to = {438800, -10, 0, 5037500, 0, 10};
  file.transform = to;
  file.height = [to](int column, int row) {
    return static_cast<float>(plane({to[0] - 10 * (column + 0.5), to[3] + 10 * (row + 0.5), 0}));
  };
  const TerrainNode& node =
      build({.file = write("turned.tif", file), .around = network, .margin = 100});
  const Vec3d place(437531, 5038852, 0);
  EXPECT_NEAR(height_at(node, *network, place), plane(place), 1e-3);
}

TEST_F(Terrains, LongitudesAndLatitudesBecomeMetres) {
  // Cells of 0.0001 degrees whose heights are a plane in degrees.
  const GeoTiff file{.columns = 100,
                     .rows = 100,
                     .epsg = 4326,
                     .geographic = true,
                     .transform = std::array<double, 6>{14.195, 1e-4, 0, 45.507, 0, -1e-4},
                     .height = [](int column, int row) {
                       return static_cast<float>(100 + 0.5 * column + 0.25 * row);
                     }};
  const auto network = network_at({kKnown[0].slovenian, kKnown[1].slovenian}, "EPSG:3794");
  const TerrainNode& node =
      build({.file = write("degrees.tif", file), .around = network, .margin = 10});
  // The cells of (14.2, 45.5) and of (14.204, 45.503), counted from the first centre.
  EXPECT_NEAR(height_at(node, *network, kKnown[0].slovenian), 100 + 0.5 * 49.5 + 0.25 * 69.5, 0.01);
  EXPECT_NEAR(height_at(node, *network, kKnown[1].slovenian), 100 + 0.5 * 89.5 + 0.25 * 39.5, 0.01);
  // Without a network, the zone of UTM gives metres: about 111 m for each 0.001 degrees.
  build({.file = folder_.file("degrees.tif")});
  EXPECT_NEAR(field_.bounds().size().z, 99 * 11.1, 8);
}

TEST_F(Terrains, WithoutANetworkTheMiddleIsTheOrigin) {
  const TerrainNode& node = build({.file = write("plane.tif", plane_file()), .base = 30});
  const Box3d box = field_.bounds();
  EXPECT_NEAR(box.min.x, -1295, 1);
  EXPECT_NEAR(box.max.z, 1295, 1);
  EXPECT_NEAR(node.source().height(0, 0), 0, 1);
  EXPECT_LT(field_.value({0, -10, 0}), 0);
  EXPECT_GT(field_.value({0, 10, 0}), 0);
}

TEST_F(Terrains, CellsWithoutDataNeedAHeight) {
  GeoTiff file = plane_file();
  file.missing = "-9999";
  const auto height = file.height;
  file.height = [height](int column, int row) {
    return column == 120 && row > 118 && row < 122 ? -9999.0f : height(column, row);
  };
  const auto network = network_at({kKnown[0].utm}, "UTM33N");
  TerrainOptions options{.file = write("holes.tif", file), .around = network, .margin = 50};
  EXPECT_NE(fault_of(options).find("has no height at 3 of "), std::string::npos);
  options.fill = 480;
  EXPECT_NEAR(height_at(build(options), *network, {437505, 5038795, 0}), 480, 1e-3);
}

TEST_F(Terrains, ReportsPlacesThatCannotMatch) {
  const auto far = network_at({kKnown[0].utm + Vec3d(9000, 0, 0)}, "UTM33N");
  const std::filesystem::path file = write("plane.tif", plane_file());
  EXPECT_NE(fault_of({.file = file, .around = far}).find("does not cover the network"),
            std::string::npos);
  GeoTiff nowhere = plane_file();
  nowhere.epsg = 0;
  const auto near = network_at({kKnown[0].utm}, "UTM33N");
  TerrainOptions options{.file = write("nowhere.tif", nowhere), .around = near};
  EXPECT_NE(fault_of(options).find("does not state its coordinate system"), std::string::npos);
  options.system = "UTM33N";
  EXPECT_EQ(fault_of(options), "");
  options.system = "EPSG:1";
  EXPECT_NE(fault_of(options).find("not a system of places"), std::string::npos);
  const auto local = network_at({kKnown[0].utm}, "");
  EXPECT_EQ(build({.file = file, .around = local}).source().warnings.size(), 1u);
}

TEST_F(Terrains, HeightsAboveTheEllipsoidAreReportedWithTheGeoid) {
  const GeoTiff file{.columns = 100,
                     .rows = 100,
                     .epsg = 4326,
                     .geographic = true,
                     .transform = std::array<double, 6>{14.195, 1e-4, 0, 45.507, 0, -1e-4}};
  const auto network = network_at({kKnown[0].slovenian}, "EPSG:3794");
  TerrainOptions options{
      .file = write("e.tif", file), .around = network, .margin = 10, .system = "EPSG:4979"};
  const std::vector<TerrainWarning> warnings = build(options).source().warnings;
  ASSERT_EQ(warnings.size(), 1u);
  // cs2cs EPSG:4979 EPSG:4326+5773 gives 45.9 m at 45.5 N 14.2 E.
  EXPECT_TRUE(warnings[0].hint.find("raise: -45.") != std::string::npos ||
              warnings[0].hint.find("no grid of the geoid") != std::string::npos)
      << warnings[0].hint;
  options.raise = -45.9;
  EXPECT_TRUE(build(options).source().warnings.empty());
  EXPECT_NEAR(height_at(build(options), *network, kKnown[0].slovenian), -45.9, 1e-3);
}

TEST_F(Terrains, GradientsAndIntervalsAreBounds) {
  GeoTiff file = plane_file();
  file.columns = file.rows = 12;
  file.epsg = 0;
  file.height = [](int column, int row) { return static_cast<float>((column * row * 7) % 13); };
  const TerrainNode& node = build({.file = write("rough.tif", file), .base = 5});
  for (int i = 0; i < 400; ++i) {
    const Vec3d p(60 - i * 0.31, -9 + (i % 37), -40 + i * 0.2), q = p + Vec3d(0.7, -0.4, 0.9);
    EXPECT_LE(std::fabs(field_.value(p) - field_.value(q)), (p - q).length() + 1e-9);
    const auto slab = [](double a, double b) { return Interval(std::min(a, b), std::max(a, b)); };
    const Interval all =
        node.eval(field::Point<Interval>{slab(p.x, q.x), slab(p.y, q.y), slab(p.z, q.z)});
    EXPECT_TRUE(all.lo <= field_.value(p) && field_.value(p) <= all.hi);
    const field::Gradient g = field_.gradient(p);
    EXPECT_LE(g.gradient.length(), 1 + 1e-9);
    const double step = 1e-6;
    EXPECT_NEAR((field_.value(p + Vec3d(0, step, 0)) - g.value) / step, g.gradient.y, 1e-3);
  }
}

}  // namespace
}  // namespace vug::terrain
