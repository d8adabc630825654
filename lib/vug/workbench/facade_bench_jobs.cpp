// SPDX-License-Identifier: Apache-2.0
// The threads of the facade bench: analysis of the photo for the score, and the fit.
#include <vug/modeller/tree_to_edits.h>
#include <vug/session/facade_model.h>
#include <vug/workbench/command.h>
#include <vug/workbench/facade_bench.h>

namespace vug::workbench {

namespace fs = std::filesystem;

void FacadeBench::start_scoring() {
  scoring_.stop();
  score_reason_ = "the session has no photo";
  const fs::path file = photo();
  if (file.empty()) return;
  score_reason_ = "the photo is being analysed";
  scoring_.start([file, rules = document().state().style().rules()](Progress&, const auto&) {
    const session::FacadePicture picture = session::read_facade_picture(file);
    fit::ClusterImage clusters = fit::cluster_image(picture.colours ? &*picture.colours : nullptr,
                                                    picture.depth ? &*picture.depth : nullptr, {},
                                                    RandomKey(0).at("facade fit").at("clusters"));
    return std::make_shared<const fit::FacadeScorer>(rules, std::move(clusters));
  });
}

const std::optional<fit::FacadeScore>& FacadeBench::score() const {
  if (!scorer_ || (score_ && scored_revision_ == revision_)) return score_;
  score_.reset();
  try {
    score_ = scorer_->score(state().tree());
    score_reason_.clear();
  } catch (const Error& error) {
    score_reason_ = error.what();
  }
  scored_revision_ = revision_;
  return score_;
}

void FacadeBench::start_fit(int64_t steps) {
  const fs::path file = photo();
  if (file.empty())
    throw Error(ErrorCode::bad_input, "the session has no photo to fit", {}, "open a photo");
  session::FacadeFitOptions options;
  options.grammar = session::find_grammar_file(folder_, document().header().grammar);
  options.width = document().state().canvas().width;
  options.height = document().state().canvas().height;
  if (steps > 0) options.sampler.steps = steps;
  best_tree_.reset(), fit_note_.clear();
  fit_.start([file, options](Progress& progress, const Job<facade::Tree>::Publish& publish) {
    session::FacadeFitOptions how = options;
    session::FacadePictureOptions reading;
    if (const fs::path looks = session::default_looks(); !looks.empty()) {
      how.classifier =
          std::make_shared<const fit::PixelClassifier>(fit::PixelClassifier::read(looks));
      reading.limits = how.classifier->limits();
    }
    how.improved = [&](const facade::Tree& best, double) { publish(best); };
    const session::FacadePicture picture = session::read_facade_picture(file, reading);
    return session::fit_facade(picture, how, progress).tree;
  });
}

void FacadeBench::finish_fit(const facade::Tree& tree) {
  const FacadeDocument start = document().with_edits({});
  const modeller::TreeEdits found = modeller::tree_to_edits(start.state(), tree);
  best_tree_.reset();
  run_command(*this, replace_line("Fit", found.edits));
  fit_note_ = modeller::deviation_text(found);
}

bool FacadeBench::poll() {
  bool news = false;
  if (auto update = scoring_.poll(); update.ended && (update.result || update.error)) {
    scorer_ = update.result ? *update.result : nullptr;
    if (update.error) score_reason_ = *update.error;
    scoring_.stop();
    score_.reset();
    news = true;
  }
  if (auto update = fit_.poll(); update.generation > 0) {
    news = true;
    if (update.result) best_tree_ = std::move(*update.result);
    update.result.reset();
    fit_update_ = update;
    if (update.ended) {
      fit_.stop();
      if (best_tree_ && !update.error) finish_fit(*best_tree_);
      best_tree_.reset();
    }
  }
  return news;
}

}  // namespace vug::workbench
