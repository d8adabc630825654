// SPDX-License-Identifier: Apache-2.0
#include <vug/base/median.h>
#include <vug/facade/grammar_output.h>
#include <vug/fit/evidence/cluster_image.h>
#include <vug/fit/learning/labelling.h>
#include <vug/fit/model/compile.h>
#include <vug/fit/to_facade.h>
#include <vug/loading/data_folders.h>
#include <vug/session/facade_fit.h>
#include <vug/session/facade_model.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vug::session {
namespace {

/// The class maps of the pixel classifier; empty without a classifier.
fit::Planes maps_of(const FacadePicture& picture, const FacadeFitOptions& options) {
  if (!options.classifier) return {};
  if (!picture.colours)
    throw Error(ErrorCode::bad_input, "a pixel classifier needs a photo with colours");
  return fit::enlarged(options.classifier->classify(*picture.colours), picture.width,
                       picture.height);
}

fit::Evidence evidence_of(const FacadePicture& picture, const fit::Planes& maps,
                          const FacadeFitOptions& options, RandomKey key) {
  if (options.classifier) return fit::classifier_evidence(maps, options.classifier->classes());
  fit::ClusterImage clusters =
      fit::cluster_image(picture.colours ? &*picture.colours : nullptr,
                         picture.depth ? &*picture.depth : nullptr, options.clusters, key);
  for (size_t i = 0; i < picture.outside.size(); ++i)
    if (picture.outside[i]) clusters.labels[i] = fit::kNoEvidence;
  return clusters.evidence();
}

/// Limits of doors and shops on a facade of that height: a sill above a few steps, or a door above
/// those of carriages, is a misread part of the wall.
fit::Limits limits_of(const FacadePicture& picture, double height) {
  constexpr double kMaxSill = 1, kMaxDoorHeight = 4.5;  // metres
  const auto pixels = [&](double metres) {
    return static_cast<int>(std::lround(metres * picture.height / height));
  };
  fit::Limits out;
  out.max_sill = pixels(kMaxSill);
  out.max_door_height = std::max(out.min_size, pixels(kMaxDoorHeight));
  return out;
}

/// Median depth of the windows' pixels behind the wall; 0 without depth.
double reveal_of(const FacadePicture& picture, const fit::FitResult& reading) {
  if (!picture.depth) return 0;
  std::vector<float> depths;
  for (const fit::DetectedElement& seen : reading.elements) {
    if (seen.type != fit::RegionType::window) continue;
    for (int y = seen.rect.y0; y < seen.rect.y1; ++y)
      for (int x = seen.rect.x0; x < seen.rect.x1; ++x) {
        const float depth = picture.depth->at(x, y);
        if (std::isfinite(depth)) depths.push_back(depth);
      }
  }
  if (depths.empty()) return 0;
  return std::max(0.0, static_cast<double>(median(std::move(depths))));
}

/// The reveal of carved windows in whole centimetres; nothing if the observed depth is within its
/// error.
std::optional<double> window_reveal(const FacadeFit& fit) {
  constexpr double kMin = 0.02, kMax = 0.4;  // metres
  if (!(fit.reveal > kMin)) return std::nullopt;
  return std::round(100 * std::min(fit.reveal, kMax)) / 100;
}

void set_reveal(FacadeFit& fit) {
  const std::optional<double> reveal = window_reveal(fit);
  if (!reveal) return;
  const facade::ElementPtr window =
      make_product(facade::elements(), "window", {{"reveal", Number{*reveal, Dimension::length}}});
  for (facade::Node& node : fit.tree.nodes)
    if (node.element && node.element->kind() == "window") node.element = window;
}

}  // namespace

std::filesystem::path default_looks() {
  std::error_code ignored;
  for (const std::filesystem::path& folder : loading::data_folders())
    if (const auto file = folder / "facades/looks.json";
        std::filesystem::is_regular_file(file, ignored))
      return file;
  return {};
}

Vec2d facade_size(const FacadePicture& picture, const FacadeFitOptions& options) {
  if (options.width > 0 && options.height > 0) return {options.width, options.height};
  if (options.width > 0) return {options.width, options.width / picture.shape};
  if (options.height > 0) return {options.height * picture.shape, options.height};
  if (picture.metres_wide > 0) return {picture.metres_wide, picture.metres_wide / picture.shape};
  constexpr double kLowest = 1, kHighest = 100;  // metres
  const Vec2d usual(kDefaultWidth, kDefaultWidth / picture.shape);
  if (usual.y < kLowest || usual.y > kHighest)
    throw Error(
        ErrorCode::bad_input,
        fmt::format("a facade of this shape that is {} m wide is {:.3g} m high", usual.x, usual.y),
        {}, "give its width or its height, or crop the picture to the facade");
  return usual;
}

