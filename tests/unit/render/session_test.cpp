// SPDX-License-Identifier: Apache-2.0
// Sessions: the picture after any sequence of changes has the bytes of a new render, and a change
// builds only what it affects.
#include <vug/base/rng.h>
#include <vug/render/session.h>

#include <gtest/gtest.h>

#include "scenes.h"

namespace vug::render {
namespace {

/// A room with a lamp and an opening, instances of two meshes, and a cut-out leaf.
class Room {
 public:
  Room() {
    mesh::Mesh walls = mesh::box_mesh({Vec3d(-2), Vec3d(2)});
    walls.triangles.pop_back();
    scene.camera = view({1, 0, 1.5}, {-1, 0, -1}, 1.2);
    scene.objects = {object(std::move(walls), 0.6),
                     object(mesh::box_mesh({Vec3d(-0.2), Vec3d(0.2)}), 0.4)};
    scene.objects[1].name = "block";
    for (const double x : {-1.0, 0.0, 1.0}) {
      Object stone = object(mesh::sphere_mesh(Vec3d(0), 0.2, 2), 0.5);
      if (x > -1)
        stone.mesh = scene.objects.back().mesh, stone.material = scene.objects.back().material;
      stone.name = "stone";
      stone.instance = place({x, -1.5, -1});
      scene.objects.push_back(stone);
    }
    Object leaf = object(at_height(floor_mesh(0.5f), -1), 0.5);
    leaf.material = make_material("surface", {{"opacity", 0.5}});
    leaf.name = "leaf";
    scene.objects.push_back(leaf);
    scene.lights = {make_light("sky", {{"radiance", Vec3d(1)}}), lamp(0)};
  }
  static InstanceTransformPtr place(const Vec3d& at) {
    return std::make_shared<const InstanceTransform>(Transform::translation(at));
  }
  static LightPtr lamp(double x) {
    return make_light("sphere", {{"center", Vec3d(x, 0, -0.5)}, {"radius", 0.1}});
  }

