// SPDX-License-Identifier: Apache-2.0
// The whole loop: a random facade of the published grammar is carved, rendered with its depth,
// fitted again and compared with itself. VUG_LOOPS is the number of facades, VUG_LOOP_FIRST the
// first seed.
#include "../fit/random_facade.h"

#include <vug/base/median.h>
#include <vug/base/scratch_folder.h>
#include <vug/building/builder.h>
#include <vug/fit/polish/polish.h>
#include <vug/fit/to_facade.h>
#include <vug/loading/load.h>
#include <vug/picture/stereo_views.h>
#include <vug/session/facade_fit.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace vug::session {
namespace {

namespace fs = std::filesystem;

constexpr double kWidth = 12;              // metres of the facade
constexpr int kAcross = 240, kDown = 180;  // pixels
constexpr double kPixel = kWidth / kAcross;
constexpr int kLeast = 6;        // pixels; smaller elements cannot be recovered
constexpr double kTrust = 0.03;  // of facade_fit, with depth

constexpr const char* kScene = R"(
include "plain.vug"
volume stone = level_set(ripperda, voxel: 5cm)
volume other = level_set(infill(ripperda), voxel: 3cm)
mesh stone_mesh on stone {}
mesh other_mesh on other {}
object wall on stone_mesh { material lambert(albedo: (0.6, 0.55, 0.5)) }
object panes on other_mesh { material lambert(albedo: (0.1, 0.12, 0.15)) }
camera main { kind orthographic  eye (0, 4.5, 30)  target (0, 4.5, 0)  width 12m }
light even = sky(radiance: (1, 1, 1))
render main { size 240x180  spp 4  layers ["beauty", "Z"] }
)";

int number_of(const char* name, int otherwise) {
  const char* text = std::getenv(name);
  return text ? std::atoi(text) : otherwise;
}

/// The line with each occurrence of a whole word replaced.
std::string with_word(const std::string& line, const std::string& word, const std::string& by) {
  const auto letter = [&](size_t at) {
    return at < line.size() &&
           (std::isalnum(static_cast<unsigned char>(line[at])) || line[at] == '_');
  };
  std::string out;
  size_t from = 0;
  for (size_t at = line.find(word); at != std::string::npos; at = line.find(word, at + 1)) {
    if (letter(at + word.size()) || (at > 0 && letter(at - 1))) continue;
    out += line.substr(from, at - from) + by;
    from = at + word.size();
  }
  return out + line.substr(from);
}

/// The published rules in a wall of 1.2 m. Each kind of element is plain and has its own depth,
/// since without colours only the depth distinguishes them.
std::string plain_grammar() {
  std::ifstream file(VUG_DATA "/facades/ripperda.vug");
  std::string out, line;
  bool rules = false;
  while (std::getline(file, line)) {
    if (rules && line.find('#') == std::string::npos) {
      line = with_word(line, "window", "window(reveal: 20cm)");
      line = with_word(line, "door", "door(reveal: 36cm, panels: 0)");
      line = with_word(line, "doorway", "doorway(depth: 52cm)");
      line = with_word(line, "shop", "shop(reveal: 68cm, riser: 0, sign: 0, bays: 1)");
    }
    if (line.find("axiom") != std::string::npos) rules = true, line += "\n  thickness 1.2m";
    out += line + "\n";
  }
  return out;
}

constexpr auto number = fit::PixelTree::number;

