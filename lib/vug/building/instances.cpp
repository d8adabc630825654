#include <vug/base/memory.h>
#include <vug/building/instance_source.h>
#include <vug/building/instances.h>
#include <vug/building/make_mesh.h>
#include <vug/building/merge_copies.h>
#include <vug/render/geometry/require_static.h>
#include <vug/render/kinds.h>
#include <vug/render/lighting/transformed_light.h>
#include <vug/shot/queries.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::building {
namespace {

/// Of an instance, in the renderer and here.
constexpr double kInstanceBytes = 2000;
/// More of them than that are fewer: see merge_copies.
constexpr size_t kManyInstances = 50000;

/// What mattes call an object's material: its name, or `otherwise` when it has none.
std::string material_name(const shot::Shot& shot, const render::MaterialPtr& of,
                          const std::string& otherwise) {
  if (!of) return "default";
  for (const auto& [name, material] : shot.materials)
    if (material == of) return name;
  return otherwise;
}

render::Object made(Builder& builder, const shot::ObjectPlan& plan) {
  render::Object object{plan.name,
                        plan.direct ? nullptr : builder.mesh(plan.mesh),
                        plan.material,
                        plan.flat,
                        Vec3f(plan.emission),
                        plan.light_group,
                        material_name(builder.shot(), plan.material, plan.name),
                        builder.solid(plan.mesh)};
  if (!plan.direct) object.elements = shot::element_names(*plan.mesh);
  if (plan.direct) {
    object.surface = builder.surface(plan.mesh);
    object.color = plan.mesh->paint;
  }
  return object;
}

Cast cast_of(Builder& builder, const shot::Model& model) {
  if (model.scene) {
    BuildOptions options = builder.options();
    options.max_memory = builder.room();
    Builder other(*model.scene, options, builder.progress());
    return cast_of(other);
  }
  Cast cast;
  if (model.mesh) cast.objects.push_back(made(builder, shot::plain_object(model.mesh)));
  for (const shot::ObjectPlan& object : builder.shot().objects)
    if (!model.mesh && object.name == model.name) cast.objects.push_back(made(builder, object));
  return cast;
}

Transform transform_of(const render::Affine& a) {
  return {Vec3d(a.x), Vec3d(a.y), Vec3d(a.z), Vec3d(a.origin)};
}

/// Where something goes: one transform, or those of several moments.
using Way = std::vector<Transform>;

render::PlacingPtr moved(Way way, const render::PlacingPtr& own) {
  if (own)
    for (Transform& place : way) place = place * transform_of(own->at(0));
  return std::make_shared<const render::Placing>(way);
}

/// Puts all of a model where it belongs, under the name of the place.
void put(const Cast& model, const Place& place, const Way& way, const shot::PlacePlan& plan,
         const std::string& name, const std::string& material, Cast& cast) {
  const bool single = model.objects.size() == 1;
  const auto renamed = [&](const std::string& own) { return single ? name : name + "/" + own; };
  for (const render::Object& object : model.objects) {
    render::Object here = object;
    here.name = renamed(object.name);
    here.placing = moved(way, object.placing);
    if (plan.material) {
      here.material = plan.material;
      here.material_name = material;
      here.looks_by_place = true;
    }
    render::require_still(here);
    cast.objects.push_back(std::move(here));
  }
  for (const render::LightPtr& light : model.lights) {
    if (light->is_infinite()) continue;
    render::LightLinking linking = light->linking();
    for (std::vector<std::string>* names : {&linking.only, &linking.except})
      std::transform(names->begin(), names->end(), names->begin(), renamed);
    cast.lights.push_back(render::transformed_light(light, place.transform, std::move(linking)));
  }
}

int chosen(const Place& place, const shot::PlacePlan& plan) {
  const auto count = static_cast<int>(plan.of.size());
  if (place.model >= count)
    throw Error(ErrorCode::bad_input,
                fmt::format("a place asks for thing number {}, but the last of '{}' is number {}",
                            place.model, plan.name, count - 1));
  if (place.model >= 0 || count == 1) return std::max(place.model, 0);
  double total = 0;
  for (int i = 0; i < count; ++i)
    total += plan.shares.empty() ? 1 : plan.shares[static_cast<size_t>(i)];
  double at = RandomStream(place.key.at("model")).uniform() * total;
  for (int i = 0; i < count - 1; ++i) {
    at -= plan.shares.empty() ? 1 : plan.shares[static_cast<size_t>(i)];
    if (at < 0) return i;
  }
  return count - 1;
}

std::vector<Place> places_of(Builder& builder, const shot::PlacePlan& plan) {
  std::vector<Place> places;
  for (size_t i = 0; i < plan.at.size(); ++i) try {
      const std::vector<Place> more = (*plan.at[i])(builder, plan.key.at(i));
      places.insert(places.end(), more.begin(), more.end());
    } catch (const Error& error) {
      if (error.where().known()) throw;
      throw error.at(plan.where);
    }
  return places;
}

std::string why_none(Builder& builder, const shot::PlacePlan& plan) {
  for (size_t i = 0; i < plan.at.size(); ++i)
    if (const auto* known = plan.at[i]->target<NumberedPlaces>(); known && known->why_none)
      if (std::string why = known->why_none(builder, plan.key.at(i)); !why.empty()) return why;
  return "its places are all masked out, or what they come from is empty";
}

bool same(const Transform& a, const Transform& b) {
  return a.origin() == b.origin() && a.column(0) == b.column(0) && a.column(1) == b.column(1) &&
         a.column(2) == b.column(2);
}

/// The way of each place through the moments; a single transform where it stands still, whatever
/// else of the declaration moves.
std::vector<Way> ways_of(Builder& builder, const shot::PlacePlan& plan,
                         const std::vector<Place>& places, const Moments& moments) {
  std::vector<Way> still, ways(places.size());
  for (const Place& place : places) still.push_back({place.transform});
  for (const auto& moment : moments) {
    const auto other =
        std::find_if(moment->places.begin(), moment->places.end(),
                     [&](const shot::PlacePlan& each) { return each.name == plan.name; });
    if (other == moment->places.end()) return still;
    const std::vector<Place> there = other->at == plan.at ? places : places_of(builder, *other);
    if (there.size() != places.size()) return still;
    for (size_t i = 0; i < ways.size(); ++i) ways[i].push_back(there[i].transform);
  }
  if (moments.empty()) return still;
  for (Way& way : ways)
    if (std::all_of(way.begin(), way.end(), [&](const auto& each) { return same(each, way[0]); }))
      way.resize(1);
  return ways;
}

void put_all(Builder& builder, const shot::PlacePlan& plan, const Moments& moments, Cast& cast) {
  std::vector<Cast> models;
  for (const shot::Model& model : plan.of) models.push_back(cast_of(builder, model));
  const std::string material = material_name(builder.shot(), plan.material, plan.name);
  const std::vector<Place> places = places_of(builder, plan);
  if (places.empty())
    builder.warn(plan.where, fmt::format("'{}' stands nowhere", plan.name),
                 why_none(builder, plan));
  const auto instances = [&] {
    size_t count = 0;
    for (const Place& place : places)
      count += models[static_cast<size_t>(chosen(place, plan))].objects.size();
    return count;
  };
  if (places.size() > 1 && instances() > kManyInstances)
    for (Cast& model : models) model.objects = merge_copies(model.objects);
  require_memory(kInstanceBytes * static_cast<double>(instances()), builder.room(),
                 fmt::format("{} instances", instances()), "place fewer");
  const std::vector<Way> ways = ways_of(builder, plan, places, moments);
  for (size_t i = 0; i < places.size(); ++i)
    put(models[static_cast<size_t>(chosen(places[i], plan))], places[i], ways[i], plan,
        plan.apart ? fmt::format("{}/{}", plan.name, i + 1) : plan.name, material, cast);
}

}  // namespace

