// SPDX-License-Identifier: Apache-2.0
// Exports a shot as a set of files for another program.
#pragma once

#include <vug/building/builder.h>
#include <vug/exchange/program.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vug::delivery {

/// The same scene with other parameters. The name of its shot, which is that of its files, differs
/// from that of the others.
struct ExportVariant {
  std::string name;
  building::Builder* builder;
};

struct ExportOptions {
  const exchange::Program* program = nullptr;  ///< The target program.
  std::optional<exchange::UpAxis> up;          ///< Overrides the program's up axis.
  std::optional<double> metres_per_unit;       ///< Overrides the program's unit.
  int levels = 0;  ///< Additional levels of detail, each with a quarter of the triangles.
  std::vector<ExportVariant> variants = {};  ///< Only for programs whose formats have variants.
};

/// Whether all formats of the program can contain variants.
bool has_variants(const exchange::Program& program);

/// The files that export_set writes, with all requested levels of detail.
std::vector<std::filesystem::path> export_paths(const shot::Shot& shot,
                                                const std::filesystem::path& folder,
                                                const ExportOptions& options);

/// The written files and messages about them.
struct ExportResult : exchange::WriteReport {
  std::vector<std::string>
      levels;  ///< Sentences about the error of each level and the last useful level.
};
/// Writes these files into `folder`, each file completely or not at all; NAME is the shot's name:
/// NAME.glb or the program's other formats; NAME_VOLUME.vdb for each volume; NAME_MEDIUM_medium.vdb
/// for a cloud from a file (see export_volume.h); NAME_CELLS_points for cells and, if requested by
/// the scene, the grids of their attributes in NAME_CELLS_grids.vdb; levels of detail in
/// NAME_lod1.glb and so on, or as variants (USD), as many as are useful. Variants are in the same
/// NAME.usda; their volumes and cells have files of their own. The shots of all builders must come
/// from with_meshes.
ExportResult export_set(building::Builder& builder, const std::filesystem::path& folder,
                        const ExportOptions& options);

}  // namespace vug::delivery
