// SPDX-License-Identifier: Apache-2.0
#include <vug/survey/proj_library.h>

#include <dlfcn.h>
#include <fmt/format.h>
#include <vug/base/error.h>

#include <string>

namespace vug::survey {
namespace {

/// Debian 12's, and that of other systems with PROJ's headers. Functions of the C interface keep
/// their types between versions.
constexpr const char* kProjNames[] = {"libproj.so.25", "libproj.so"};

Error unusable_proj(const std::string& why) {
  return Error(ErrorCode::io, "the library PROJ, which computes coordinates, " + why, {},
               "install the Debian package libproj25, or add the folder of libproj.so to "
               "LD_LIBRARY_PATH");
}

void* open_proj() {
  std::string reason;
  for (const char* name : kProjNames) {
    if (void* const found = dlopen(name, RTLD_LAZY | RTLD_LOCAL)) return found;
    const char* const why = dlerror();
    if (reason.empty() && why) reason = why;
  }
  throw unusable_proj(fmt::format("cannot be loaded: {}", reason));
}

template <class Function>
void find_in_proj(void* from, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(from, name));
  if (!function) throw unusable_proj(fmt::format("lacks the function {}", name));
}

ProjLibrary load_proj() {
  void* const from = open_proj();
  ProjLibrary all{};
  find_in_proj(from, "proj_as_wkt", all.as_wkt);
  find_in_proj(from, "proj_context_create", all.context_create);
  find_in_proj(from, "proj_context_destroy", all.context_destroy);
  find_in_proj(from, "proj_context_set_enable_network", all.context_set_enable_network);
  find_in_proj(from, "proj_coord", all.coord);
  find_in_proj(from, "proj_coordoperation_get_grid_used", all.coordoperation_get_grid_used);
  find_in_proj(from, "proj_coordoperation_get_grid_used_count",
               all.coordoperation_get_grid_used_count);
  find_in_proj(from, "proj_create", all.create);
  find_in_proj(from, "proj_create_crs_to_crs", all.create_crs_to_crs);
  find_in_proj(from, "proj_create_operation_factory_context", all.create_operation_factory_context);
  find_in_proj(from, "proj_create_operations", all.create_operations);
  find_in_proj(from, "proj_crs_get_coordinate_system", all.crs_get_coordinate_system);
  find_in_proj(from, "proj_crs_get_sub_crs", all.crs_get_sub_crs);
  find_in_proj(from, "proj_cs_get_axis_count", all.cs_get_axis_count);
  find_in_proj(from, "proj_cs_get_axis_info", all.cs_get_axis_info);
  find_in_proj(from, "proj_destroy", all.destroy);
  find_in_proj(from, "proj_errno", all.last_error);
  find_in_proj(from, "proj_errno_reset", all.errno_reset);
  find_in_proj(from, "proj_get_name", all.get_name);
  find_in_proj(from, "proj_get_source_crs", all.get_source_crs);
  find_in_proj(from, "proj_get_type", all.get_type);
  find_in_proj(from, "proj_list_destroy", all.list_destroy);
  find_in_proj(from, "proj_list_get", all.list_get);
  find_in_proj(from, "proj_list_get_count", all.list_get_count);
  find_in_proj(from, "proj_log_level", all.log_level);
  find_in_proj(from, "proj_normalize_for_visualization", all.normalize_for_visualization);
  find_in_proj(from, "proj_operation_factory_context_destroy",
               all.operation_factory_context_destroy);
  find_in_proj(from, "proj_operation_factory_context_set_grid_availability_use",
               all.operation_factory_context_set_grid_availability_use);
  find_in_proj(from, "proj_operation_factory_context_set_spatial_criterion",
               all.operation_factory_context_set_spatial_criterion);
  find_in_proj(from, "proj_trans", all.trans);
  return all;
}

}  // namespace

const ProjLibrary& proj() {
  static const ProjLibrary loaded = load_proj();
  return loaded;
}

}  // namespace vug::survey
