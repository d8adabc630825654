// SPDX-License-Identifier: Apache-2.0
#include <vug/terrain/gdal/library.h>

#include <vug/base/dynamic_library.h>

namespace vug::terrain::gdal {
namespace {

/// Debian 12's, which OpenImageIO needs anyway, and that of other systems with GDAL's headers. The
/// C interface is the same in all versions since 2.0.
constexpr const char* kNames[] = {"libgdal.so.32", "libgdal.so"};

Library load() {
  const DynamicLibrary from(kNames, "the library GDAL, which reads terrain,",
                            "install the Debian package libgdal32, or add the folder of "
                            "libgdal.so to LD_LIBRARY_PATH");
  Library all{};
  from.find("GDALAllRegister", all.AllRegister);
  from.find("GDALOpenEx", all.OpenEx);
  from.find("GDALClose", all.Close);
  from.find("GDALGetRasterXSize", all.GetRasterXSize);
  from.find("GDALGetRasterYSize", all.GetRasterYSize);
  from.find("GDALGetRasterCount", all.GetRasterCount);
  from.find("GDALGetProjectionRef", all.GetProjectionRef);
  from.find("GDALGetGeoTransform", all.GetGeoTransform);
  from.find("GDALGetRasterBand", all.GetRasterBand);
  from.find("GDALGetRasterDataType", all.GetRasterDataType);
  from.find("GDALGetBlockSize", all.GetBlockSize);
  from.find("GDALGetRasterNoDataValue", all.GetRasterNoDataValue);
  from.find("GDALGetRasterScale", all.GetRasterScale);
  from.find("GDALGetRasterOffset", all.GetRasterOffset);
  from.find("GDALGetRasterUnitType", all.GetRasterUnitType);
  from.find("GDALRasterIO", all.RasterIO);
  from.find("CPLSetThreadLocalConfigOption", all.SetThreadLocalConfigOption);
  from.find("CPLPushErrorHandler", all.PushErrorHandler);
  from.find("CPLPopErrorHandler", all.PopErrorHandler);
  from.find("CPLQuietErrorHandler", all.QuietErrorHandler);
  from.find("CPLErrorReset", all.ErrorReset);
  from.find("CPLGetLastErrorMsg", all.GetLastErrorMsg);
  // Drivers of other vendors in a folder of plugins are not needed for elevations.
  all.SetThreadLocalConfigOption("GDAL_DRIVER_PATH", "disable");
  all.AllRegister();
  all.SetThreadLocalConfigOption("GDAL_DRIVER_PATH", nullptr);
  return all;
}

}  // namespace

const Library& library() {
  static const Library loaded = load();
  return loaded;
}

}  // namespace vug::terrain::gdal