  Scene scene;
};

TEST(Session, EveryChangeGivesThePictureOfANewRender) {
  Room room;
  Options o = options(24, 16, 8, 3);
  Session session;
  RandomStream random(RandomKey(7));
  const auto number = [&](double low, double high) {
    return low + (high - low) * random.uniform();
  };
  for (int step = 0; step < 40; ++step) {
    std::vector<Object>& objects = room.scene.objects;
    switch (random.below(9)) {
      case 0:
        room.scene.camera = view({number(0, 1.5), 0, 1.5}, {-1, 0, -1}, 1.05);
        break;
      case 1:
        room.scene.lights.back() = Room::lamp(number(-1, 1));
        break;
      case 2:
        objects[1].mesh =
            std::make_shared<mesh::Mesh>(mesh::box_mesh({Vec3d(-0.2), Vec3d(number(0.2, 0.5))}));
        break;
      case 3:
        objects[random.below(6)].material =
            make_material("lambert", {{"albedo", Vec3d(number(0.1, 0.9))}});
        break;
      case 4:
        objects[2].instance = Room::place({number(-1, 1), -1.5, -1});
        break;
      case 5:
        objects[3].mesh =
            std::make_shared<mesh::Mesh>(mesh::sphere_mesh(Vec3d(0), number(0.1, 0.3), 2));
        break;
      case 6:
        objects[5].material = make_material("surface", {{"opacity", number(0.2, 1)}});
        break;
      case 7:
        o.spp = 1 + static_cast<int>(random.below(8));
        o.threads = std::array{1, 2, 7}[random.below(3)];
        break;
      default:
        o.noise = o.noise > 0 ? 0 : 0.3;
    }
    session.set_options(o);
    session.set_scene(room.scene);
    if (random.below(3) == 0) session.proceed(1 + random.below(4));  // and the next change comes
    if (random.below(3) == 0) continue;
    ASSERT_TRUE(session.proceed(static_cast<uint32_t>(o.spp)));
    ASSERT_EQ(session.image(), render(room.scene, o)) << "step " << step;
  }
  EXPECT_GT(session.counters().trees.reused, 40u);
}

/// The work of a session for one change.
struct Work {
  size_t built, reused, scenes, restarts;
  bool operator==(const Work&) const = default;
};

TEST(Session, AChangeBuildsOnlyWhatItAffects) {
  Room room;
  const Options o = options(16, 16, 4, 2);
  Session session;
  session.set_options(o);
  const auto work = [&] {
    const SessionCounters before = session.counters();
    session.set_scene(room.scene);
    session.proceed(4);
    const SessionCounters& now = session.counters();
    return Work{now.trees.built - before.trees.built, now.trees.reused - before.trees.reused,
                now.scenes - before.scenes, now.restarts - before.restarts};
  };
  // The triangles of the room, those of Embree, and the sphere that instances share.
  EXPECT_EQ(work(), (Work{3, 0, 1, 1}));
  EXPECT_EQ(work(), (Work{0, 0, 0, 0})) << "nothing has changed";
  room.scene.camera = view({0.5, 0, 1.5}, {-1, 0, -1}, 1.2);
  EXPECT_EQ(work(), (Work{0, 0, 0, 1}));
  room.scene.lights.back() = Room::lamp(0.5);
  EXPECT_EQ(work(), (Work{0, 3, 1, 1}));
  room.scene.objects[0].material = make_material("lambert", {{"albedo", Vec3d(0.2)}});
  EXPECT_EQ(work(), (Work{0, 3, 1, 1}));
  room.scene.objects[3].instance = Room::place({0.1, -1.5, -1});
  EXPECT_EQ(work(), (Work{1, 2, 1, 1})) << "the places of the instances";
  room.scene.objects[1].mesh =
      std::make_shared<mesh::Mesh>(mesh::box_mesh({Vec3d(-0.3), Vec3d(0.3)}));
  EXPECT_EQ(work(), (Work{1, 2, 1, 1})) << "the triangles in world space";
  room.scene.objects[1].mesh = std::make_shared<mesh::Mesh>(*room.scene.objects[1].mesh);
  EXPECT_EQ(work(), (Work{0, 3, 1, 1})) << "an equal mesh";
}

TEST(Session, SetsCameraAndLights) {
  Room room;
  const Options o = options(16, 16, 2, 2);
  Session session;
  session.set_options(o);
  session.set_scene(room.scene);
  EXPECT_EQ(session.image().width, 16);
  room.scene.camera = view({0.5, 0, 1.5}, {-1, 0, -1}, 1.2);
  room.scene.lights = {Room::lamp(0.3)};
  session.set_camera(room.scene.camera);
  session.set_lights(room.scene.lights);
  EXPECT_TRUE(session.proceed(std::chrono::hours(1)));
  EXPECT_EQ(session.image(), render(room.scene, o));
  EXPECT_EQ(session.counters().samples, 16u * 16 * 2);
}

TEST(Session, ContinuesAfterCancellation) {
  Room room;
  const Options o = options(32, 32, 8, 3);
  Session session;
  session.set_options(o);
  session.set_scene(room.scene);
  session.proceed(2);
  Progress cancelled;
  cancelled.cancel();
  EXPECT_THROW(session.proceed(8, cancelled), Error);
  const size_t restarts = session.counters().restarts;
  EXPECT_TRUE(session.proceed(8));
  EXPECT_EQ(session.counters().restarts, restarts);
  EXPECT_EQ(session.image(), render(room.scene, o));
}

/// With kept learning a new camera trains nothing; the picture is another estimate of the same.
TEST(Session, KeepsWhatItLearnedOnRequest) {
  Room room;
  Options o = options(32, 32, 64, 3);
  o.integrator = make_integrator("path", {{"guide", Value::Name{"on"}}, {"max_bounces", 3}});
  Session exact, kept(Learning::kept);
  for (Session* each : {&exact, &kept}) {
    each->set_options(o);
    each->set_scene(room.scene);
    each->proceed(1);
    each->set_camera(view({0.9, 0, 1.5}, {-1, 0, -1}, 1.2));
    each->proceed(64);
  }
  EXPECT_EQ(exact.counters().trainings, 2u);
  EXPECT_EQ(kept.counters().trainings, 1u);
  const Mean a = mean_of(exact.image(), "G"), b = mean_of(kept.image(), "G");
  EXPECT_NEAR(a.value, b.value, 0.05 * a.value);
  kept.set_lights({Room::lamp(0.3)});
  kept.proceed(1);
  EXPECT_EQ(kept.counters().trainings, 2u) << "what was learned belongs to the lights";
  o.integrator = make_integrator("path", {{"guide", Value::Name{"on"}}, {"max_bounces", 2}});
  kept.set_options(o);
  kept.proceed(1);
  EXPECT_EQ(kept.counters().trainings, 3u) << "and to the integrator";
}

}  // namespace
}  // namespace vug::render
