// SPDX-License-Identifier: Apache-2.0
// vug facade train: learns the looks of walls, windows and doors from labelled photographs.
#include "arguments.h"
#include "progress_bar.h"
#include "scene_options.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/base/parallel.h>
#include <vug/fit/learning/confusion.h>
#include <vug/fit/learning/labelling.h>
#include <vug/fit/learning/pixel_classifier.h>
#include <nlohmann/json.hpp>

#include <cstdio>

namespace vug::cli {
namespace {

struct FacadeTrainOptions {
  std::string folder, classes, output;
  fit::WorkingLimits limits;
  fit::PixelClassifierOptions classifier;
  int folds = 0;
  uint64_t seed = 0;
  WorkOptions work;
};

void report(const fit::ConfusionMatrix& table, const fit::Classes& classes) {
  clear_progress_bar();
  fmt::print("pixel accuracy  {:.3f}\nclass average   {:.3f}\nwindow overlap  {:.3f}\n\n{}",
             table.accuracy(), table.class_average(),
             table.iou(classes.find(fit::RegionType::window)), table.table(classes));
}

int run_facade_train(FacadeTrainOptions options) {
  Progress& progress = terminal_progress(options.work.bar_mode());
  if (options.output.empty() && options.folds == 0)
    throw Error(ErrorCode::bad_input, "neither -o nor --folds given", {},
                "write the classifier with -o FILE.json, or evaluate it with --folds 5");
  if (!options.output.empty()) {
    require_extension(options.output, ".json", "the classifier is a .json");
    require_outputs({options.output}, {options.classes});
  }
  options.classifier.max_memory = options.work.memory_limit();
  const fit::Classes classes = fit::read_classes(options.classes);
  const std::vector<fit::LabelledImage> pictures = fit::read_labelled_folder(
      options.folder, classes, options.limits, options.classifier.max_memory, progress);
  const RandomKey key = RandomKey(options.seed).at("facade train");
  if (options.folds > 0) {
    fit::ConfusionMatrix table(classes.count());
    fit::cross_validate(
        pictures, classes,
        {.limits = options.limits, .classifier = options.classifier, .folds = options.folds},
        key.at("folds"),
        [&](size_t picture, const fit::Planes& maps) {
          table.add(pictures[picture].labels, fit::most_likely_classes(maps));
        },
        progress);
    report(table, classes);
  }
  if (options.output.empty()) return kDone;
  std::vector<const fit::LabelledImage*> all;
  for (const fit::LabelledImage& picture : pictures) all.push_back(&picture);
  const fit::PixelClassifier model = fit::PixelClassifier::train(
      all, classes, options.limits, options.classifier, key.at("all"), progress);
  write_text(options.output, model.to_json().dump() + "\n");
  return kDone;
}

}  // namespace

Verb facade_train_verb() {
  return {
      "train", "Trains a pixel classifier for walls, windows and doors from labelled pictures.",
      [](CLI::App& app) {
        auto options = std::make_shared<FacadeTrainOptions>();
        app.add_option("folder", options->folder,
                       "Folder with pictures in images/ and 8-bit grey pictures of the same names "
                       "in labels/: class numbers, 255 for pixels without a class")
            ->required();
        app.add_option(
               "--classes", options->classes,
               "JSON file with the names of classes: {\"0\": \"door\", \"1\": \"window\", ...}")
            ->required();
        app.add_option("-o,--output", options->output,
                       "Output .json for `vug facade fit --looks`; this or --folds is required");
        app.add_option("--folds", options->folds,
                       "Cross-validate with this number of folds and print the accuracy; this or "
                       "-o is required")
            ->transform(integer_in(2, 1000));
        app.add_option("--rows", options->limits.height,
                       "Number of pixel rows to which pictures are reduced; default 360")
            ->transform(integer_in(1, 4096));
        app.add_option("--trees", options->classifier.first.trees, "Number of trees per forest")
            ->transform(integer_in(1, 1000));
        app.add_option("--seed", options->seed, "Seed of the training")->transform(seed_number());
        options->work.add_to(app);
        return [options] {
          options->classifier.second.trees = options->classifier.first.trees;
          return with_threads(options->work.threads, [&] { return run_facade_train(*options); });
        };
      }};
}

}  // namespace vug::cli
