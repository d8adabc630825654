// SPDX-License-Identifier: Apache-2.0
// Internal to terrain/: the functions of GDAL's C interface that read elevations [@gdal2022]. They
// are declared here and found in the shared library on first use
// (docs/explanation/decisions/0036-gdal-on-first-use.md).
#pragma once

namespace vug::terrain::gdal {

/// GDAL's opaque handles, and its values of the enumerations that are used here.
using DatasetHandle = void*;
using BandHandle = void*;
using ErrorHandler = void (*)(int severity, int number, const char* message);
inline constexpr int kNoError = 0;                ///< CE_None
inline constexpr int kRead = 0;                   ///< GF_Read
inline constexpr int kFloat64 = 7;                ///< GDT_Float64
inline constexpr int kFirstComplex = 8;           ///< GDT_CInt16
inline constexpr int kLastComplex = 11;           ///< GDT_CFloat64
inline constexpr unsigned kOpenRaster = 0x02;     ///< GDAL_OF_RASTER, read-only
inline constexpr unsigned kVerboseErrors = 0x40;  ///< GDAL_OF_VERBOSE_ERROR

/// The functions, named as in GDAL without their prefix.
struct Library {
  void (*AllRegister)();
  DatasetHandle (*OpenEx)(const char* file, unsigned flags, const char* const* drivers,
                          const char* const* options, const char* const* siblings);
  void (*Close)(DatasetHandle);
  int (*GetRasterXSize)(DatasetHandle);
  int (*GetRasterYSize)(DatasetHandle);
  int (*GetRasterCount)(DatasetHandle);
  const char* (*GetProjectionRef)(DatasetHandle);
  int (*GetGeoTransform)(DatasetHandle, double* six);
  BandHandle (*GetRasterBand)(DatasetHandle, int band);
  int (*GetRasterDataType)(BandHandle);
  void (*GetBlockSize)(BandHandle, int* columns, int* rows);
  double (*GetRasterNoDataValue)(BandHandle, int* exists);
  double (*GetRasterScale)(BandHandle, int* exists);
  double (*GetRasterOffset)(BandHandle, int* exists);
  const char* (*GetRasterUnitType)(BandHandle);
  int (*RasterIO)(BandHandle, int direction, int column, int row, int columns, int rows, void* data,
                  int data_columns, int data_rows, int type, int pixel_space, int line_space);
  void (*SetThreadLocalConfigOption)(const char* key, const char* value);
  void (*PushErrorHandler)(ErrorHandler);
  void (*PopErrorHandler)();
  ErrorHandler QuietErrorHandler;
  void (*ErrorReset)();
  const char* (*GetLastErrorMsg)();
};

/// Loads GDAL on first use, for the rest of the process; thread-safe. Throws Error(io) if it is
/// missing.
const Library& library();

}  // namespace vug::terrain::gdal
