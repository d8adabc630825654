// SPDX-License-Identifier: Apache-2.0
// Reading of elevations with GDAL: places, bands, units, cells without data and damaged files.
#include "geotiff.h"

#include <vug/base/error.h>
#include <vug/base/rng.h>
#include <vug/base/scratch_folder.h>
#include <vug/terrain/elevation_file.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::terrain {
namespace {

class ElevationFiles : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& content) {
    std::ofstream(folder_.path() / name, std::ios::binary) << content;
    return folder_.path() / name;
  }
  std::string fault_of(const std::filesystem::path& file, int band = 0) {
    try {
      const ElevationFile opened(file, band);
      opened.heights({0, 0, opened.columns(), opened.rows()});
    } catch (const Error& error) {
      EXPECT_NE(error.code(), ErrorCode::internal);
      EXPECT_NE(std::string(error.what()).find(file.filename().string()), std::string::npos);
      return error.what();
    }
    return "";
  }

  ScratchFolder folder_{"vug_terrain"};
};

const std::string kGrid =
    "ncols 3\nnrows 2\nxllcorner 100\nyllcorner 200\ncellsize 10\n"
    "NODATA_value -9999\n1 2 3\n4 -9999 6.5\n";

TEST_F(ElevationFiles, AsciiGridsHaveThePlacesOfTheirCells) {
  const ElevationFile file(write("small.asc", kGrid));
  EXPECT_EQ(file.columns(), 3);
  EXPECT_EQ(file.rows(), 2);
  EXPECT_EQ(file.system(), "");
  EXPECT_EQ(file.transform().place(0.5, 0.5), Vec3d(105, 215, 0));
  EXPECT_EQ(file.transform().cell(Vec3d(125, 205, 0)), Vec3d(2.5, 1.5, 0));
  const std::vector<float> heights = file.heights({0, 0, 3, 2});
  EXPECT_EQ(heights[2], 3);
  EXPECT_EQ(heights[5], 6.5f);
  EXPECT_TRUE(std::isnan(heights[4]));
  EXPECT_EQ(file.heights({2, 1, 1, 1}), std::vector<float>{6.5f});
}

TEST_F(ElevationFiles, GeoTiffsStateTheirSystem) {
  const GeoTiff tiff{.columns = 4, .rows = 3, .epsg = 32633, .height = [](int column, int row) {
                       return static_cast<float>(column + 10 * row);
                     }};
  const ElevationFile file(write("a.tif", tiff.bytes()));
  EXPECT_NE(file.system().find("32633"), std::string::npos);
  EXPECT_EQ(file.heights({1, 1, 2, 2}), (std::vector<float>{11, 12, 21, 22}));
}

TEST_F(ElevationFiles, OneOfSeveralBandsMustBeChosen) {
  const GeoTiff tiff{.bands = 3};
  const std::filesystem::path file = write("bands.tif", tiff.bytes());
  EXPECT_NE(fault_of(file).find("has 3 bands"), std::string::npos);
  EXPECT_NE(fault_of(file, 4).find("no band 4"), std::string::npos);
  EXPECT_EQ(ElevationFile(file, 2).heights({0, 0, 1, 1}), std::vector<float>{1000});
}

TEST_F(ElevationFiles, ReportsFilesThatAreNotTerrain) {
  EXPECT_NE(fault_of(folder_.path() / "none.tif").find("does not exist"), std::string::npos);
  EXPECT_NE(fault_of(write("text.tif", "hello")).find("not a file of elevations"),
            std::string::npos);
  EXPECT_NE(
      fault_of(write("plain.tif", GeoTiff{.transform = {}}.bytes())).find("place on the ground"),
      std::string::npos);
  // GDAL crashes when it reads heights from a list of points with such a coordinate.
  EXPECT_NE(fault_of(write("points.xyz", "x y z\n0 10 1\n11 10 2\n1 \nnan1010 4\t20 0"))
                .find("not a file of elevations"),
            std::string::npos);
  GeoTiff flat;
  flat.transform = {0, 1, 1, 0, 1, 1};
  EXPECT_NE(fault_of(write("flat.tif", flat.bytes())).find("cells without area"),
            std::string::npos);
  std::string negative = kGrid;
  negative.replace(negative.find("cellsize 10"), 11, "cellsize -5");
  EXPECT_NE(fault_of(write("negative.asc", negative)).find("has a cell size of -5"),
            std::string::npos);
  const GeoTiff deep{.height = [](int, int) { return -3.4e38f; }};
  EXPECT_NE(fault_of(write("deep.tif", deep.bytes())).find("at column 1, row 1"),
            std::string::npos);
  const GeoTiff whole{.columns = 20, .rows = 20};
  const std::string bytes = whole.bytes();
  EXPECT_NE(fault_of(write("cut.tif", bytes.substr(0, bytes.size() - 300))), "");
}

/// Replaces the value of an entry of a GeoTiff that is a single number of 32 bits.
void set_entry(std::string& tiff, uint16_t tag, uint32_t value) {
  const auto raw = [](const auto& number) {
    return std::string(reinterpret_cast<const char*>(&number), sizeof(number));
  };
  const size_t at = tiff.find(raw(tag) + raw(uint16_t{4}) + raw(uint32_t{1}));
  ASSERT_NE(at, std::string::npos);
  tiff.replace(at + 8, 4, raw(value));
}

TEST_F(ElevationFiles, SmallFilesCannotCauseLargeAllocations) {
  std::string tiff = GeoTiff{.columns = 4, .rows = 4}.bytes();
  constexpr uint16_t kColumns = 256;
  set_entry(tiff, kColumns, 1000000000);  // GDAL would read at least a row.
  EXPECT_NE(fault_of(write("huge.tif", tiff)).find("states blocks of 1000000000 x"),
            std::string::npos);
  set_entry(tiff, kColumns, 2000);
  EXPECT_EQ(fault_of(write("wide.tif", tiff)).find("states blocks"), std::string::npos);
}

TEST_F(ElevationFiles, DamagedFilesAreReadOrReported) {
  GeoTiff tiff{.columns = 6, .rows = 5, .epsg = 32633, .missing = "-9999"};
  const std::string whole[] = {tiff.bytes(), kGrid};
  RandomStream random(RandomKey(5));
  for (int i = 0; i < 300; ++i) {
    std::string damaged = whole[i % 2];
    for (int k = 0; k < 1 + i % 5; ++k)
      damaged[random.below(static_cast<uint32_t>(damaged.size()))] =
          static_cast<char>(random.below(256));
    if (i % 7 == 0) damaged.resize(damaged.size() / 2);
    fault_of(write(i % 2 ? "damaged.asc" : "damaged.tif", damaged));
  }
}

}  // namespace
}  // namespace vug::terrain
