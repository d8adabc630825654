// A grove: stems of a point process in a polygon of the plan, set on the ground, as tall and thick
// as their diameters say.
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

/// A corner of the plan.
struct PlanPoint {
  Vec2d at;
};

/// What stems stand on: one of both, or neither.
struct Earth {
  std::optional<field::Field> field;
  shot::MeshPtr mesh;
};

}  // namespace loading

template <>
struct ValueTraits<loading::PlanPoint> {
  static std::string type() { return "corner (x, z)"; }
  static std::optional<loading::PlanPoint> read(const Value& v) {
    if (const auto* vector = v.get<Value::Vector>())
      return loading::PlanPoint{{vector->value.x, vector->value.z}};
    const List* pair = v.get<List>();
    if (!pair || pair->size() != 2) return std::nullopt;
    const Number *x = (*pair)[0].get<Number>(), *z = (*pair)[1].get<Number>();
    if (!x || !z) return std::nullopt;
    return loading::PlanPoint{{x->value, z->value}};
  }
  static Value write(const loading::PlanPoint& p) { return List{p.at.x, p.at.y}; }
};

template <>
struct ValueTraits<loading::Earth> {
  static std::string type() { return "field, level set or mesh"; }
  static std::optional<loading::Earth> read(const Value& v) {
    if (const auto* field = v.object<field::Field>()) return loading::Earth{*field, nullptr};
    if (const auto* mesh = v.object<shot::MeshPtr>()) return loading::Earth{{}, *mesh};
    const auto* volume = v.object<shot::VolumePtr>();
    if (!volume || (*volume)->fog || (*volume)->source_mesh) return std::nullopt;
    return loading::Earth{(*volume)->field, nullptr};
  }
  static Value write(const loading::Earth& earth) {
    if (earth.field) return Object{"field", *earth.field};
    return earth.mesh ? Value(Object{"mesh", earth.mesh}) : Value();
  }
};

