// SPDX-License-Identifier: Apache-2.0
#include <vug/terrain/gdal/library.h>

#include <dlfcn.h>
#include <fmt/format.h>
#include <vug/base/error.h>

#include <string>

namespace vug::terrain::gdal {
namespace {

/// Debian 12's, which OpenImageIO needs anyway, and that of other systems with GDAL's headers. The
/// C interface is the same in all versions since 2.0.
constexpr const char* kNames[] = {"libgdal.so.32", "libgdal.so"};

Error unusable(const std::string& why) {
  return Error(ErrorCode::io, "the library GDAL, which reads terrain, " + why, {},
               "install the Debian package libgdal32, or add the folder of libgdal.so to "
               "LD_LIBRARY_PATH");
}

void* open_library() {
  std::string reason;
  for (const char* name : kNames) {
    if (void* const found = dlopen(name, RTLD_LAZY | RTLD_LOCAL)) return found;
    const char* const why = dlerror();
    if (reason.empty() && why) reason = why;
  }
  throw unusable(fmt::format("cannot be loaded: {}", reason));
}

template <class Function>
void find(void* from, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(from, name));
  if (!function) throw unusable(fmt::format("lacks the function {}", name));
}

Library load() {
  void* const from = open_library();
  Library all{};
  find(from, "GDALAllRegister", all.AllRegister);
  find(from, "GDALOpenEx", all.OpenEx);
  find(from, "GDALClose", all.Close);
  find(from, "GDALGetRasterXSize", all.GetRasterXSize);
  find(from, "GDALGetRasterYSize", all.GetRasterYSize);
  find(from, "GDALGetRasterCount", all.GetRasterCount);
  find(from, "GDALGetProjectionRef", all.GetProjectionRef);
  find(from, "GDALGetGeoTransform", all.GetGeoTransform);
  find(from, "GDALGetRasterBand", all.GetRasterBand);
  find(from, "GDALGetRasterDataType", all.GetRasterDataType);
  find(from, "GDALGetBlockSize", all.GetBlockSize);
  find(from, "GDALGetRasterNoDataValue", all.GetRasterNoDataValue);
  find(from, "GDALGetRasterScale", all.GetRasterScale);
  find(from, "GDALGetRasterOffset", all.GetRasterOffset);
  find(from, "GDALGetRasterUnitType", all.GetRasterUnitType);
  find(from, "GDALRasterIO", all.RasterIO);
  find(from, "CPLSetThreadLocalConfigOption", all.SetThreadLocalConfigOption);
  find(from, "CPLPushErrorHandler", all.PushErrorHandler);
  find(from, "CPLPopErrorHandler", all.PopErrorHandler);
  find(from, "CPLQuietErrorHandler", all.QuietErrorHandler);
  find(from, "CPLErrorReset", all.ErrorReset);
  find(from, "CPLGetLastErrorMsg", all.GetLastErrorMsg);
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
