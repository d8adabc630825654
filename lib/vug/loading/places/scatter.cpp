// SPDX-License-Identifier: Apache-2.0
// Instances scattered over a mesh with a minimum spacing, thinned by a mask, with random rotation
// and size.
#include <vug/base/maths.h>
#include <vug/building/builder.h>
#include <vug/loading/instance_source_kinds.h>
#include <vug/mesh/scatter.h>
#include <vug/paint/kind.h>

namespace vug::loading {
namespace {

struct Scatter {
  shot::MeshPtr on;
  double spacing = 0.3;
  int count = 10000;
  paint::Mask where;
  double upright = 0;
  double turn = 2 * kPi;
  double tilt = 0;
  std::vector<double> scale = {1};
  double sink = 0;
  int seed = 0;

  static void describe(Schema<Scatter>& s) {
    s.doc("Instances scattered randomly over a mesh with a minimum spacing.")
        .cite("cook1986stochastic")
        .param("on", &Scatter::on, {.doc = "the mesh to scatter on", .required = true})
        .param("spacing", &Scatter::spacing,
               positive_length("minimum distance between any two origins"))
        .param("count", &Scatter::count,
               {.doc = "maximum number, spread over the whole mesh", .min = 1, .max = 10000000})
        .param("where", &Scatter::where,
               {.doc = "fraction to keep: slope(from: 40deg, to: 20deg) keeps floors"})
        .param(
            "upright", &Scatter::upright,
            {.doc = "0: the y axis is normal to the surface, 1: it points up", .min = 0, .max = 1})
        .param("turn", &Scatter::turn,
               {.doc = "random rotation about the y axis, up to half of it either way",
                .dimension = Dimension::angle,
                .min = 0})
        .param("tilt", &Scatter::tilt,
               {.doc = "maximum random deviation from that axis",
                .dimension = Dimension::angle,
                .min = 0,
                .max = kPi})
        .param("scale", &Scatter::scale,
               {.doc = "factor of the size: one number, or a minimum and a maximum",
                .min = 0,
                .above_min = true})
        .param("sink", &Scatter::sink,
               any_length("depth of the origin below the surface, at scale 1"))
        .param("seed", &Scatter::seed, {.doc = "seed of the random positions"});
  }
  std::string fault() const {
    return scale.empty() || scale.size() > 2 || scale.front() > scale.back()
               ? "'scale' must be one number, or a minimum and a maximum"
               : "";
  }
};

building::Instance scatter_instance(const Scatter& s, const mesh::SurfaceSample& spot) {
  RandomStream random(spot.key.at("pose"));
  const Vec3d up(0, 1, 0);
  Vec3d axis = spot.normal * (1 - s.upright) + up * s.upright;
  axis = axis.length() > 1e-6 ? axis.normalized() : up;
  const double yaw = (random.uniform() - 0.5) * s.turn, side = random.uniform() * 2 * kPi;
  const double tilt = random.uniform() * s.tilt;
  const double size = random.uniform(s.scale.front(), s.scale.back());
  const Transform turned = rotation_between(up, axis) *
                           Transform::rotation({maths::cos(side), 0, maths::sin(side)}, tilt) *
                           Transform::rotation(up, yaw) * Transform::scaling(Vec3d(size));
  return {Transform::translation(spot.position - axis * (s.sink * size)) * turned, spot.key, -1};
}

std::vector<building::Instance> scatter_on_mesh(const Scatter& s, building::Builder& builder,
                                                RandomKey key) {
  const mesh::MeshPtr mesh = builder.mesh(s.on);
  const auto solid = builder.solid(s.on);
  mesh::ScatterOptions options;
  options.spacing = s.spacing;
  options.max_count = static_cast<size_t>(s.count);
  options.key = key.at(static_cast<uint64_t>(s.seed));
  if (s.where)
    options.keep_probability = [&](const mesh::SurfaceSample& spot) {
      paint::EvalPoint at{spot.position, spot.normal, solid.get()};
      at.footprint = s.spacing;
      return (*s.where)(at);
    };
  std::vector<building::Instance> places;
  for (const mesh::SurfaceSample& spot : mesh::scatter(*mesh, options, builder.progress()))
    places.push_back(scatter_instance(s, spot));
  return places;
}

}  // namespace
}  // namespace vug::loading

VUG_INSTANCE_SOURCE_KIND(scatter) {
  return instance_source_kind<Scatter>("scatter", scatter_on_mesh);
}
