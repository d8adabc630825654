// SPDX-License-Identifier: Apache-2.0
#include <vug/survey/proj_library.h>

#include <vug/base/dynamic_library.h>

namespace vug::survey {
namespace {

/// Debian 12's, and that of other systems with PROJ's headers. Functions of the C interface keep
/// their types between versions.
constexpr const char* kProjNames[] = {"libproj.so.25", "libproj.so"};

ProjLibrary load_proj() {
  const DynamicLibrary from(kProjNames, "the library PROJ, which computes coordinates,",
                            "install the Debian package libproj25, or add the folder of "
                            "libproj.so to LD_LIBRARY_PATH");
  ProjLibrary all{};
  from.find("proj_as_wkt", all.as_wkt);
  from.find("proj_context_create", all.context_create);
  from.find("proj_context_destroy", all.context_destroy);
  from.find("proj_context_set_enable_network", all.context_set_enable_network);
  from.find("proj_coord", all.coord);
  from.find("proj_coordoperation_get_grid_used", all.coordoperation_get_grid_used);
  from.find("proj_coordoperation_get_grid_used_count", all.coordoperation_get_grid_used_count);
  from.find("proj_create", all.create);
  from.find("proj_create_crs_to_crs", all.create_crs_to_crs);
  from.find("proj_create_operation_factory_context", all.create_operation_factory_context);
  from.find("proj_create_operations", all.create_operations);
  from.find("proj_crs_get_coordinate_system", all.crs_get_coordinate_system);
  from.find("proj_crs_get_sub_crs", all.crs_get_sub_crs);
  from.find("proj_cs_get_axis_count", all.cs_get_axis_count);
  from.find("proj_cs_get_axis_info", all.cs_get_axis_info);
  from.find("proj_destroy", all.destroy);
  from.find("proj_errno", all.last_error);
  from.find("proj_errno_reset", all.errno_reset);
  from.find("proj_get_name", all.get_name);
  from.find("proj_get_source_crs", all.get_source_crs);
  from.find("proj_get_type", all.get_type);
  from.find("proj_list_destroy", all.list_destroy);
  from.find("proj_list_get", all.list_get);
  from.find("proj_list_get_count", all.list_get_count);
  from.find("proj_log_level", all.log_level);
  from.find("proj_normalize_for_visualization", all.normalize_for_visualization);
  from.find("proj_operation_factory_context_destroy", all.operation_factory_context_destroy);
  from.find("proj_operation_factory_context_set_grid_availability_use",
            all.operation_factory_context_set_grid_availability_use);
  from.find("proj_operation_factory_context_set_spatial_criterion",
            all.operation_factory_context_set_spatial_criterion);
  from.find("proj_trans", all.trans);
  return all;
}

}  // namespace

const ProjLibrary& proj() {
  static const ProjLibrary loaded = load_proj();
  return loaded;
}

}  // namespace vug::survey
