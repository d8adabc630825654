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
  std::string hint_of(const TerrainOptions& options) {
    try {
      terrain(options);
    } catch (const Error& error) {
      return error.hint();
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

/// The whole Earth in cells of a quarter of a degree, from a longitude to the east.
GeoTiff earth(double west) {
  return {.columns = 1440,
          .rows = 720,
          .epsg = 4326,
          .geographic = true,
          .transform = std::array<double, 6>{west, 0.25, 0, 90, 0, -0.25},
          .height = [](int column, int row) { return static_cast<float>(column + 2 * row); }};
}

TEST_F(Terrains, FilesOfTheWholeEarthAreCutAroundTheNetwork) {
  for (const double west : {-180.0, 0.0}) {
    const std::filesystem::path file = write("earth.tif", earth(west));
    const auto network = network_at({kKnown[0].utm, kKnown[2].utm}, "UTM33N");
    const TerrainNode& node = build({.file = file, .around = network, .margin = 100});
    EXPECT_LT(field_.bounds().size().x, 700);
    const double height = (14.2 - west) / 0.25 - 0.5 + 2 * ((90 - 45.5) / 0.25 - 0.5);
    EXPECT_NEAR(height_at(node, *network, kKnown[0].utm), height, 0.01) << west;
    // The west of Greenwich, whose longitudes are 350 to 360 in one of the files.
    const Vec3d lisbon(487500, 4285000, 0);  // UTM29N; 38.71 N 9.14 W
    const auto far = network_at({lisbon}, "UTM29N");
    const double there = std::fmod(360 - 9.144 - west, 360) / 0.25 + 2 * (90 - 38.713) / 0.25 - 1.5;
    EXPECT_NEAR(height_at(build({.file = file, .around = far}), *far, lisbon), there, 0.1) << west;
    EXPECT_NE(fault_of({.file = file}).find("too much of the Earth"), std::string::npos);
  }
  // Both sides of the meridian at which the file ends.
  const auto fiji = network_at({{819000, 8130000, 0}, {822000, 8130000, 0}}, "UTM60S");
  const std::string fault =
      fault_of({.file = write("earth.tif", earth(-180)), .around = fiji, .margin = 5000});
  EXPECT_NE(fault.find("ends at a meridian"), std::string::npos) << fault;
  EXPECT_EQ(fault_of({.file = write("earth.tif", earth(0)), .around = fiji, .margin = 5000}), "");
}

TEST_F(Terrains, DegreesWithoutASystemAreReported) {
  GeoTiff file{.columns = 50,
               .rows = 50,
               .transform = std::array<double, 6>{14.19, 4e-4, 0, 45.51, 0, -4e-4}};
  const std::vector<TerrainWarning> warnings =
      build({.file = write("degrees.tif", file)}).source().warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].message.find("look like degrees"), std::string::npos);
  EXPECT_NE(warnings[0].hint.find("EPSG:4326"), std::string::npos);
  const auto network = network_at({kKnown[0].utm}, "UTM33N");
  try {
    terrain({.file = folder_.file("degrees.tif"), .around = network});
    ADD_FAILURE() << "expected an error";
  } catch (const Error& error) {
    EXPECT_NE(error.hint().find("EPSG:4326"), std::string::npos) << error.hint();
  }
  EXPECT_TRUE(build({.file = folder_.file("degrees.tif"), .system = "EPSG:4326"})
                  .source()
                  .warnings.empty());
  // A scan in metres.
  file.transform = std::array<double, 6>{0, 0.5, 0, 20, 0, -0.5};
  EXPECT_TRUE(build({.file = write("metres.tif", file)}).source().warnings.empty());
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
  EXPECT_NE(hint_of({.file = file, .around = far}).find("omit 'around'"), std::string::npos)
      << "the network is not from a file";
  auto surveyed = *far;
  surveyed.files = {"cave.svx"};
  EXPECT_NE(hint_of({.file = file, .around = std::make_shared<network::Network>(surveyed)})
                .find("compare the coordinate systems"),
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
    const double lipschitz = field_.lipschitz();
    EXPECT_LE(std::fabs(field_.value(p) - field_.value(q)), lipschitz * (p - q).length() + 1e-9);
    const auto slab = [](double a, double b) { return Interval(std::min(a, b), std::max(a, b)); };
    const Interval all =
        node.eval(field::Point<Interval>{slab(p.x, q.x), slab(p.y, q.y), slab(p.z, q.z)});
    EXPECT_TRUE(all.lo <= field_.value(p) && field_.value(p) <= all.hi);
    const field::Gradient g = field_.gradient(p);
    EXPECT_LE(g.gradient.length(), lipschitz + 1e-9);
    const double step = 1e-6;
    EXPECT_NEAR((field_.value(p + Vec3d(0, step, 0)) - g.value) / step, g.gradient.y, 1e-3);
  }
}

// Noise moves level ground and slopes by its amount, even if there is a cliff somewhere else.
TEST_F(Terrains, ACliffDoesNotStretchDisplacements) {
  GeoTiff file = plane_file();
  file.columns = file.rows = 40;
  file.epsg = 0;
  // Level ground in the west, a slope of 45 degrees in the middle, a peak in the east.
  file.height = [](int column, int row) {
    if (column == 35 && row == 35) return 900.0f;
    return 10.0f * static_cast<float>(std::clamp(column, 10, 20));
  };
  const TerrainNode& node = build({.file = write("cliff.tif", file)});
  EXPECT_GT(field_.lipschitz(), 20);
  for (const double x : {-160.0, -45.0})
    for (const double above : {-3.0, -0.1, 0.2, 2.0}) {
      const double ground = node.source().height(x, 35), cosine = x < -100 ? 1 : std::sqrt(0.5);
      EXPECT_NEAR(field_.value({x, ground + above, 35}), above * cosine, 1e-3) << x;
      EXPECT_NEAR(field_.gradient({x, ground + above, 35}).gradient.length(), 1, 1e-3) << x;
    }
  // Far above and next to the block, the value is at least its growth times the distance.
  for (const Vec3d& p : {Vec3d(0, 500, 0), Vec3d(400, -200, 0), Vec3d(500, 400, -700)}) {
    const Box3d box = field_.bounds();
    const Vec3d in(std::clamp(p.x, box.min.x, box.max.x), std::clamp(p.y, box.min.y, box.max.y),
                   std::clamp(p.z, box.min.z, box.max.z));
    EXPECT_GE(field_.value(p), field_.node()->traits().growth_rate() * (p - in).length() - 1e-9);
  }
}

}  // namespace
}  // namespace vug::terrain
