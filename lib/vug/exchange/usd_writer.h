// SPDX-License-Identifier: Apache-2.0
// Internal to exchange/: writes an assembly into a USD layer.
#pragma once

#include <vug/exchange/format.h>
#include <vug/exchange/names.h>
#include <vug/exchange/trs.h>
#include <vug/exchange/usd_layer.h>
#include <vug/exchange/usd_mesh.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace vug::exchange {

/// Writes a root prim with materials, instances, volumes, cameras and lights.
class UsdWriter {
 public:
  /// Environment maps are named after `file`.
  UsdWriter(const Assembly& assembly, const FormatOptions& options, UsdLayer& out,
            std::filesystem::path file, WriteReport& written);

  void write(Progress& progress);

  /// Opens the root prim. `metadata`: that of the root prim in addition.
  void begin(const UsdPrimMetadata& metadata = {});
  void end();

  using Part = std::function<void()>;  ///< Writes a part of the root prim.
  /// Calls `visit` with each part in a fixed order. `visit` must call each, since later parts refer
  /// to earlier ones.
  void each_part(const std::function<void(const Part&)>& visit, Progress& progress);

  /// Writes the following parts into another layer.
  void write_into(UsdLayer& out) { out_ = &out; }
  /// Whether environment maps are written with the lights, as by default.
  void write_skies(bool writes) { writes_skies_ = writes; }

 private:
  void materials();
  void mesh(size_t part, const std::string& parent, const std::string& name);
  void add(const InstanceGroup& group);
  void add_instances(const InstanceGroup& group, const std::vector<TrsTransform>& places);
  Box3d box_of(const InstanceGroup& group) const;
  void add(const Volume& volume);
  void add(const Light& light);

  const Assembly& assembly_;
  const FormatOptions& options_;
  UsdLayer* out_;
  std::filesystem::path file_;
  WriteReport& written_;
  std::string root_;
  bool writes_skies_ = true;
  UniqueNames names_;
  std::map<size_t, std::string> meshes_;
  std::map<size_t, UsdMaterials> materials_;
};

/// Writes a layer of the assembly with the variants of the options, in the format of the file's
/// extension.
WriteReport write_usd_assembly(const Assembly& assembly, const std::filesystem::path& file,
                               const FormatOptions& options, Progress& progress);

}  // namespace vug::exchange
