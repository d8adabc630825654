// Facades out of pictures: a photograph, or what a scanner saw, becomes a tree, and a scene.
#pragma once

#include <vug/base/progress.h>
#include <vug/facade/tree.h>
#include <vug/fit/evidence/cluster_image.h>
#include <vug/fit/fit_facade.h>
#include <vug/fit/learning/pixel_classifier.h>
#include <vug/session/facade_picture.h>

#include <memory>

namespace vug::session {

/// Of a facade of which nothing tells it, metres.
constexpr double kDefaultWidth = 12;

struct FacadeFitOptions {
  std::filesystem::path grammar;  ///< Rules with free sizes.
  std::string likelihood = "kt";  ///< Of fit::likelihood_kinds.
  fit::ClusterImageOptions clusters = {.depth_clusters = 5};
  /// Trained looks: pictures of their limits are read by them, with the likelihood `supervised`.
  std::shared_ptr<const fit::PixelClassifier> looks;
  double trust = 0;  ///< See fit::ReadOptions; 0: 0.03 with depth, else its own.
  /// Of the facade, metres. Of one that is 0 the picture's shape tells; of both the picture, else
  /// kDefaultWidth.
  double width = 0, height = 0;
  fit::SamplerOptions sampler;
  uint64_t seed = 0;
};

struct FacadeFit {
  facade::Tree tree;       ///< Metres. Windows are as deep as they were seen.
  fit::FitResult reading;  ///< Pixels, and what the chains tell.
  double reveal = 0;       ///< How deep windows lie behind the wall, metres; 0: no depth tells.
  /// The class of each of the picture's pixels by looks and tree; none without looks.
  std::vector<uint8_t> labels;
};

/// Width and height of the facade that the picture shows, metres. Error(bad_input) where nothing
/// tells them and the shape of the picture is none that facades have.
Vec2d facade_size(const FacadePicture& picture, const FacadeFitOptions& options);

/// The tree that costs least of those that chains have seen. When the progress is cancelled it is
/// the best so far. Error(bad_input) for grammars that cannot be fitted.
FacadeFit fit_facade(const FacadePicture& picture, const FacadeFitOptions& options,
                     Progress& progress = Progress::none());

/// How finely it is carved, metres.
double facade_voxel(const FacadeFit& fit);

/// The text of a grammar of that name that derives to the facade.
std::string facade_grammar(const FacadeFit& fit, const std::string& name);

/// A scene that includes the file of that grammar, or has its text where `file` is empty, carves it
/// out of a wall and looks at it. Its own names but `main`, `even` and `voxel` begin with the
/// grammar's.
std::string facade_scene(const FacadeFit& fit, const std::string& name, const std::string& file);

}  // namespace vug::session
