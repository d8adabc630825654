// SPDX-License-Identifier: Apache-2.0
#include <vug/building/flat_scene.h>
#include <vug/exchange/light.h>
#include <vug/loading/placement/set.h>
#include <vug/shot/queries.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::loading {
namespace {

/// Instances of one `place` that are checked at most; they are spread over all.
constexpr size_t kMostInstances = 200;

/// The solids and lights of a model, or of the whole scene.
struct Contents {
  std::vector<Solid> solids;
  std::vector<std::pair<std::string, std::vector<Vec3d>>> lights;
};

std::vector<Vec3d> points_of(const render::Light& light) {
  std::vector<Vec3d> points = {Vec3d(light.center())};
  exchange::Light data;
  if (!light.as_data(data)) return points;
  const bool flat =
      data.shape == exchange::Light::Shape::rectangle || data.shape == exchange::Light::Shape::disk;
  const bool angular = data.shape == exchange::Light::Shape::rectangle;
  const Vec3d x = data.place.column(0) * (angular ? 0.5 * data.width : data.radius);
  const Vec3d y = data.place.column(1) * (angular ? 0.5 * data.height : data.radius);
  const Vec3d z = data.place.column(2) * data.radius;
  if (angular) {
    for (const Vec3d& corner : {x + y, x - y, -x + y, -x - y}) points.push_back(points[0] + corner);
  } else {
    for (const Vec3d& rim : {x, -x, y, -y}) points.push_back(points[0] + rim);
    if (!flat)
      for (const Vec3d& pole : {z, -z}) points.push_back(points[0] + pole);
  }
  return points;
}

Contents contents_of(const shot::Shot& shot) {
  Contents out;
  for (const shot::ObjectPlan& object : shot::shown_objects(shot))
    for (Solid& solid : solids_of(object)) out.solids.push_back(std::move(solid));
  for (const auto& [name, light] : shot.lights)
    if (!light->is_infinite()) out.lights.emplace_back(name, points_of(*light));
  return out;
}

Contents contents_of(const shot::Shot& shot, const shot::Model& model) {
  if (model.scene) return contents_of(*model.scene);
  Contents out;
  if (const auto object = shot::object_of(shot, model)) out.solids = solids_of(*object);
  return out;
}

/// The instances whose transforms the text gives.
std::vector<building::Instance> given_instances(const shot::Shot& shot,
                                                const shot::PointInstancer& plan) {
  building::Builder builder(shot);
  std::vector<building::Instance> instances;
  for (size_t i = 0; i < plan.at.size(); ++i) {
    const auto* source = plan.at[i]->target<building::IndexedInstanceSource>();
    if (!source || !source->is_given) continue;
    const auto more = (*source)(builder, plan.key.at(i));
    instances.insert(instances.end(), more.begin(), more.end());
  }
  return instances;
}

void add_instances(const shot::Shot& shot, const shot::PointInstancer& plan, Set& set) {
  const std::vector<building::Instance> instances = given_instances(shot, plan);
  std::vector<Contents> models;
  for (const shot::Model& model : plan.of) models.push_back(contents_of(shot, model));
  const size_t step = instances.size() / kMostInstances + 1;
  for (size_t i = 0; i < instances.size(); i += step) {
    const building::Instance& each = instances[i];
    const Contents& model = models[static_cast<size_t>(building::choose_model(each, plan))];
    SetPiece piece;
    piece.name = instances.size() == 1 ? fmt::format("'{}'", plan.name)
                                       : fmt::format("instance {} of '{}'", i + 1, plan.name);
    piece.where = plan.where;
    piece.floating = plan.floating || !model.lights.empty();
    for (const Solid& solid : model.solids) {
      Solid here = moved(solid, each.transform);
      if (plan.material) here.material = plan.material;
      here.name = plan.name;
      piece.solids.push_back(std::move(here));
    }
    set.pieces.push_back(std::move(piece));
    for (const auto& [name, points] : model.lights) {
      SetLight light{plan.name + "/" + name, plan.where, {}};
      for (const Vec3d& p : points) light.points.push_back(each.transform.point(p));
      set.lights.push_back(std::move(light));
    }
  }
}

SourceLocation location_of(const Loaded& scene, const std::string& name,
                           std::initializer_list<const char*> kinds) {
  for (const char* kind : kinds)
    if (const auto* declared = scene.provenance.find(kind, name)) return declared->where;
  return {};
}

}  // namespace

Set set_of(const Loaded& scene, const shot::Shot& part) {
  Set set;
  for (const shot::ObjectPlan& object : shot::shown_objects(part)) {
    SetPiece piece;
    piece.name = fmt::format("'{}'", object.name);
    piece.where = location_of(scene, object.name, {"object", "mesh", "volume"});
    piece.floating = object.floating;
    piece.solids = solids_of(object);
    piece.modelled = std::none_of(piece.solids.begin(), piece.solids.end(),
                                  [](const Solid& solid) { return solid.mesh != nullptr; });
    set.pieces.push_back(std::move(piece));
  }
  for (const auto& [name, light] : part.lights)
    if (!light->is_infinite())
      set.lights.push_back({name, location_of(scene, name, {"light"}), points_of(*light)});
  for (const shot::PointInstancer& plan : part.instancers) add_instances(scene.shot, plan, set);
  return set;
}

const Solid* rock_at(const Set& set, const Vec3d& p, IsOpen is_open, Accuracy accuracy) {
  for (const SetPiece& piece : set.pieces)
    for (const Solid& solid : piece.solids)
      if (solid.contains(p, accuracy) && !(solid.*is_open)(p)) return &solid;
  return nullptr;
}

}  // namespace vug::loading
