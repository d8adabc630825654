// SPDX-License-Identifier: Apache-2.0
// Stones of a distribution of sizes that rest on the ground and on each other.
#include <vug/building/builder.h>
#include <vug/building/flat_scene.h>
#include <vug/loading/instance_source_kinds.h>
#include <vug/mesh/stones/lay_stones.h>
#include <vug/paint/kind.h>
#include <vug/shot/queries.h>

#include <fmt/format.h>

namespace vug::loading {
namespace {

struct Gravel {
  shot::MeshPtr on;
  std::vector<double> sizes = {0.03, 0.25};
  std::optional<double> typical;
  double uniformity = 1.4;
  double cover = 0.25;
  paint::Mask where, coarse;
  double spread = 0.2;
  double steepest = 32 * kPi / 180;
  double sink = 0.05;
  int count = 100000;
  int seed = 0;

  static void describe(Schema<Gravel>& s) {
    const ParamSpec steepest{.doc = "slope of the steepest ground with stones",
                             .dimension = Dimension::angle,
                             .min = 0,
                             .max = 36 * kPi / 180};
    s.doc(
         "Stones of many sizes that rest on the ground and on larger stones: each turns and tilts "
         "until three contacts carry it. The stones are the models of the place.")
        .cite("rosin1933laws")
        .param("on", &Gravel::on, {.doc = "the mesh to lie on", .required = true})
        .param("sizes", &Gravel::sizes,
               {.doc = "smallest and largest diameter, that of the ball with the same volume",
                .dimension = Dimension::length,
                .min = 0,
                .above_min = true})
        .param("typical", &Gravel::typical,
               positive_length("63 % of the mass is of stones below this diameter; default: the "
                               "geometric mean of the sizes"))
        .param("uniformity", &Gravel::uniformity,
               {.doc = "exponent of the distribution: with more, sizes differ less",
                .min = 0.3,
                .max = 10})
        .param("cover", &Gravel::cover,
               {.doc = "fraction of the ground that they cover", .min = 0, .max = 1})
        .param("where", &Gravel::where, {.doc = "fraction to keep at each point"})
        .param("coarse", &Gravel::coarse,
               {.doc = "how coarse they are: 1, as in the middle of a current, the largest, 0 the "
                       "smallest; default: mixed"})
        .param("spread", &Gravel::spread,
               {.doc = "deviation from 'coarse' on its scale", .min = 0.02, .max = 2})
        .param("steepest", &Gravel::steepest, steepest)
        .param("sink", &Gravel::sink,
               {.doc = "depth to which they sink in, over their diameter", .min = 0, .max = 0.5})
        .param("count", &Gravel::count,
               {.doc = "more stones are an error", .min = 1, .max = 10000000})
        .param("seed", &Gravel::seed, {.doc = "seed of the random positions"});
  }
  std::string fault() const {
    return sizes.size() != 2 || sizes[0] > sizes[1]
               ? "'sizes' must be the smallest and the largest diameter"
               : "";
  }
};

std::vector<mesh::StoneShape> shapes_of(building::Builder& builder,
                                        const shot::PointInstancer& plan) {
  std::vector<mesh::StoneShape> shapes;
  for (const shot::Model& model : plan.of) {
    const std::optional<shot::ObjectPlan> object = shot::object_of(builder.shot(), model);
    if (!object)
      throw Error(ErrorCode::bad_input,
                  fmt::format("the scene '{}' cannot be a stone of 'gravel'", model.name), {},
                  "use objects or meshes");
    try {
      shapes.push_back(mesh::stone_shape(*builder.mesh(object->mesh)));
    } catch (const Error& error) {
      if (error.code() != ErrorCode::bad_input) throw;
      throw Error(ErrorCode::bad_input, fmt::format("'{}': {}", model.name, error.what()), {},
                  error.hint());
    }
  }
  return shapes;
}

std::vector<building::Instance> lay_gravel(const Gravel& g, building::Builder& builder,
                                           RandomKey key, const shot::PointInstancer& plan) {
  const mesh::MeshPtr ground = builder.mesh(g.on);
  const auto solid = builder.solid(g.on);
  const auto value = [&solid](const paint::Mask& mask) {
    return [&mask, &solid](const mesh::SurfaceSample& spot) {
      return (*mask)({spot.position, spot.normal, solid.get()});
    };
  };
  mesh::LayOptions options;
  options.sizes = {g.sizes[0], g.sizes[1], g.typical.value_or(std::sqrt(g.sizes[0] * g.sizes[1])),
                   g.uniformity};
  options.cover = g.cover;
  options.steepest = g.steepest;
  options.spread = g.spread;
  options.sink = g.sink;
  options.max_count = static_cast<size_t>(g.count);
  options.key = key.at(static_cast<uint64_t>(g.seed));
  options.choose_shape = [&plan](RandomKey of) {
    return static_cast<size_t>(building::choose_model({Transform(), of, -1}, plan));
  };
  if (g.where) options.keep_probability = value(g.where);
  if (g.coarse) options.coarse = value(g.coarse);
  const std::vector<mesh::StoneShape> shapes = shapes_of(builder, plan);
  std::vector<building::Instance> places;
  for (const auto& [stone, own] : mesh::lay_stones(*ground, shapes, options, builder.progress())) {
    const mesh::StonePose& pose = stone.rest.pose;
    const Transform turned(pose.x * pose.scale, pose.y * pose.scale, pose.z * pose.scale,
                           pose.centre);
    places.push_back({turned * Transform::translation(-shapes[stone.shape].centre), own,
                      static_cast<int>(stone.shape)});
  }
  return places;
}

}  // namespace
}  // namespace vug::loading

VUG_INSTANCE_SOURCE_KIND(gravel) {
  return make_kind<shot::InstanceSource, Gravel>(
      "gravel", "places", [](const Gravel& g) -> shot::InstanceSource {
        return std::make_shared<const building::InstanceFunction>(building::ModelInstanceSource{
            [g](building::Builder& builder, RandomKey key, const shot::PointInstancer& plan) {
              return lay_gravel(g, builder, key, plan);
            }});
      });
}
