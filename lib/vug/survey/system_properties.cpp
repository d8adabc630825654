// SPDX-License-Identifier: Apache-2.0
#include <vug/survey/system_properties.h>

#include <fmt/format.h>
#include <vug/base/error.h>
#include <vug/survey/coordinate_system.h>
#include <vug/survey/proj_library.h>

#include <cmath>
#include <memory>

namespace vug::survey {
namespace {

struct Destroy {
  void operator()(PJ* object) const { proj().destroy(object); }
  void operator()(PJ_CONTEXT* context) const { proj().context_destroy(context); }
};
using Object = std::unique_ptr<PJ, Destroy>;
using Context = std::unique_ptr<PJ_CONTEXT, Destroy>;

Context make_context() {
  Context context(proj().context_create());
  proj().log_level(context.get(), PJ_LOG_NONE);
  proj().context_set_enable_network(context.get(), 0);
  return context;
}

/// The system of a definition; null for definitions that PROJ does not know, and for local ones.
Object create_system(PJ_CONTEXT* context, const std::optional<CoordinateSystem>& system) {
  if (!system || system->definition.empty()) return nullptr;
  const std::string& text = system->definition;
  // Without a type, such a text is an operation.
  const bool is_operation = text.starts_with("+") && text.find("+type=crs") == std::string::npos;
  return Object(proj().create(context, (is_operation ? text + " +type=crs" : text).c_str()));
}

/// The system inside of those that add heights or a transformation.
Object without_wrapping(PJ_CONTEXT* context, Object system, bool& three) {
  for (int depth = 0; system && depth < 4; ++depth) {
    const PJ_TYPE type = proj().get_type(system.get());
    if (type == PJ_TYPE_COMPOUND_CRS)
      system.reset(proj().crs_get_sub_crs(context, system.get(), 0));
    else if (type == PJ_TYPE_BOUND_CRS)
      system.reset(proj().get_source_crs(context, system.get()));
    else
      break;
  }
  if (!system) return system;
  const Object axes(proj().crs_get_coordinate_system(context, system.get()));
  three = axes && proj().cs_get_axis_count(context, axes.get()) == 3;
  return system;
}

}  // namespace

SystemProperties system_properties(const std::string& name) {
  const std::optional<CoordinateSystem> known = coordinate_system(name);
  const Context context = make_context();
  Object whole = create_system(context.get(), known);
  SystemProperties out;
  // The transformation of a bound system is kept, because the text of the inner one lacks it.
  const bool bound = whole && proj().get_type(whole.get()) == PJ_TYPE_BOUND_CRS;
  Object inner = without_wrapping(context.get(), std::move(whole), out.ellipsoidal);
  const PJ_TYPE type = inner ? proj().get_type(inner.get()) : PJ_TYPE_UNKNOWN;
  out.geographic = type == PJ_TYPE_GEOGRAPHIC_2D_CRS || type == PJ_TYPE_GEOGRAPHIC_3D_CRS;
  if (!out.geographic && type != PJ_TYPE_PROJECTED_CRS)
    throw Error(ErrorCode::bad_input,
                fmt::format("'{}' is not a system of places on the Earth", name.substr(0, 80)), {},
                "systems are named as in Survex, e.g. \"EPSG:27700\" or \"UTM30N\"");
  if (const char* const title = proj().get_name(inner.get())) out.name = title;
  const bool shifted = known->origin != Vec3d(0);  // A square of the British grid.
  out.horizontal = shifted ? name : known->definition;
  if (!bound && !shifted)
    if (const char* const text = proj().as_wkt(context.get(), inner.get(), PJ_WKT2_2019, nullptr))
      out.horizontal = text;
  const Object axes(proj().crs_get_coordinate_system(context.get(), inner.get()));
  double factor = 1;
  if (axes &&
      proj().cs_get_axis_info(context.get(), axes.get(), 0, nullptr, nullptr, nullptr, &factor,
                              nullptr, nullptr, nullptr) &&
      !out.geographic)
    out.metres_per_unit = factor;
  return out;
}

std::string fault_of_survey_system(const std::string& name) {
  const std::optional<CoordinateSystem> known = coordinate_system(name);
  if (!known || known->definition.empty()) return "";
  try {
    const SystemProperties found = system_properties(name);
    if (found.geographic)
      return fmt::format("the coordinates of '{}' are degrees, but those of a survey are metres",
                         name);
    if (std::fabs(found.metres_per_unit - 1) < 1e-9) return "";
    return fmt::format("the unit of '{}' is {:.6g} m, but the coordinates of a survey are metres",
                       name, found.metres_per_unit);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::bad_input) throw;  // PROJ is missing.
    return error.what();
  }
}

std::optional<double> geoid_above_ellipsoid(const Geographic& place) {
  const Context context = make_context();
  // The shift adds the geoid's height to heights above the geoid.
  const Object shift(proj().create(context.get(),
                                   "+proj=pipeline +step +proj=unitconvert +xy_in=deg +xy_out=rad "
                                   "+step +proj=vgridshift +grids=egm96_15.gtx +multiplier=1"));
  if (!shift) return std::nullopt;
  const PJ_COORD out =
      proj().trans(shift.get(), PJ_FWD, proj().coord(place.longitude, place.latitude, 0, HUGE_VAL));
  if (proj().last_error(shift.get()) != 0 || !std::isfinite(out.xyz.z)) return std::nullopt;
  return out.xyz.z;
}

std::optional<std::string> missing_grid(const std::string& from, const std::string& to) {
  const Context context = make_context();
  const Object source = create_system(context.get(), coordinate_system(from)),
               target = create_system(context.get(), coordinate_system(to));
  if (!source || !target) return std::nullopt;
  const std::unique_ptr<PJ_OPERATION_FACTORY_CONTEXT,
                        decltype(ProjLibrary::operation_factory_context_destroy)>
      factory(proj().create_operation_factory_context(context.get(), nullptr),
              proj().operation_factory_context_destroy);
  proj().operation_factory_context_set_grid_availability_use(context.get(), factory.get(),
                                                             PROJ_GRID_AVAILABILITY_IGNORED);
  proj().operation_factory_context_set_spatial_criterion(
      context.get(), factory.get(), PROJ_SPATIAL_CRITERION_PARTIAL_INTERSECTION);
  const std::unique_ptr<PJ_OBJ_LIST, decltype(ProjLibrary::list_destroy)> operations(
      proj().create_operations(context.get(), source.get(), target.get(), factory.get()),
      proj().list_destroy);
  if (!operations || proj().list_get_count(operations.get()) < 1) return std::nullopt;
  // The first is the most accurate one.
  const Object best(proj().list_get(context.get(), operations.get(), 0));
  const int grids = best ? proj().coordoperation_get_grid_used_count(context.get(), best.get()) : 0;
  for (int i = 0; i < grids; ++i) {
    const char* name = nullptr;
    int available = 1;
    if (proj().coordoperation_get_grid_used(context.get(), best.get(), i, &name, nullptr, nullptr,
                                            nullptr, nullptr, nullptr, &available) &&
        !available && name)
      return name;
  }
  return std::nullopt;
}

}  // namespace vug::survey
