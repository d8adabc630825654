// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/survey/coordinate_system.h>
#include <vug/survey/dates.h>
#include <vug/survey/geodesy.h>
#include <vug/survey/geomagnetism.h>
#include <vug/survey/system_properties.h>

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace vug::survey {
namespace {

bool proj_is_loaded() { return dlopen("libproj.so.25", RTLD_LAZY | RTLD_NOLOAD) != nullptr; }

// The death test runs in a process of its own, in which no other test has used PROJ.
TEST(GeodesyDeathTest, ProjIsLoadedByTheFirstTransformation) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(
      {
        Geodesy geodesy;
        geodesy.transform("EPSG:27700", "EPSG:27700", {1, 2, 3});
        const bool early = proj_is_loaded();
        geodesy.transform("UTM30N", "long-lat", {500000, 5538630, 0});
        std::exit(!early && proj_is_loaded() ? 0 : 1);
      },
      testing::ExitedWithCode(0), "");
}

TEST(Geodesy, EqualSystemsKeepCoordinates) {
  EXPECT_EQ(Geodesy().transform("EPSG:27700", "EPSG:27700", {1, 2, 3}), Vec3d(1, 2, 3));
}

constexpr double kDegree = kPi / 180;

TEST(Geodesy, SquaresOfTheBritishGrid) {
  const auto corner = [](const char* name) { return coordinate_system(name).value().origin; };
  EXPECT_EQ(corner("OSGB:SV"), Vec3d(0, 0, 0));
  EXPECT_EQ(corner("OSGB:SD"), Vec3d(300000, 400000, 0));
  EXPECT_EQ(corner("osgb:tq"), Vec3d(500000, 100000, 0));
  EXPECT_EQ(corner("OSGB:HY"), Vec3d(300000, 1000000, 0));
  EXPECT_EQ(corner("OSGB:NN"), Vec3d(200000, 700000, 0));
  EXPECT_FALSE(coordinate_system("OSGB:SI"));
  EXPECT_FALSE(coordinate_system("OSGB:S"));
}

TEST(Geodesy, NamesOfSystems) {
  EXPECT_EQ(coordinate_system("UTM30N").value().definition, "EPSG:32630");
  EXPECT_EQ(coordinate_system("utm5s").value().definition, "EPSG:32705");
  EXPECT_EQ(coordinate_system("UTM60").value().definition, "EPSG:32660");
  for (const char* name :
       {"UTM0", "UTM61", "UTM", "UTMN", "EPSG:", "EPSG:x", "EPSG:123456789", "nowhere", ""})
    EXPECT_FALSE(coordinate_system(name)) << name;
  Geodesy geodesy;
  for (const char* name :
       {"EUR79Z30", "iJTSK", "iJTSK03", "JTSK", "JTSK03", "S-MERC", "long-lat", "ESRI:102014"})
    EXPECT_EQ(geodesy.fault_of(name), "") << name;
  EXPECT_EQ(geodesy.fault_of("EPSG:1"), "PROJ does not know the coordinate system 'EPSG:1'");
}

TEST(Geodesy, TransformsAndKeepsHeights) {
  Geodesy geodesy;
  const Vec3d plane = geodesy.transform("long-lat", "UTM30N", {-3, 50, 123});
  EXPECT_NEAR(plane.x, 500000, 1e-3);  // The central meridian.
  EXPECT_NEAR(plane.y, 5538630.703, 1e-2);
  EXPECT_NEAR(plane.z, 123, 1e-9);
  const Vec3d back = geodesy.transform("UTM30N", "long-lat", plane);
  EXPECT_NEAR(back.x, -3, 1e-9);
  EXPECT_NEAR(back.y, 50, 1e-9);
  EXPECT_EQ(geodesy.transform("OSGB:SD", "EPSG:27700", {97480, 72608, 225}),
            Vec3d(397480, 472608, 225));
  EXPECT_THROW(geodesy.transform("local", "UTM30N", Vec3d(0)), Error);
  EXPECT_THROW(geodesy.transform("UTM30N", "long-lat", Vec3d(1e30)), Error);
}

// The grid of the British system is not part of PROJ's own data.
TEST(Geodesy, MissingGridsAreFoundForAllNamesOfASystem) {
  const auto grid = missing_grid("EPSG:4326", "EPSG:27700");
  for (const char* name : {"+proj=longlat +datum=WGS84", "+proj=longlat +datum=WGS84 +type=crs",
                           "+proj=utm +zone=30 +datum=WGS84 +no_defs", "UTM30N"})
    EXPECT_EQ(missing_grid(name, "EPSG:27700"), grid) << name;
  EXPECT_EQ(missing_grid("+proj=utm +zone=30 +datum=WGS84", "UTM31N"), std::nullopt);
  EXPECT_EQ(missing_grid("local", "UTM31N"), std::nullopt);
  if (!grid) GTEST_SKIP() << "the grid is installed";
  EXPECT_NE(grid->find("OSTN15"), std::string::npos) << *grid;
}

TEST(Geodesy, TrueNorthOnTheGrid) {
  Geodesy geodesy;
  EXPECT_NEAR(geodesy.true_north("UTM30N", {-3, 50, 0}), 0, 1e-9);
  // The convergence of a transverse Mercator grid is about the longitude times sin(latitude).
  EXPECT_NEAR(geodesy.true_north("UTM30N", {-2, 50, 0}) / kDegree,
              -maths::atan2(maths::tan(kDegree) * maths::sin(50 * kDegree), 1) / kDegree, 1e-3);
}

TEST(Geodesy, CompoundSystemsHaveTheNorthOfTheirHorizontalPart) {
  Geodesy geodesy;
  const Geographic place{-2.04008, 54.14929, 225};
  const double plane = geodesy.true_north("EPSG:27700", place);
  EXPECT_NEAR(geodesy.true_north("EPSG:7405", place), plane, 1e-12);
  // 0.04 degrees west of the central meridian of the grid.
  EXPECT_NEAR(plane / kDegree, 0.04008 * maths::sin(54.14929 * kDegree), 5e-4);
}

TEST(Geomagnetism, DeclinationsOfCavern) {
  // cavern 1.4.4 (IGRF-13, equal to IGRF-14 until 2015), from legs of 100 km to magnetic north.
  const Geographic place{-2.04008, 54.14929, 225};
  const std::pair<int, double> expected[] = {{day_number(1982, 2, 7), -7.1391},
                                             {day_number(1991, 9, 6), -5.7873},
                                             {day_number(2005, 2, 4), -3.6492},
                                             {day_number(2015, 10, 3), -1.8117}};
  for (const auto& [day, degrees] : expected)
    EXPECT_NEAR(magnetic_declination(place, year_of(day)) / kDegree, degrees, 5e-4) << day;
}

TEST(Geomagnetism, TheFieldOfADateIsContinuous) {
  for (const double year : {1905.0, 1995.0, 2000.0, 2025.0, 2029.999}) {
    const Geographic place{14.5, 46.0, 500};
    EXPECT_NEAR(magnetic_declination(place, year), magnetic_declination(place, year - 1e-6), 1e-6);
  }
  EXPECT_THROW(magnetic_field({0, 0, 0}, 1899.9), Error);
  EXPECT_THROW(magnetic_field({0, 0, 0}, 2030.1), Error);
  EXPECT_THROW(magnetic_field({0, 0, 0}, NAN), Error);
}

TEST(Geomagnetism, TheFieldIsTheGradientOfAPotential) {
  // Without currents, the curl of the field is 0: the change of the north component along the
  // meridian and of the vertical component must agree over a small square.
  const double step = 1e-3, metres = 6371200 * step * kDegree;
  const auto field = [](double latitude, double height) {
    return magnetic_field({20, latitude, height}, 2020);
  };
  const double down = (field(10 + step, 0).z - field(10 - step, 0).z) / (2 * metres);
  const double north = (field(10, metres).x - field(10, -metres).x) / (2 * metres);
  const double radius = 6378137 * 0.9999;
  // nT per metre; the sphere differs from the ellipsoid by less than 1 percent.
  EXPECT_NEAR(down, -north - field(10, 0).x / radius, 1.5e-4);
}

TEST(Geomagnetism, StrengthOfTheField) {
  // The total field is between 22,000 nT (South Atlantic) and 67,000 nT (Siberia, Antarctica).
  double least = 1e9, most = 0;
  for (double latitude = -85; latitude <= 85; latitude += 5)
    for (double longitude = -180; longitude < 180; longitude += 5) {
      const double strength = magnetic_field({longitude, latitude, 0}, 2020).length();
      least = std::min(least, strength);
      most = std::max(most, strength);
    }
  EXPECT_NEAR(least, 22200, 300);
  EXPECT_NEAR(most, 66900, 400);
}

}  // namespace
}  // namespace vug::survey
