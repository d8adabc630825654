// SPDX-License-Identifier: Apache-2.0
// Fits a facade grammar to a picture or a laser scan; the result is a tree, whose windows have the
// reveal that was measured in the depth, and a scene.
#pragma once

#include <vug/base/progress.h>
#include <vug/facade/tree.h>
#include <vug/fit/evidence/cluster_image.h>
#include <vug/fit/fit_facade.h>
#include <vug/fit/learning/pixel_classifier.h>
#include <vug/session/facade_picture.h>

#include <functional>
#include <memory>

namespace vug::session {

/// Width in metres of a facade of unknown size.
constexpr double kDefaultWidth = 12;

struct FacadeFitOptions {
  std::filesystem::path grammar;  ///< File of the rules, with free sizes.
  std::string likelihood = "kt";  ///< One of fit::likelihood_kinds.
  fit::ClusterImageOptions clusters = {.depth_clusters = 5};
  /// Trained pixel classifier; if set, its class maps are used with the likelihood `supervised`.
  std::shared_ptr<const fit::PixelClassifier> classifier;
  double trust = 0;  ///< See fit::ReadOptions; 0: 0.03 with depth, else its own.
  /// Size of the facade in metres. If one is 0, it follows from the aspect ratio of the picture; if
  /// both are 0, from the pixel size of the picture, else from kDefaultWidth.
  double width = 0, height = 0;
  /// Only accept doors and shops at the foot of the facade, and no door above 4.5 m.
  bool doors_at_ground = true;
  fit::SamplerOptions sampler;
  uint64_t seed = 0;
  /// Receives each tree that costs fewer bits than all trees before it, on the thread that fits.
  /// It must not throw.
  std::function<void(const facade::Tree& best, double bits)> improved = {};
};

/// The classifier for photos of streets that is distributed with the data, trained by
/// tools/dev/train_looks on painted facades; empty if the data is not installed.
std::filesystem::path default_looks();

struct FacadeFit {
  facade::Tree tree;       ///< In metres; windows have the observed reveal.
  fit::FitResult reading;  ///< In pixels, with the statistics of the chains.
  double reveal = 0;       ///< Depth of windows behind the wall in metres; 0: unknown.
  /// Class of each pixel from the classifier and the tree; empty without a classifier.
  std::vector<uint8_t> labels;
};

/// Width and height of the facade in the picture, in metres. Error(bad_input) if they are unknown
/// and the aspect ratio of the picture is implausible for a facade.
Vec2d facade_size(const FacadePicture& picture, const FacadeFitOptions& options);

/// The tree with the lowest cost among all states of the Markov chains, or the best so far if the
/// progress is cancelled. Error(bad_input) for grammars that cannot be fitted.
FacadeFit fit_facade(const FacadePicture& picture, const FacadeFitOptions& options,
                     Progress& progress = Progress::none());

/// Voxel size in metres for carving the facade.
double facade_voxel(const FacadeFit& fit);

/// The text of a grammar of that name that derives to the facade.
std::string facade_grammar(const FacadeFit& fit, const std::string& name);

/// A scene that includes the grammar's file, or contains its text if `file` is empty, carves the
/// facade into a wall and renders it. All its names except `main`, `even` and `voxel` begin with
/// the grammar's name.
std::string facade_scene(const FacadeFit& fit, const std::string& name, const std::string& file);

}  // namespace vug::session
