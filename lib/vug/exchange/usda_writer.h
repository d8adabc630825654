// SPDX-License-Identifier: Apache-2.0
// Internal to exchange/: writes an assembly as a USD text.
#pragma once

#include <vug/exchange/format.h>
#include <vug/exchange/names.h>
#include <vug/exchange/trs.h>
#include <vug/exchange/usd_mesh.h>
#include <vug/exchange/usd_text.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace vug::exchange {

/// Writes a root prim with materials, instances, volumes, cameras and lights.
class UsdaWriter {
 public:
  /// Environment maps are named after `file`.
  UsdaWriter(const Assembly& assembly, const FormatOptions& options, UsdText& out,
             std::filesystem::path file, WriteReport& written);

  void write(Progress& progress);

  /// Opens the root prim. `metadata`: that of the root prim in addition.
  void begin(const std::vector<std::string>& metadata = {});
  void end();

  using Part = std::function<void()>;  ///< Writes a part of the root prim.
  /// Calls `visit` with each part in a fixed order. `visit` must call each, since later parts refer
  /// to earlier ones.
  void each_part(const std::function<void(const Part&)>& visit, Progress& progress);

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
  UsdText& out_;
  std::filesystem::path file_;
  WriteReport& written_;
  std::string root_;
  bool writes_skies_ = true;
  UniqueNames names_;
  std::map<size_t, std::string> meshes_;
  std::map<size_t, UsdMaterials> materials_;
};

}  // namespace vug::exchange
