// SPDX-License-Identifier: Apache-2.0
// Partial render files: round trips, errors of damaged files, and merging.
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/scratch_folder.h>
#include <vug/render/film/partial_render.h>

#include <gtest/gtest.h>

#include "scenes.h"

namespace vug::render {
namespace {
namespace fs = std::filesystem;

Scene lit_floor() {
  Scene scene;
  scene.camera = view({0, 1.5, 4}, {0, 0.5, 0}, 1.1);
  scene.objects = {object(floor_mesh(4), 0.5)};
  scene.lights = {make_light("sky", {{"radiance", Vec3d(0.1, 0.2, 0.3)}})};
  return scene;
}

class PartialRenders : public ::testing::Test {
 protected:
  fs::path file(const std::string& name) const { return folder_ / name; }
  fs::path part(const std::string& name, const Options& o, const RenderSlice& slice) const {
    RenderState state = begin_render(o, slice);
    Progress progress;
    continue_render(lit_floor(), o, state, {}, progress);
    write_partial_render(file(name), partial_render_header(o), state);
    return file(name);
  }
  /// The error message of merging; empty without an error.
  std::string merge_error(const std::vector<fs::path>& paths) const {
    try {
      merge(paths);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::bad_input);
      return error.what();
    }
    return "";
  }

