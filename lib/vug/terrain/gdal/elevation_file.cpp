// SPDX-License-Identifier: Apache-2.0
// Files of elevations, read by GDAL; the only callers of its functions.
#include <vug/terrain/elevation_file.h>

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/memory.h>
#include <vug/terrain/gdal/library.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace vug::terrain {
namespace {

/// The formats that are tried: rasters in local files. Formats that refer to servers or to other
/// files (VRT, WMS, ...) are left out, so that a file cannot cause access to the network, and XYZ,
/// because GDAL 3.6 crashes on damaged lists of points.
constexpr const char* const kDrivers[] = {"GTiff",       "AAIGrid", "GRASSASCIIGrid",
                                          "SRTMHGT",     "DTED",    "USGSDEM",
                                          "EHdr",        "ENVI",    "HFA",
                                          "AIG",         "GSAG",    "GSBG",
                                          "GS7BG",       "BT",      "SAGA",
                                          "RST",         "ERS",     "ISG",
                                          "GTX",         "ZMap",    "netCDF",
                                          "HDF5Image",   "GRIB",    "GPKG",
                                          "JP2OpenJPEG", nullptr};

/// Heights beyond this are marks for missing data that the file does not declare.
constexpr double kHighest = 3e4;

/// GDAL holds whole blocks of cells in memory. Larger ones than this must not exceed the file by
/// more than a factor that no compression reaches, so that a damaged file of some bytes cannot
/// cause an allocation of gigabytes.
constexpr double kLargeBlock = 64 << 20;  // Bytes.
constexpr double kMostCompressed = 4096;

/// Keeps GDAL from printing; its last message becomes part of our errors.
class Quiet {
 public:
  Quiet() {
    gdal::library().PushErrorHandler(gdal::library().QuietErrorHandler);
    gdal::library().ErrorReset();
  }
  ~Quiet() { gdal::library().PopErrorHandler(); }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

  static std::string reason() {
    const std::string message = gdal::library().GetLastErrorMsg();
    return message.empty() ? "" : fmt::format(" (GDAL: {})", message.substr(0, 200));
  }
};

Error fault(const std::filesystem::path& file, const std::string& what, const std::string& hint) {
  return Error(ErrorCode::bad_input, fmt::format("'{}' {}", file.string(), what), {}, hint);
}

/// Metres of a unit of heights as GDAL names it.
double metres_of(const std::string& unit, const std::filesystem::path& file) {
  for (const char* metre :
       {"", "m", "metre", "meter", "metres", "meters", "Meter", "Metre", "METERS"})
    if (unit == metre) return 1;
  for (const char* foot : {"ft", "foot", "feet", "Foot", "international foot", "Feet"})
    if (unit == foot) return 0.3048;
  for (const char* foot : {"US survey foot", "Foot_US", "sft", "us-ft", "ftUS"})
    if (unit == foot) return 1200.0 / 3937;
  throw fault(file, fmt::format("states its heights in '{}'", unit),
              "convert them to metres or feet, e.g. with gdal_calc.py");
}

}  // namespace

Vec3d GeoTransform::place(double column, double row) const {
  return {c[0] + c[1] * column + c[2] * row, c[3] + c[4] * column + c[5] * row, 0};
}

Vec3d GeoTransform::cell(const Vec3d& place) const {
  const double x = place.x - c[0], y = place.y - c[3], d = determinant();
  return {(c[5] * x - c[2] * y) / d, (c[1] * y - c[4] * x) / d, 0};
}

struct ElevationFile::Dataset {
  gdal::DatasetHandle handle = nullptr;
  gdal::BandHandle band = nullptr;
  std::optional<double> missing;  ///< The stored value of cells without data.
  double scale = 1, offset = 0;   ///< From stored values to metres.

  Dataset() = default;
  Dataset(const Dataset&) = delete;
  Dataset& operator=(const Dataset&) = delete;
  ~Dataset() {
    const Quiet quiet;
    if (handle) gdal::library().Close(handle);
  }

  void choose_band(const std::filesystem::path& file, int wanted) {
    const gdal::Library& gdal = gdal::library();
    const int count = gdal.GetRasterCount(handle);
    if (count < 1) throw fault(file, "contains no raster", "name a file of elevations");
    if (wanted > count)
      throw fault(file,
                  fmt::format("has {} {}, so it has no band {}", count,
                              count == 1 ? "band" : "bands", wanted),
                  "bands count from 1");
    if (wanted == 0 && count > 1)
      throw fault(file, fmt::format("has {} bands, and one of them must be the heights", count),
                  "choose it, e.g. band: 1");
    band = gdal.GetRasterBand(handle, std::max(wanted, 1));
    const int type = band ? gdal.GetRasterDataType(band) : 0;
    if (type < 1 || (type >= gdal::kFirstComplex && type <= gdal::kLastComplex))
      throw fault(file, "has values that are not real numbers",
                  "convert it, e.g. gdal_translate -ot Float32");
    require_plausible_blocks(file);
    int exists = 0;
    const double value = gdal.GetRasterNoDataValue(band, &exists);
    if (exists) missing = value;
    const double factor = gdal.GetRasterScale(band, &exists);
    if (exists) scale = factor;
    const double added = gdal.GetRasterOffset(band, &exists);
    if (exists) offset = added;
    const char* const unit = gdal.GetRasterUnitType(band);
    const double metres = metres_of(unit ? unit : "", file);
    scale *= metres;
    offset *= metres;
  }

