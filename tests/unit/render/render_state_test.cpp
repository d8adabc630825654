// SPDX-License-Identifier: Apache-2.0
// Pictures rendered in slices, in passes and adaptively.
#include <vug/base/error.h>
#include <vug/render/film/render_state.h>

#include <gtest/gtest.h>

#include "scenes.h"

namespace vug::render {
namespace {

Scene floor_with_two_lights() {
  Scene scene;
  scene.camera = view({0, 1.5, 4}, {0, 0.5, 0}, 1.1);
  scene.objects = {object(floor_mesh(4), 0.5)};
  scene.lights = {make_light("sphere", {{"center", Vec3d(0.8, 1.4, 0)}, {"radius", 0.2}}),
                  make_light("sky", {{"radiance", Vec3d(0.1, 0.2, 0.3)}})};
  return scene;
}

RenderState rendered(const Options& o, const RenderSlice& slice = {},
                     const RenderCallbacks& callbacks = {}) {
  RenderState state = begin_render(o, slice);
  Progress progress;
  continue_render(floor_with_two_lights(), o, state, callbacks, progress);
  return state;
}

TEST(RenderState, SlicesHaveTheBitsOfTheWhole) {
  Options o = options(50, 37, 10, 2);
  o.aovs = plan_aovs({"all"}, {});
  const image::Image whole = render(floor_with_two_lights(), o);
  o.threads = 1;
  RenderState joint = begin_render(o);
  for (const int tile : {2, 0, 1})
    for (const auto& [begin, end] : {std::pair(7u, 10u), {0u, 3u}, {3u, 7u}}) {
      o.threads = 1 + (tile + static_cast<int>(begin)) % 3;
      joint.film.merge(rendered(o, {tile, 3, begin, end}).film);
    }
  EXPECT_EQ(develop(joint, o.aovs), whole);
}

TEST(RenderState, PassesHaveTheBitsOfTheWhole) {
  const Options o = options(50, 37, 21, 2);
  std::vector<uint32_t> seen;
  RenderCallbacks callbacks;
  callbacks.pass = [&](const RenderState& state) { seen.push_back(state.done[3]); };
  EXPECT_EQ(develop(rendered(o, {}, callbacks), o.aovs), render(floor_with_two_lights(), o));
  EXPECT_EQ(seen, (std::vector<uint32_t>{4, 8, 16, 21}));
}

TEST(RenderState, SavingChangesNoDecision) {
  Options o = options(40, 30, 700, 1);
  o.noise = 0.03;
  RenderCallbacks callbacks;
  callbacks.save_every = 0;
  int saves = 0;
  callbacks.save = [&](const RenderState&) { ++saves; };
  EXPECT_EQ(develop(rendered(o, {}, callbacks), o.aovs), render(floor_with_two_lights(), o));
  EXPECT_GT(saves, 0);
}

TEST(RenderState, CancelledRendersCanBeResumed) {
  for (const double noise : {0.0, 0.08}) {
    Options o = options(50, 37, 64, 2);
    o.noise = noise;
    const image::Image whole = render(floor_with_two_lights(), o);
    RenderState kept = begin_render(o);
    for (int stop = 0; stop < 12; ++stop) {
      // Saves after every tile, and cancels after some of them.
      RenderState state = kept;
      Progress progress;
      int saves = 0;
      RenderCallbacks callbacks;
      callbacks.save_every = 0;
      callbacks.save = [&](const RenderState& now) {
        if (progress.cancelled()) return;
        kept = now;
        if (++saves == 1 + 2 * stop) progress.cancel();
      };
      try {
        continue_render(floor_with_two_lights(), o, state, callbacks, progress);
        break;
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::cancelled);
      }
    }
    EXPECT_GT(kept.fraction(), 0);
    Progress progress;
    continue_render(floor_with_two_lights(), o, kept, {}, progress);
    EXPECT_TRUE(kept.complete());
    EXPECT_EQ(develop(kept, o.aovs), whole) << noise;
  }
}

TEST(RenderState, ACropHasThePixelsOfTheWhole) {
  Options o = options(50, 37, 4, 2);
  const image::Image whole = render(floor_with_two_lights(), o);
  o.crop = {11, 5, 31, 30};
  const image::Image part = render(floor_with_two_lights(), o);
  ASSERT_EQ(part.width, 20);
  ASSERT_EQ(part.height, 25);
  for (int y = 0; y < part.height; ++y)
    for (int x = 0; x < part.width; ++x)
      for (size_t c = 0; c < part.channels.size(); ++c)
        ASSERT_EQ(part.at(x, y, c), whole.at(x + 11, y + 5, c));
  o.crop = {0, 0, 51, 10};
  EXPECT_THROW(render(floor_with_two_lights(), o), Error);
}

TEST(RenderState, InvalidSlicesAreRejected) {
  Options o = options(50, 37, 4, 2);
  EXPECT_THROW(begin_render(o, {3, 3, 0, 0}), Error);
  EXPECT_THROW(begin_render(o, {0, 38, 0, 0}), Error);
  EXPECT_THROW(begin_render(o, {0, 1, 0, 5}), Error);
  EXPECT_THROW(begin_render(o, {0, 1, 3, 3}), Error);
  o.noise = 0.1;
  EXPECT_THROW(begin_render(o, {0, 2, 0, 0}), Error);
  EXPECT_THROW(begin_render(o, {0, 1, 0, 2}), Error);
}

}  // namespace
}  // namespace vug::render
