// SPDX-License-Identifier: Apache-2.0
// Internal to survey/: the functions of PROJ, found in its shared library on first use
// (docs/explanation/decisions/0050-proj-on-first-use.md).
#pragma once

#include <proj.h>

namespace vug::survey {

/// The functions, named as in PROJ without their prefix. The types are those of its header.
struct ProjLibrary {
  decltype(&::proj_as_wkt) as_wkt;
  decltype(&::proj_context_create) context_create;
  decltype(&::proj_context_destroy) context_destroy;
  decltype(&::proj_context_set_enable_network) context_set_enable_network;
  decltype(&::proj_coord) coord;
  decltype(&::proj_coordoperation_get_grid_used) coordoperation_get_grid_used;
  decltype(&::proj_coordoperation_get_grid_used_count) coordoperation_get_grid_used_count;
  decltype(&::proj_create) create;
  decltype(&::proj_create_crs_to_crs) create_crs_to_crs;
  decltype(&::proj_create_operation_factory_context) create_operation_factory_context;
  decltype(&::proj_create_operations) create_operations;
  decltype(&::proj_crs_get_coordinate_system) crs_get_coordinate_system;
  decltype(&::proj_crs_get_sub_crs) crs_get_sub_crs;
  decltype(&::proj_cs_get_axis_count) cs_get_axis_count;
  decltype(&::proj_cs_get_axis_info) cs_get_axis_info;
  decltype(&::proj_destroy) destroy;
  decltype(&::proj_errno) last_error;  ///< proj_errno: `errno` is a macro.
  decltype(&::proj_errno_reset) errno_reset;
  decltype(&::proj_get_name) get_name;
  decltype(&::proj_get_source_crs) get_source_crs;
  decltype(&::proj_get_type) get_type;
  decltype(&::proj_list_destroy) list_destroy;
  decltype(&::proj_list_get) list_get;
  decltype(&::proj_list_get_count) list_get_count;
  decltype(&::proj_log_level) log_level;
  decltype(&::proj_normalize_for_visualization) normalize_for_visualization;
  decltype(&::proj_operation_factory_context_destroy) operation_factory_context_destroy;
  decltype(&::proj_operation_factory_context_set_grid_availability_use)
      operation_factory_context_set_grid_availability_use;
  decltype(&::proj_operation_factory_context_set_spatial_criterion)
      operation_factory_context_set_spatial_criterion;
  decltype(&::proj_trans) trans;
};

/// Loads PROJ on first use, for the rest of the process; thread-safe. Throws Error(io) if it is
/// missing.
const ProjLibrary& proj();

}  // namespace vug::survey