FacadeFit fit_facade(const FacadePicture& picture, const FacadeFitOptions& options,
                     Progress& progress) {
  const Vec2d size = facade_size(picture, options);
  const facade::Rules text = facade::load_rules(options.grammar);
  const fit::Rules rules = fit::compile(text);
  const RandomKey key = RandomKey(options.seed).at("facade fit");
  const fit::Planes maps = maps_of(picture, options);
  const fit::Evidence evidence = evidence_of(picture, maps, options, key.at("clusters"));
  FacadeFit out;
  fit::FitOptions how;
  how.likelihood = options.classifier ? "supervised" : options.likelihood;
  // Errors of depth along edges are correlated.
  if (picture.depth && !options.classifier) how.pixel_weight = 0.03;
  if (options.trust > 0) how.pixel_weight = options.trust;
  how.sampler = options.sampler;
  if (options.doors_at_ground) how.limits = limits_of(picture, size.y);
  const fit::Model model(rules, how.limits, picture.width, picture.height);
  const auto in_metres = [&](const fit::Tree& tree) {
    fit::TreeState state = model.make_state(tree);
    model.compute_areas(state);
    return fit::to_facade_tree(text, model, state,
                               {size.x / picture.width, size.y / picture.height});
  };
  double least = std::numeric_limits<double>::infinity();
  if (options.improved)
    how.sampler.improved = [&](const fit::TreeState& best, double bits) {
      if (!(bits < least)) return;  // A later run begins again.
      least = bits;
      options.improved(in_metres(best.tree), bits);
    };
  out.reading = fit::fit_facade(evidence, rules, how, key.at("chains"), progress);
  out.tree = in_metres(out.reading.tree);
  out.reveal = reveal_of(picture, out.reading);
  set_reveal(out);
  if (options.classifier)
    out.labels = fit::label_pixels(maps, options.classifier->classes(), out.reading.elements);
  return out;
}

double facade_voxel(const FacadeFit& fit) { return fit.tree.height > 8 ? 0.04 : 0.02; }

std::string facade_grammar(const FacadeFit& fit, const std::string& name) {
  return facade::grammar_text(fit.tree, {.name = name});
}

std::string facade_scene(const FacadeFit& fit, const std::string& name, const std::string& file) {
  const double longer = std::max(fit.tree.width, fit.tree.height);
  const double half = fit.tree.height / 2, far = 2 * longer;
  const auto pixels = [&](double metres) {
    return std::max(1L, std::lround(800 * metres / longer));
  };
  return fmt::format(
      "{grammar}\n"
      "param voxel = {voxel}cm  in 5mm..50cm  \"edge of a voxel\"\n\n"
      "volume {name}_stone = level_set({name}, voxel: voxel)\n"
      "volume {name}_panes = level_set(infill({name}), voxel: {panes})\n"
      "mesh {name}_wall on {name}_stone {{}}\nmesh {name}_fill on {name}_panes {{}}\n"
      "object {name}_shown on {name}_wall {{ material lambert(albedo: (0.6, 0.54, 0.44)) }}\n"
      "object {name}_glass on {name}_fill {{ material lambert(albedo: (0.08, 0.09, 0.11)) }}\n\n"
      "camera main {{ kind orthographic  eye (0, {half:.3f}, {far:.3f})  target (0, {half:.3f}, 0)"
      "  width {width:.3f}m }}\n"
      "light even = sky(radiance: (1, 1, 1))\n"
      "render main {{ size {across}x{down}  spp 32  layers [\"beauty\", \"Z\"] }}\n",
      fmt::arg("grammar",
               file.empty() ? facade_grammar(fit, name) : fmt::format("include \"{}\"\n", file)),
      fmt::arg("voxel", 100 * facade_voxel(fit)), fmt::arg("panes", pane_voxel("voxel")),
      fmt::arg("name", name), fmt::arg("half", half), fmt::arg("far", far),
      fmt::arg("width", fit.tree.width), fmt::arg("across", pixels(fit.tree.width)),
      fmt::arg("down", pixels(fit.tree.height)));
}

}  // namespace vug::session
