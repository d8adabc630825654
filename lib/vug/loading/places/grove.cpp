// SPDX-License-Identifier: Apache-2.0
// A grove: plants of a point process in a polygon of the ground plan, placed on the ground and
// scaled by their diameters.
#include <vug/base/maths.h>
#include <vug/building/builder.h>
#include <vug/field/kind.h>
#include <vug/flora/grove.h>
#include <vug/loading/instance_source_kinds.h>
#include <vug/paint/kind.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace vug {

namespace loading {

/// A corner of the polygon.
struct PolygonCorner {
  Vec2d at;
};

/// The ground: a field, a mesh, or neither.
struct GroundSource {
  std::optional<field::Field> field;
  shot::MeshPtr mesh;
};

}  // namespace loading

template <>
struct ValueTraits<loading::PolygonCorner> {
  static std::string type() { return "corner (x, z)"; }
  static std::optional<loading::PolygonCorner> read(const Value& v) {
    if (const auto* vector = v.get<Value::Vector>())
      return loading::PolygonCorner{{vector->value.x, vector->value.z}};
    const List* pair = v.get<List>();
    if (!pair || pair->size() != 2) return std::nullopt;
    const Number *x = (*pair)[0].get<Number>(), *z = (*pair)[1].get<Number>();
    if (!x || !z) return std::nullopt;
    return loading::PolygonCorner{{x->value, z->value}};
  }
  static Value write(const loading::PolygonCorner& p) { return List{p.at.x, p.at.y}; }
};

template <>
struct ValueTraits<loading::GroundSource> {
  static std::string type() { return "field, level set or mesh"; }
  static std::optional<loading::GroundSource> read(const Value& v) {
    if (const auto* field = v.object<field::Field>()) return loading::GroundSource{*field, nullptr};
    if (const auto* mesh = v.object<shot::MeshPtr>()) return loading::GroundSource{{}, *mesh};
    const auto* volume = v.object<shot::VolumePtr>();
    if (!volume || (*volume)->fog || (*volume)->source_mesh) return std::nullopt;
    return loading::GroundSource{(*volume)->field, nullptr};
  }
  static Value write(const loading::GroundSource& earth) {
    if (earth.field) return Object{"field", *earth.field};
    return earth.mesh ? Value(Object{"mesh", earth.mesh}) : Value();
  }
};

namespace loading {
namespace {

constexpr double kSteepest = 60 * kPi / 180;

struct Grove {
  std::vector<PolygonCorner> polygon;
  flora::DistributionPtr distribution;
  double density = 0;
  int count = 0;
  GroundSource on;
  std::optional<double> from;
  double spacing = 0;
  paint::Mask where;
  std::optional<double> steepest;
  std::vector<field::Field> avoid;
  double margin = 0;
  double headroom = 0;
  double diameter = 0;
  double diameter_spread = 0;
  std::vector<double> diameters;
  double height_power = 1;
  std::vector<double> scale = {1};
  double turn = 2 * kPi;
  double lean = 0;
  Vec3d lean_to{0, 0, 0};
  double sink = 0;
  int seed = 0;