  void require_plausible_blocks(const std::filesystem::path& file) const {
    int columns = 0, rows = 0;
    gdal::library().GetBlockSize(band, &columns, &rows);
    const double bytes = 8.0 * columns * rows;
    const auto size = static_cast<double>(std::filesystem::file_size(file));
    if (bytes > kLargeBlock && bytes > kMostCompressed * size)
      throw fault(
          file,
          fmt::format("states blocks of {} x {} cells, but has {:.0f} bytes", columns, rows, size),
          "the file is damaged or incomplete; get it again");
  }

  bool is_missing(double stored) const {
    return !std::isfinite(stored) ||
           (missing &&
            (stored == *missing || static_cast<float>(stored) == static_cast<float>(*missing)));
  }
};

ElevationFile::ElevationFile(std::filesystem::path file, int band)
    : path_(std::move(file)), dataset_(std::make_unique<Dataset>()) {
  std::error_code ignored;
  // Names of servers and databases, which GDAL would open as well, are not files.
  if (!std::filesystem::is_regular_file(path_, ignored))
    throw Error(ErrorCode::bad_input, fmt::format("the file '{}' does not exist", path_.string()),
                {}, "a relative path starts at the folder of the scene");
  const gdal::Library& gdal = gdal::library();
  const Quiet quiet;
  dataset_->handle =
      gdal.OpenEx(std::filesystem::absolute(path_).c_str(),
                  gdal::kOpenRaster | gdal::kVerboseErrors, kDrivers, nullptr, nullptr);
  if (!dataset_->handle)
    throw fault(path_, "is not a file of elevations" + Quiet::reason(),
                "GeoTIFF, ASC, HGT, DTED and other rasters with a place on the ground are read");
  dataset_->choose_band(path_, band);
  columns_ = gdal.GetRasterXSize(dataset_->handle);
  rows_ = gdal.GetRasterYSize(dataset_->handle);
  if (columns_ < 2 || rows_ < 2)
    throw fault(path_, fmt::format("has {} x {} cells", columns_, rows_),
                "a terrain needs at least 2 x 2 cells");
  const bool has_place =
      gdal.GetGeoTransform(dataset_->handle, transform_.c.data()) == gdal::kNoError;
  if (!has_place)
    throw fault(
        path_, "does not state its place on the ground",
        "add it with gdal_translate -a_ullr, or use heightfield(file:, size:) for a picture");
  for (const double number : transform_.c)
    if (!std::isfinite(number) || std::fabs(number) > 1e9)
      throw fault(path_, "has a georeference that is not finite", "repair it with gdal_edit.py");
  if (!(std::fabs(transform_.determinant()) > 1e-20))
    throw fault(path_, "has cells without area", "repair its georeference with gdal_edit.py");
  // GDAL reads a negative cell size of an ASC file as a grid that is turned by 180 degrees.
  if (extension_of(path_) == ".asc" && transform_.c[1] < 0)
    throw fault(path_, fmt::format("has a cell size of {:g}", transform_.c[1]),
                "write a positive 'cellsize'");
  if (const char* const text = gdal.GetProjectionRef(dataset_->handle)) system_ = text;
}

ElevationFile::~ElevationFile() = default;

std::vector<float> ElevationFile::heights(const Window& window) const {
  const auto columns = static_cast<size_t>(window.columns), rows = static_cast<size_t>(window.rows);
  require_memory(static_cast<double>(columns) * static_cast<double>(rows) * 2 * sizeof(float),
                 available_memory() / 10 * 9, fmt::format("'{}'", path_.string()),
                 "use 'around' and a smaller 'margin', or a file with fewer cells");
  std::vector<float> out(columns * rows);
  std::vector<double> line(columns);
  const Quiet quiet;
  for (size_t j = 0; j < rows; ++j) {
    const int row = window.row + static_cast<int>(j);
    if (gdal::library().RasterIO(dataset_->band, gdal::kRead, window.column, row, window.columns, 1,
                                 line.data(), window.columns, 1, gdal::kFloat64, 0,
                                 0) != gdal::kNoError)
      throw fault(path_, fmt::format("cannot be read at row {}{}", row + 1, Quiet::reason()),
                  "the file is damaged or incomplete; get it again");
    for (size_t i = 0; i < columns; ++i) {
      const double height = line[i] * dataset_->scale + dataset_->offset;
      const bool missing = dataset_->is_missing(line[i]);
      if (!missing && !(std::fabs(height) < kHighest))
        throw fault(path_,
                    fmt::format("has a height of {:.6g} m at column {}, row {}", height,
                                window.column + static_cast<int>(i) + 1, row + 1),
                    "if this marks missing data, declare it: gdal_edit.py -a_nodata");
      out[j * columns + i] =
          missing ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(height);
    }
  }
  return out;
}

}  // namespace vug::terrain
