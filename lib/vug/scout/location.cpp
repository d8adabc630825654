// SPDX-License-Identifier: Apache-2.0
#include <vug/scout/choose.h>
#include <vug/scout/location.h>
#include <vug/scout/trace_view.h>

#include <algorithm>

namespace vug::scout {
namespace {

constexpr size_t kEnough = 20;  // places to stand

/// Points along the legs of the networks, every two metres.
void add_axes(const shot::Shot& shot, std::vector<Vec3d>& points) {
  constexpr double kSpacing = 2;
  for (const shot::NetworkPlan& plan : shot.networks)
    for (const network::Leg& leg : plan.network->legs) {
      if (leg.surface) continue;
      const Vec3d from = plan.network->stations[static_cast<size_t>(leg.from)].position;
      const Vec3d way = network::leg_vector(*plan.network, leg);
      const int steps = 1 + static_cast<int>(way.length() / kSpacing);
      for (int i = 0; i <= steps; ++i)
        points.push_back(from + way * (i / static_cast<double>(steps)));
    }
}

bool is_figure(const Box3d& box) {
  const Vec3d size = box.size();
  return size.y > 1.4 && size.y < 2.2 && size.x < 1.2 && size.z < 1.2;
}

}  // namespace

Location prepare_location(building::Builder& builder, const picture::PicturePlan& plan,
                          bool relight) {
  picture::PicturePlan plain = plan;
  auto part = std::make_shared<shot::Shot>(*plan.shown);
  for (shot::ObjectPlan& object : part->objects) object.detail.reset();
  plain.shown = part;
  plain.render.settings.camera = nullptr;  // the poses are cameras, and no warning concerns it
  Location out;
  out.scene = picture::build_scene(builder, plain);
  const auto shines = [](const render::Object& object) {
    return !render::is_black(object.emission) ||
           (object.material && object.material->is_emissive());
  };
  out.lit = std::any_of(out.scene.objects.begin(), out.scene.objects.end(), shines);
  std::vector<render::LightPtr>& lights = out.scene.lights;
  if (part->lights.empty() && part->instancers.empty() && !out.lit) lights.clear();  // the default
  if (relight) std::erase_if(lights, [](const auto& each) { return !each->is_infinite(); });
  out.sky_shines = std::any_of(lights.begin(), lights.end(),
                               [](const auto& each) { return each->is_infinite(); });
  out.lit = !relight && (out.lit || !lights.empty());
  out.world = std::make_shared<const render::PreparedScene>(out.scene);
  for (const shot::CameraPlan& camera : builder.shot().cameras)
    out.starts.emplace_back(camera.camera->position());
  add_axes(builder.shot(), out.starts);
  return out;
}

std::vector<Stand> places_to_stand(const Location& location) {
  const auto reached = [&](const std::vector<Vec3d>& starts) {
    std::vector<Vec3d> free;
    for (const Vec3d& each : starts)
      if (clearance(*location.world, each) > 0) free.push_back(each);
    std::vector<Stand> floor = walkable_floor(*location.world, free);
    const auto is_open = [](const Stand& stand) { return stand.headroom == kInfinity; };
    const auto open = std::count_if(floor.begin(), floor.end(), is_open);
    if (floor.size() >= kEnough + static_cast<size_t>(open)) std::erase_if(floor, is_open);
    return floor;
  };
  std::vector<Stand> floor = reached(location.starts);
  if (floor.size() < kEnough)
    if (std::vector<Stand> more = reached(points_in_air(*location.world));
        more.size() > floor.size())
      floor = std::move(more);
  if (floor.empty())
    throw Error(ErrorCode::bad_input, "the scene has no floor to stand on", {},
                "place a camera above a floor that is level enough to walk on, below 50 degrees");
  return floor;
}

Landmarks find_landmarks(const Location& location, const std::vector<View>& views) {
  std::map<uint32_t, double> shares;
  for (const View& view : views)
    for (const auto& [object, share] : object_shares(view))
      shares[object] += share / static_cast<double>(views.size());
  Landmarks out;
  for (const auto& [object, share] : shares) {
    const double weight = 1 - 5 * share;
    if (weight > 0) out.weights[object] = weight;
    if (object != kSky && is_figure(render::object_bounds(location.scene.objects[object])))
      out.known_size[object] = true;
  }
  return out;
}

std::vector<Subject> find_subjects(const Location& location, const Landmarks& landmarks) {
  constexpr double kLargest = 12;
  std::vector<Subject> out;
  for (const auto& [object, weight] : landmarks.weights) {
    if (object == kSky) continue;
    const Box3d box = render::object_bounds(location.scene.objects[object]);
    if (box.isEmpty() || box.size().length() > kLargest) continue;
    out.push_back({box.center(), box.size().length()});
  }
  return out;
}

}  // namespace vug::scout