/// A canonical name of a grid by its numbers: two lines have one distance, and windows of the same
/// size are equal.
std::string grid_of(const facade::Tree& tree, const facade::Node& node) {
  const double lines = std::max(number(node.numbers, "columns"), number(node.numbers, "rows"));
  double low[2] = {1e9, 1e9}, high[2] = {0, 0};
  for (const int child : node.children) {
    const facade::Node& part = tree.nodes[static_cast<size_t>(child)];
    if (part.symbol != "window") continue;
    const double sizes[2] = {part.rect.width, part.rect.height};
    for (size_t i = 0; i < 2; ++i)
      low[i] = std::min(low[i], sizes[i]), high[i] = std::max(high[i], sizes[i]);
  }
  const double most = 1.6 * kPixel;
  const bool alike = high[0] - low[0] < most && high[1] - low[1] < most;
  const bool even = node.symbol.rfind("Regular", 0) == 0 || lines <= 2;
  return std::string(even ? "Regular" : "") + (alike ? "IdenticalGrid" : "Grid");
}

/// Symbols without numbers.
std::string structure(const facade::Tree& tree, int at = 0) {
  const facade::Node& node = tree.nodes[static_cast<size_t>(at)];
  if (node.element) return "";
  if (node.symbol == "FacadeElement") return "Element";
  const bool grid = node.symbol.find("Grid") != std::string::npos;
  std::vector<std::string> below;
  for (const int child : node.children) below.push_back(structure(tree, child));
  std::sort(below.begin(), below.end());
  std::string out = (grid ? grid_of(tree, node) : node.symbol) + "(";
  for (const std::string& one : below) out += one.empty() ? "" : one + " ";
  return out + ")";
}

struct Openings {
  std::vector<facade::Rect> all;
  size_t windows = 0;
};

Openings openings_of(const facade::Tree& tree) {
  Openings out;
  for (const facade::ElementInstance& one : facade::element_instances(tree)) {
    const std::string& kind = tree.nodes[static_cast<size_t>(one.node)].element->kind();
    if (kind == "wall") continue;
    out.all.push_back(one.rect);
    out.windows += kind == "window" ? 1 : 0;
  }
  return out;
}

/// The distance in pixels of each to the nearest of the others.
void add_distances(const Openings& from, const Openings& to, std::vector<double>& out) {
  for (const facade::Rect& r : from.all) {
    double nearest = 1e9;
    for (const facade::Rect& other : to.all)
      nearest = std::min(nearest, std::max({std::abs(r.x - other.x), std::abs(r.y - other.y),
                                            std::abs(r.x + r.width - other.x - other.width),
                                            std::abs(r.y + r.height - other.y - other.height)}));
    out.push_back(nearest / kPixel);
  }
}

bool can_be_seen(const facade::Tree& tree) {
  for (const facade::Node& node : tree.nodes)
    if (std::max(number(node.numbers, "columns"), number(node.numbers, "rows")) > fit::kMaxLines)
      return false;
  for (const facade::ElementInstance& one : facade::element_instances(tree))
    if (std::min(one.rect.width, one.rect.height) < kLeast * kPixel) return false;
  return true;
}

/// The accepted results: the derived tree, and the shortest known tree of the facade on whole
/// pixels, if that differs.
std::vector<facade::Tree> right_answers(const facade::Tree& derived) {
  std::vector<facade::Tree> out = {derived};
  const facade::Rules text = facade::load_rules(VUG_DATA "/facades/ripperda.vug");
  const fit::Rules& rules = fit::ripperda();
  fit::PixelTree pixels(derived, rules, 1 / kPixel);
  std::vector<uint8_t> looks(static_cast<size_t>(kAcross * kDown), 0);
  const std::map<std::string, int> values = {{"window", 1}, {"door", 2}, {"shop", 3}};
  for (const fit::PixelTree::Painted& one : pixels.painted()) {
    const auto value = values.find(one.kind);
    fit::paint(looks, kAcross, one.rect, value == values.end() ? 4 : value->second);
  }
  const fit::Evidence clean = fit::Evidence::from_clusters(kAcross, kDown, 5, looks);
  fit::FitOptions how;
  how.pixel_weight = kTrust;
  how.sampler.steps = 5000;
  const fit::Model model(rules, how.limits, kAcross, kDown,
                         {&clean, fit::make_likelihood("kt", clean), how.pixel_weight});
  const auto add = [&](fit::TreeState state) {
    model.compute_areas(state);
    out.push_back(fit::to_facade_tree(text, model, state, {kPixel, kPixel}));
  };
  const fit::FitResult read = fit::fit_facade(clean, rules, how, RandomKey(2));
  const std::optional<fit::Tree> tree = pixels.tree(model);
  if (!tree) {
    add(model.make_state(read.tree));
    return out;
  }
  fit::TreeState best = model.make_state(*tree);
  const fit::EdgeHints hints = fit::EdgeHints::from_clusters(clean);
  const double bits = fit::polish({model, hints}, clean, best).after;
  add(best);
  if (read.report.bits < bits - 1e-6) add(model.make_state(read.tree));
  return out;
}