namespace loading {
namespace {

constexpr double kSteepest = 60 * kPi / 180;

struct Grove {
  std::vector<PlanPoint> polygon;
  flora::DistributionPtr distribution;
  double density = 0;
  int count = 0;
  Earth on;
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
    if (density > 0 && count > 0) return "a grove has a 'density' or a 'count', not both";
    if (density == 0 && count == 0 && !(distribution && distribution->fills()))
      return "a grove has a 'density' on a hectare, or a 'count'; only poisson_disk fills a "
             "polygon";
    if (scale.empty() || scale.size() > 2 || scale.front() > scale.back())
      return "'scale' is one number, or the smallest and the largest";
    if ((diameter > 0) == diameters.empty())
      return "'diameter' needs 'diameters', those of the things that are placed, and they need it";
    if (from && !on.field && !on.mesh)
      return "'from' is where the ground is looked for, but nothing says what they stand 'on'";
    if (steepest && !on.field && !on.mesh)
      return "'steepest' is a slope of the ground, but nothing says what they stand 'on'";
    if (margin > 0 && avoid.empty())
      return "'margin' is how far away they stand from what they 'avoid', of which there is "
             "nothing";
    if (diameter_spread > 0 && diameters.empty())
      return "'diameter_spread' is that of the 'diameter', which is not said";
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
  s.doc("Places of plants in a polygon of the plan: scattered, clumped or mixed.")
      .cite("luo2010bamboo")
      .param("polygon", &Grove::polygon,
             {.doc = "its corners (x, z) in order; sides may not cross",
              .dimension = Dimension::length,
              .required = true})
      .param("distribution", &Grove::distribution,
             {.doc = "how they stand: uniform, poisson_disk(...), thomas(...), matern(...), "
                     "mixed(...), paper; none: uniform"})
      .param("density", &Grove::density,
             {.doc = "plants on a hectare (10,000 m^2) of the plan; 0: as many as fit, for "
                     "poisson_disk",
              .min = 0})
      .param(
          "count", &Grove::count,
          {.doc =
               "plants in the polygon, instead of a density; where clumps are drawn, how many are "
               "to be expected",
           .min = 0})
      .param("on", &Grove::on, {.doc = "the ground below them; none: level ground at y = 0"})
      .param("from", &Grove::from,
             any_length("height that ground is looked for from, downwards: beneath a roof"))
      .param("spacing", &Grove::spacing,
             length("two nearer than that along the plan do not both stay; the density is that "
                    "before"))
      .param("where", &Grove::where,
             {.doc = "share of them that stays, by the ground they stand on"})
      .param("steepest", &Grove::steepest,
             angle("slope of the ground that they stand on; 60deg where none is said", kPi / 2))
      .param("avoid", &Grove::avoid, {.doc = "solids that none stands in: rock, water"})
      .param("margin", &Grove::margin, length("and how far away from these they stand"))
      .param("headroom", &Grove::headroom,
             length("height above their foot that is free of ground and of what they avoid"))
      .param("diameter", &Grove::diameter, length("mean of their diameters"))
      .param("diameter_spread", &Grove::diameter_spread, length("its standard deviation"))
      .param("diameters", &Grove::diameters,
             {.doc = "of each of the things: the one next in diameter is taken, and widened to it",
              .dimension = Dimension::length,
              .min = 0,
              .above_min = true})
      .param(
          "height_power", &Grove::height_power,
          {.doc = "heights go with that power of the diameter: 0.629 for moso", .min = 0, .max = 2})
      .param("scale", &Grove::scale,
             {.doc = "times their size: one number, or the smallest and the largest",
              .min = 0,
              .above_min = true})
      .param("turn", &Grove::turn,
             angle("about their y axis by chance, up to half of it either way", 2 * kPi))
      .param("lean", &Grove::lean, angle("off the upright by chance, at most", kPi / 2))
      .param("lean_to", &Grove::lean_to,
             {.doc = "where they lean to, a direction; none: each elsewhere"})
      .param("sink", &Grove::sink, any_length("how deep their origin lies in the ground"))
      .param("seed", &Grove::seed, {.doc = "another number, other places"});
}

flora::Ground ground_for(const Grove& g, building::Builder& builder) {
  flora::GroundOptions options;
  options.from = g.from.value_or(kInfinity);
  options.headroom = g.headroom;
  if (g.on.field) return flora::ground_of(*g.on.field, options);
  return g.on.mesh ? flora::ground_of(builder.mesh(g.on.mesh), options) : flora::level_ground();
}

building::Instance place_of(const Grove& g, const flora::Stem& stem) {
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
  // About the axis that is a quarter turn from the side that it leans to.
  const Vec3d axis(maths::sin(side), 0, -maths::cos(side));
  const Transform turned = Transform::rotation(axis, tilt) * Transform::rotation({0, 1, 0}, yaw) *
                           Transform::scaling({width, height, width});
  return {Transform::translation(stem.base.position - Vec3d(0, g.sink, 0)) * turned, stem.key,
          model};
}

/// Refers to `g`.
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

std::vector<building::Instance> plant(const Grove& g, const flora::Plot& plot,
                                      building::Builder& builder, RandomKey key) {
  std::vector<building::Instance> places;
  for (const flora::Stem& stem :
       flora::grove(plot, options_for(g, plot, builder, key), builder.progress()))
    places.push_back(place_of(g, stem));
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
  add(stats.too_near, "nearer than 'spacing' to another");
  add(stats.no_ground, "without ground below");
  add(stats.too_steep, "on ground steeper than 'steepest'");
  add(stats.no_room, "without 'headroom'");
  add(stats.avoided, "in or too near to what they 'avoid'");
  add(stats.thinned, "left out by 'where'");
  return reasons.empty() ? "the density makes not one point in so small a polygon"
                         : fmt::format("of its points, {}", fmt::join(reasons, ", "));
}

}  // namespace
}  // namespace loading
}  // namespace vug

VUG_INSTANCE_SOURCE_KIND(grove) {
  return make_kind<shot::InstanceSource, Grove>(
      "grove", "places", [](const Grove& g) -> shot::InstanceSource {
        flora::Corners corners;
        for (const PlanPoint& corner : g.polygon) corners.push_back(corner.at);
        const auto make = [g, plot = flora::Plot(corners)](building::Builder& builder,
                                                           RandomKey key) {
          return plant(g, plot, builder, key);
        };
        const auto why = [g, plot = flora::Plot(corners)](building::Builder& builder,
                                                          RandomKey key) {
          return empty_reason(g, plot, builder, key);
        };
        return std::make_shared<const building::InstanceFunction>(
            building::IndexedInstanceSource{make, static_cast<int>(g.diameters.size()) - 1, why});
      });
}