void light_plainly(Cast& cast, const render::Medium* medium) {
  const auto shines = [](const render::Object& object) {
    return !render::is_black(object.emission) || (object.material && object.material->is_emissive());
  };
  if (!cast.lights.empty() || (medium && medium->is_emissive()) ||
      std::any_of(cast.objects.begin(), cast.objects.end(), shines))
    return;
  cast.lights.push_back(render::make_light("sky", {{"radiance", Vec3d(0.9, 0.95, 1)}}));
}

Cast cast_of(Builder& builder, const Moments& moments) {
  const shot::Shot& shot = builder.shot();
  const std::vector<shot::ObjectPlan> shown = shot::shown_objects(shot);
  for (const shot::ObjectPlan& object : shown)
    object.direct ? builder.require_surface_room(object.mesh) : builder.require_room(object.mesh);
  Cast cast;
  for (const shot::ObjectPlan& object : shown) cast.objects.push_back(made(builder, object));
  for (const auto& [name, light] : shot.lights) cast.lights.push_back(light);
  for (const shot::PlacePlan& plan : shot.places) {
    try {
      put_all(builder, plan, moments, cast);
    } catch (const Error& error) {
      if (error.code() != ErrorCode::bad_input || error.where().line > 0) throw;
      throw error.at(plan.where);
    }
  }
  return cast;
}

}  // namespace vug::building