class FacadeLoop : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(folder_ / "plain.vug") << plain_grammar();
    std::ofstream(folder_ / "truth.vug") << kScene;
  }

  struct Result {
    bool count = false, windows = false, structure = false;
    std::vector<double> off;
  };

  /// Nothing if the facade cannot be recovered.
  std::optional<Result> read_back(uint64_t seed) const {
    loading::LoadOptions load_options;
    load_options.seed = seed;
    const loading::Loaded loaded = loading::load(folder_ / "truth.vug", load_options);
    EXPECT_TRUE(loaded.usable()) << loaded.report();
    const facade::Tree& truth = *loaded.shot.derivations.at(0).facade;
    if (!can_be_seen(truth)) return std::nullopt;
    building::Builder builder(loaded.shot, {});
    const std::vector<picture::RenderResult> rendered =
        picture::render_views(builder, picture::plan_picture(loaded.shot));
    picture::write_picture(folder_ / "photo.exr", picture::picture_views(rendered));

    FacadeFitOptions options;
    options.grammar = VUG_DATA "/facades/ripperda.vug";
    options.sampler.steps = 5000;
    options.doors_at_ground = false;  // Random derivations have doors on any floor.
    const FacadeFit found = fit_facade(read_facade_picture(folder_ / "photo.exr"), options);
    const Openings ours = openings_of(found.tree);
    const std::string text = structure(found.tree);
    Result out;
    std::string wanted;
    for (const facade::Tree& right : right_answers(truth)) {
      const Openings theirs = openings_of(right);
      out.count |= ours.all.size() == theirs.all.size();
      out.windows |= ours.windows == theirs.windows;
      out.structure |= text == structure(right);
      wanted += "\n  wanted " + structure(right);
    }
    add_distances(openings_of(truth), ours, out.off);
    if (!out.structure || !out.count) fmt::print("facade {}: found {}{}\n", seed, text, wanted);
    return out;
  }

  const ScratchFolder scratch_{"vug_facade_loop"};
  const std::filesystem::path& folder_ = scratch_.path();
};

TEST_F(FacadeLoop, CountsStructuresAndEdgesComeBack) {
  const int loops = number_of("VUG_LOOPS", 6), first = number_of("VUG_LOOP_FIRST", 0);
  int counts = 0, windows = 0, structures = 0, done = 0;
  std::vector<double> off;
  int seed = first;
  for (; done < loops; ++seed) {
    const auto result = read_back(static_cast<uint64_t>(seed));
    if (!result) continue;
    ++done;
    counts += result->count, windows += result->windows, structures += result->structure;
    off.insert(off.end(), result->off.begin(), result->off.end());
  }
  const double edges = median(off);
  fmt::print(
      "{} facades, {} of them fair: counts {}, windows alone {}, structures {}, {:.2f} pixels\n",
      seed - first, loops, counts, windows, structures, edges);
  // Slightly fewer for small numbers.
  EXPECT_GE(counts, 0.95 * loops - (loops < 30 ? 1 : 0));
  EXPECT_GE(structures, 0.8 * loops - (loops < 30 ? 1 : 0));
  EXPECT_LE(edges, 2);
}

}  // namespace
}  // namespace vug::session