 private:
  const ScratchFolder scratch_{"vug_parts"};
  const std::filesystem::path& folder_ = scratch_.path();
};

Options small() {
  Options o = options(64, 48, 12, 2);
  o.aovs = plan_aovs({"all"}, {});
  return o;
}

TEST_F(PartialRenders, MergeToTheBitsOfTheWhole) {
  const Options o = small();
  const std::vector<fs::path> paths = {part("c", o, {1, 2, 0, 0}), part("a", o, {0, 2, 8, 12}),
                                       part("b", o, {0, 2, 0, 8})};
  const PartialRender whole = merge(paths);
  EXPECT_EQ(develop(whole.state, whole.header.aovs), render(lit_floor(), o));
}

TEST_F(PartialRenders, DeepPicturesMergeToTheBytesOfTheWhole) {
  Options o = small();
  o.deep.emplace().tolerance = 0.03;
  image::DeepImage whole;
  const image::Image picture = render(lit_floor(), o, Progress::none(), {}, &whole);
  std::vector<fs::path> paths;
  for (const auto& [threads, slice] :
       {std::pair(7, RenderSlice{1, 2, 0, 0}), {1, {0, 2, 8, 12}}, {2, {0, 2, 0, 8}}}) {
    o.threads = threads;
    paths.push_back(part(std::to_string(threads), o, slice));
  }
  const PartialRender merged = merge(paths);
  ASSERT_TRUE(merged.header.deep);
  EXPECT_EQ(develop(merged.state, *merged.header.deep).pixels, whole.pixels);
  EXPECT_EQ(develop(merged.state, merged.header.aovs), picture);
  o.deep->tolerance = 0.04;
  EXPECT_NE(merge_error({paths[0], part("other", o, {0, 2, 0, 0})}).find("different deep pictures"),
            std::string::npos);
}

TEST_F(PartialRenders, InvalidFragmentsAreRejected) {
  Options o = small();
  o.deep.emplace();
  const PartialRenderHeader header = partial_render_header(o);
  const auto refused = [&](const std::vector<DeepFragment>& fragments) {
    RenderState state = begin_render(o, {1, 3, 2, 9});
    state.film.fragments(5, 20) = fragments;
    write_partial_render(file("f"), header, state);
    try {
      EXPECT_EQ(read_partial_render(file("f")).state.film.fragments(5, 20), fragments);
    } catch (const Error& error) {
      return error.code() == ErrorCode::bad_input;
    }
    return false;
  };
  const DeepFragment first{2, 1, 1, 0, 0, 0}, last{8, 3, 0.5f, 1, 2, 3};
  EXPECT_FALSE(refused({first, last}));
  EXPECT_TRUE(refused({last, first}));
  EXPECT_TRUE(refused({first, first}));
  EXPECT_TRUE(refused({{1, 1, 1, 0, 0, 0}}));
  EXPECT_TRUE(refused({{9, 1, 1, 0, 0, 0}}));
  EXPECT_TRUE(refused({{3, std::numeric_limits<float>::quiet_NaN(), 1, 0, 0, 0}}));
  EXPECT_TRUE(refused({{3, 1, 1, 0, std::numeric_limits<float>::infinity(), 0}}));
}

TEST_F(PartialRenders, RoundTrip) {
  const Options o = small();
  PartialRenderHeader header = partial_render_header(o);
  header.identity = "abc", header.notes = {{"half", "true"}, {"", "empty name"}};
  RenderState state = begin_render(o, {1, 3, 2, 9});
  write_partial_render(file("early"), header, state);
  state.converged[1] = 1, state.done[0] = 5;
  state.film.at(0, 20).samples = 7;
  write_partial_render(file("p"), header, state);
  const PartialRender back = read_partial_render(file("p"));
  EXPECT_EQ(back.header, header);
  EXPECT_EQ(back.state.done, state.done);
  EXPECT_EQ(back.state.converged, state.converged);
  EXPECT_EQ(back.state.film.at(0, 20), state.film.at(0, 20));
  EXPECT_EQ(read_partial_render_info(file("p")).fraction, state.fraction());
  EXPECT_EQ(read_partial_render_info(file("early")).fraction, 0);
  EXPECT_EQ(read_partial_render_info(file("p")).region, state.region);
}

TEST_F(PartialRenders, MismatchesAreNamed) {
  const Options o = small();
  const fs::path top = part("top", o, {0, 2, 0, 0}), low = part("low", o, {1, 2, 0, 0});
  Options other = o;
  other.seed = 3;
  EXPECT_NE(merge_error({top, part("seed", other, {1, 2, 0, 0})}).find("seeds, 0 and 3"),
            std::string::npos);
  other = o, other.width = 65;
  EXPECT_NE(
      merge_error({top, part("size", other, {1, 2, 0, 0})}).find("sizes, 64 x 48 and 65 x 48"),
      std::string::npos);
  EXPECT_NE(merge_error({top, low, low}).find("both have the samples 0..12"), std::string::npos);
  EXPECT_NE(merge_error({top}).find("samples 0..12 of the pixels x 0..63, y 24..47 are missing"),
            std::string::npos);
  EXPECT_NE(merge_error({top, part("some", o, {1, 2, 0, 7})}).find("samples 7..12"),
            std::string::npos);
  RenderState state = begin_render(o, {1, 2, 0, 0});
  PartialRenderHeader header = partial_render_header(o);
  write_partial_render(file("begun"), header, state);
  EXPECT_NE(merge_error({top, file("begun")}).find("only 0 % complete"), std::string::npos);
  header.identity = "another scene";
  std::fill(state.done.begin(), state.done.end(), state.end);
  write_partial_render(file("scene"), header, state);
  EXPECT_NE(merge_error({top, file("scene")}).find("different scenes"), std::string::npos);
  EXPECT_EQ(merge_error({low, top}), "");
}

TEST_F(PartialRenders, DamagedFilesAreRejected) {
  Options o = small();
  o.deep.emplace();
  const std::string whole = read_text(part("p", o, {}));
  const auto refused = [&](const std::string& text) {
    write_text(file("broken"), text);
    try {
      read_partial_render(file("broken"));
    } catch (const Error& error) {
      return error.code() == ErrorCode::bad_input;
    }
    return false;
  };
  for (const size_t cut : {size_t{0}, size_t{7}, size_t{40}, whole.size() / 2, whole.size() - 1})
    EXPECT_TRUE(refused(whole.substr(0, cut))) << cut;
  EXPECT_TRUE(refused(whole + "x"));
  for (size_t at = 0; at < whole.size(); at += at < 400 ? 1 : 19997) {
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 0x41);
    ASSERT_TRUE(refused(changed)) << at;
  }
  EXPECT_THROW(read_partial_render(file("none")), Error);
}

}  // namespace
}  // namespace vug::render