  static void describe(Schema<Grove>& s);
  std::string fault() const {
    if (density > 0 && count > 0) return "a grove takes a 'density' or a 'count', not both";
    if (density == 0 && count == 0 && !(distribution && distribution->fills()))
      return "a grove needs a 'density' per hectare or a 'count'; only poisson_disk fills a "
             "polygon";
    if (scale.empty() || scale.size() > 2 || scale.front() > scale.back())
      return "'scale' must be one number, or a minimum and a maximum";
    if ((diameter > 0) == diameters.empty())
      return "'diameter' and 'diameters', those of the models, must be given together";
    if (from && !on.field && !on.mesh)
      return "'from' is the height of the search for the ground, but there is no ground 'on'";
    if (steepest && !on.field && !on.mesh)
      return "'steepest' is a slope of the ground, but there is no ground 'on'";
    if (margin > 0 && avoid.empty())
      return "'margin' is the distance from 'avoid', of which there is "
             "nothing";
    if (diameter_spread > 0 && diameters.empty())
      return "'diameter_spread' belongs to 'diameter', which is missing";
    return "";
  }
};

void Grove::describe(Schema<Grove>& s) {
  const auto length = [](std::string doc) {
    return ParamSpec{.doc = std::move(doc), .dimension = Dimension::length, .min = 0};
  };
  const auto angle = [](std::string doc, double most) {
    return ParamSpec{.doc = std::move(doc), .dimension = Dimension::angle, .min = 0, .max = most};
  };
  s.doc("Instances of plants in a polygon of the ground plan: scattered, clumped or mixed.")
      .cite("luo2010bamboo")
      .param("polygon", &Grove::polygon,
             {.doc = "corners (x, z) of the polygon in order; edges must not cross",
              .dimension = Dimension::length,
              .required = true})
      .param("distribution", &Grove::distribution,
             {.doc = "distribution: uniform, poisson_disk(...), thomas(...), matern(...), "
                     "mixed(...), paper; default: uniform"})
      .param("density", &Grove::density,
             {.doc = "plants on a hectare (10,000 m^2) of the plan; 0: as many as fit, for "
                     "poisson_disk",
              .min = 0})
      .param(
          "count", &Grove::count,
          {.doc = "number of plants in the polygon, instead of a density; for clumps, the expected "
                  "number",
           .min = 0})
      .param("on", &Grove::on, {.doc = "the ground; default: level ground at y = 0"})
      .param("from", &Grove::from,
             any_length(
                 "height from which the ground is searched downwards, for groves beneath a roof"))
      .param("spacing", &Grove::spacing,
             length("two nearer than that along the plan do not both stay; the density is that "
                    "before"))
      .param("where", &Grove::where, {.doc = "fraction to keep, evaluated on the ground"})
      .param("steepest", &Grove::steepest,
             angle("maximum slope of the ground; default: 60deg", kPi / 2))
      .param("avoid", &Grove::avoid, {.doc = "solids to avoid: rock, water"})
      .param("margin", &Grove::margin, length("minimum distance from 'avoid'"))
      .param("headroom", &Grove::headroom,
             length("height above the foot that must be free of ground and of 'avoid'"))
      .param("diameter", &Grove::diameter, length("mean diameter"))
      .param("diameter_spread", &Grove::diameter_spread,
             length("standard deviation of the diameter"))
      .param("diameters", &Grove::diameters,
             {.doc = "diameter of each model: the model of the nearest diameter is chosen and "
                     "scaled to it",
              .dimension = Dimension::length,
              .min = 0,
              .above_min = true})
      .param("height_power", &Grove::height_power,
             {.doc = "exponent of height over diameter: 0.629 for moso", .min = 0, .max = 2})
      .param("scale", &Grove::scale,
             {.doc = "factor of the size: one number, or a minimum and a maximum",
              .min = 0,
              .above_min = true})
      .param("turn", &Grove::turn,
             angle("random rotation about the y axis, up to half of it either way", 2 * kPi))
      .param("lean", &Grove::lean, angle("maximum random deviation from the vertical", kPi / 2))
      .param("lean_to", &Grove::lean_to, {.doc = "direction of leaning; default: random for each"})
      .param("sink", &Grove::sink, any_length("depth of the origin in the ground"))
      .param("seed", &Grove::seed, {.doc = "seed of the random positions"});
}

flora::Ground ground_for(const Grove& g, building::Builder& builder) {
  flora::GroundOptions options;
  options.from = g.from.value_or(kInfinity);
  options.headroom = g.headroom;
  if (g.on.field) return flora::ground_of(*g.on.field, options);
  return g.on.mesh ? flora::ground_of(builder.mesh(g.on.mesh), options) : flora::level_ground();
}

building::Instance instance_of(const Grove& g, const flora::Stem& stem) {
  RandomStream random(stem.key.at("pose"));
  const double yaw = (random.uniform() - 0.5) * g.turn, tilt = random.uniform() * g.lean;
  double side = random.uniform() * 2 * kPi;
  if (g.lean_to.x != 0 || g.lean_to.z != 0) side = maths::atan2(g.lean_to.z, g.lean_to.x);
  const double chance = random.uniform(g.scale.front(), g.scale.back());
  int model = -1;
  double width = chance, height = chance;
  if (stem.diameter > 0) {
    const size_t thing = flora::nearest_diameter(g.diameters, stem.diameter, stem.key);
    model = static_cast<int>(thing);
    const double ratio = stem.diameter / g.diameters[thing];
    width *= ratio;
    height *= maths::pow(ratio, g.height_power);
  }
  // Rotation about the horizontal axis perpendicular to the direction of leaning.
  const Vec3d axis(maths::sin(side), 0, -maths::cos(side));
  const Transform turned = Transform::rotation(axis, tilt) * Transform::rotation({0, 1, 0}, yaw) *
                           Transform::scaling({width, height, width});
  return {Transform::translation(stem.base.position - Vec3d(0, g.sink, 0)) * turned, stem.key,
          model};
}

/// The result refers to `g`.
flora::GroveOptions options_for(const Grove& g, const flora::Plot& plot, building::Builder& builder,
                                RandomKey key) {
  flora::GroveOptions options;
  options.distribution = g.distribution;
  options.density = g.count > 0 ? g.count / plot.area() : g.density / flora::kHectare;
  options.spacing = g.spacing;
  options.ground = ground_for(g, builder);
  options.steepest = g.steepest.value_or(kSteepest);
  options.headroom = g.headroom;
  options.avoid = g.avoid;
  options.margin = g.margin;
  options.diameter = g.diameter;
  options.diameter_spread = g.diameter_spread;
  options.key = key.at(static_cast<uint64_t>(g.seed));
  const auto solid = g.on.mesh ? builder.solid(g.on.mesh) : nullptr;
  if (g.where)
    options.retention = [&g, solid](const flora::GroundPoint& foot) {
      return (*g.where)({foot.position, foot.normal, solid.get()});
    };
  return options;
}

std::vector<building::Instance> grove_instances(const Grove& g, const flora::Plot& plot,
                                                building::Builder& builder, RandomKey key) {
  std::vector<building::Instance> places;
  for (const flora::Stem& stem :
       flora::grove(plot, options_for(g, plot, builder, key), builder.progress()))
    places.push_back(instance_of(g, stem));
  return places;
}

std::string empty_reason(const Grove& g, const flora::Plot& plot, building::Builder& builder,
                         RandomKey key) {
  const flora::PlacementStats stats =
      flora::placement_stats(plot, options_for(g, plot, builder, key), builder.progress());
  std::vector<std::string> reasons;
  const auto add = [&](size_t count, const char* reason) {
    if (count > 0) reasons.push_back(fmt::format("{} {}", count, reason));
  };
  add(stats.too_near, "closer than 'spacing' to another");
  add(stats.no_ground, "without ground below");
  add(stats.too_steep, "on ground steeper than 'steepest'");
  add(stats.no_room, "without 'headroom'");
  add(stats.avoided, "inside or too close to 'avoid'");
  add(stats.thinned, "removed by 'where'");
  return reasons.empty() ? "the density yields no point in such a small polygon"
                         : fmt::format("of its points, {}", fmt::join(reasons, ", "));
}

}  // namespace
}  // namespace loading
}  // namespace vug

VUG_INSTANCE_SOURCE_KIND(grove) {
  return make_kind<shot::InstanceSource, Grove>(
      "grove", "places", [](const Grove& g) -> shot::InstanceSource {
        flora::Corners corners;
        for (const PolygonCorner& corner : g.polygon) corners.push_back(corner.at);
        const auto make = [g, plot = flora::Plot(corners)](building::Builder& builder,
                                                           RandomKey key) {
          return grove_instances(g, plot, builder, key);
        };
        const auto why = [g, plot = flora::Plot(corners)](building::Builder& builder,
                                                          RandomKey key) {
          return empty_reason(g, plot, builder, key);
        };
        return std::make_shared<const building::InstanceFunction>(
            building::IndexedInstanceSource{make, static_cast<int>(g.diameters.size()) - 1, why});
      });
}
