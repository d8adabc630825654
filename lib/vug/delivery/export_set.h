// All that another program is given, in files.
#pragma once

#include <vug/building/builder.h>
#include <vug/exchange/program.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vug::delivery {

struct ExportOptions {
  const exchange::Program* program = nullptr;  ///< Whom it is for.
  std::optional<exchange::UpAxis> up;          ///< Instead of the program's.
  std::optional<double> metres_per_unit;       ///< Likewise.
  int levels = 0;  ///< Of detail beside the whole: each a quarter as many triangles.
};

/// The files that export_set writes, with all levels of detail that are asked for.
std::vector<std::filesystem::path> export_paths(const shot::Shot& shot,
                                                const std::filesystem::path& folder,
                                                const ExportOptions& options);

/// Writes into `folder`, each file whole or not at all, where NAME is the shot's: NAME.glb or what
/// else the program reads; a file NAME_VOLUME.vdb for each volume, and NAME_MEDIUM_medium.vdb of a
/// cloud that is in a file (see export_volume.h); of cells NAME_CELLS_points and, where the scene
/// asks for them, the grids of what they carry in NAME_CELLS_grids.vdb; levels of detail in
/// NAME_lod1.glb and so on, in variants (USD), as many as are of use. The builder's shot is one of
/// with_meshes.
struct ExportResult : exchange::WriteReport {
  std::vector<std::string>
      levels;  ///< In sentences, how far each level is off, and which is the last.
};
ExportResult export_set(building::Builder& builder, const std::filesystem::path& folder,
                        const ExportOptions& options);

}  // namespace vug::delivery
