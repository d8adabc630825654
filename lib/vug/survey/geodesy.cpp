// SPDX-License-Identifier: Apache-2.0
#include <vug/survey/geodesy.h>

#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/survey/coordinate_system.h>
#include <vug/survey/proj_library.h>

#include <fmt/format.h>

#include <cmath>
#include <map>

namespace vug::survey {
namespace {

constexpr const char* kWgs84 = "EPSG:4326";

}  // namespace

struct Geodesy::Cache {
  struct DestroyTransformation {
    void operator()(PJ* transformation) const { proj().destroy(transformation); }
  };
  using Transformation = std::unique_ptr<PJ, DestroyTransformation>;

  PJ_CONTEXT* context = proj().context_create();
  std::map<std::pair<std::string, std::string>, Transformation> transformations;

  Cache() {
    // Errors are thrown by the callers; PROJ must not print and must not use the network.
    proj().log_level(context, PJ_LOG_NONE);
    proj().context_set_enable_network(context, 0);
  }
  ~Cache() {
    transformations.clear();
    proj().context_destroy(context);
  }

  PJ* find(const std::string& from, const std::string& to) {
    Transformation& known = transformations[{from, to}];
    if (known) return known.get();
    const Transformation raw(proj().create_crs_to_crs(context, from.c_str(), to.c_str(), nullptr));
    if (raw) known.reset(proj().normalize_for_visualization(context, raw.get()));
    if (known) return known.get();
    throw Error(ErrorCode::bad_input,
                fmt::format("PROJ cannot transform from '{}' to '{}'", from, to), {},
                "check the coordinate systems");
  }

  Vec3d apply(const std::string& from, const std::string& to, const Vec3d& place) {
    PJ* transformation = find(from, to);
    proj().errno_reset(transformation);
    const PJ_COORD out =
        proj().trans(transformation, PJ_FWD, proj().coord(place.x, place.y, place.z, HUGE_VAL));
    const Vec3d result(out.xyz.x, out.xyz.y, out.xyz.z);
    if (proj().last_error(transformation) == 0 && std::isfinite(result.x) &&
        std::isfinite(result.y) && std::isfinite(result.z))
      return result;
    throw Error(ErrorCode::bad_input,
                fmt::format("the place ({:.2f}, {:.2f}, {:.2f}) of '{}' has no coordinates in '{}'",
                            place.x, place.y, place.z, from, to),
                {}, "check the coordinates and '*cs'");
  }
};

namespace {

/// The system of a name that is not local. Error(bad_input) for others.
CoordinateSystem require_system(const std::string& name) {
  const std::optional<CoordinateSystem> system = coordinate_system(name);
  if (!system || system->definition.empty())
    throw Error(ErrorCode::bad_input,
                fmt::format("'{}' is not a coordinate system on the Earth", name), {},
                "systems are named as in Survex, e.g. \"EPSG:27700\" or \"UTM30N\"");
  return *system;
}

}  // namespace

Geodesy::Geodesy() = default;
Geodesy::~Geodesy() = default;

Geodesy::Cache& Geodesy::cache() {
  if (!cache_) cache_ = std::make_unique<Cache>();
  return *cache_;
}

std::string Geodesy::fault_of(const std::string& name) {
  const std::optional<CoordinateSystem> system = coordinate_system(name);
  if (!system) return fmt::format("unknown coordinate system '{}'", name);
  if (system->definition.empty()) return "";
  try {
    cache().find(system->definition, kWgs84);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::bad_input) throw;  // PROJ is missing.
    return fmt::format("PROJ does not know the coordinate system '{}'", name);
  }
  return "";
}

Vec3d Geodesy::transform(const std::string& from, const std::string& to, const Vec3d& place) {
  const CoordinateSystem source = require_system(from), target = require_system(to);
  const Vec3d here = place + source.origin;
  const bool same = source.definition == target.definition;
  return (same ? here : cache().apply(source.definition, target.definition, here)) - target.origin;
}

Geographic Geodesy::geographic(const std::string& from, const Vec3d& place) {
  const CoordinateSystem source = require_system(from);
  const Vec3d found = cache().apply(source.definition, kWgs84, place + source.origin);
  return {found.x, found.y, found.z};
}

double Geodesy::true_north(const std::string& grid, const Geographic& place) {
  const CoordinateSystem target = require_system(grid);
  constexpr double kStep = 1e-5;  // Degrees: about a metre to the north and to the south.
  const auto at = [&](double latitude) {
    return cache().apply(kWgs84, target.definition, {place.longitude, latitude, place.height});
  };
  const Vec3d north = at(place.latitude + kStep) - at(place.latitude - kStep);
  return maths::atan2(north.x, north.y);
}

}  // namespace vug::survey
