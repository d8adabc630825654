// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/fit/learning/confusion.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::fit {
namespace {

double ratio(int64_t part, int64_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

}  // namespace

ConfusionMatrix::ConfusionMatrix(int classes)
    : classes_(classes), counts_(static_cast<size_t>(classes * classes), 0) {}

void ConfusionMatrix::add(const std::vector<uint8_t>& truth, const std::vector<uint8_t>& found) {
  for (size_t i = 0; i < truth.size(); ++i)
    if (truth[i] != kUnlabelled) ++counts_[static_cast<size_t>(truth[i] * classes_ + found[i])];
}

ConfusionMatrix& ConfusionMatrix::operator+=(const ConfusionMatrix& other) {
  for (size_t i = 0; i < counts_.size(); ++i) counts_[i] += other.counts_[i];
  return *this;
}

int64_t ConfusionMatrix::class_count(int truth) const {
  int64_t sum = 0;
  for (int found = 0; found < classes_; ++found) sum += count(truth, found);
  return sum;
}

double ConfusionMatrix::accuracy() const {
  int64_t right = 0, all = 0;
  for (int c = 0; c < classes_; ++c) right += count(c, c), all += class_count(c);
  return ratio(right, all);
}

double ConfusionMatrix::class_average() const {
  double sum = 0;
  int present = 0;
  for (int c = 0; c < classes_; ++c) {
    if (class_count(c) == 0) continue;
    sum += ratio(count(c, c), class_count(c));
    ++present;
  }
  return present > 0 ? sum / present : 0;
}

double ConfusionMatrix::iou(int of) const {
  int64_t taken = 0;
  for (int truth = 0; truth < classes_; ++truth) taken += count(truth, of);
  return ratio(count(of, of), taken + class_count(of) - count(of, of));
}

std::string ConfusionMatrix::table(const Classes& classes) const {
  size_t wide = 7;
  for (const std::string& name : classes.names) wide = std::max(wide, name.size() + 1);
  std::string out = fmt::format("{:<{}}", "", wide);
  for (const std::string& name : classes.names) out += fmt::format("{:>{}}", name, wide);
  out += fmt::format("{:>{}}\n", "overlap", wide + 2);
  for (int truth = 0; truth < classes_; ++truth) {
    out += fmt::format("{:<{}}", classes.names[static_cast<size_t>(truth)], wide);
    for (int found = 0; found < classes_; ++found)
      out += fmt::format("{:>{}.1f}", 100 * ratio(count(truth, found), class_count(truth)), wide);
    out += fmt::format("{:>{}.3f}\n", iou(truth), wide + 2);
  }
  return out;
}

void cross_validate(const std::vector<LabelledImage>& pictures, const Classes& classes,
                    const CrossValidation& options, RandomKey key,
                    const std::function<void(size_t, const Planes&)>& visit, Progress& progress) {
  const int folds = options.folds;
  if (folds < 2 || pictures.size() < static_cast<size_t>(folds))
    throw Error(
        ErrorCode::bad_input,
        fmt::format("cannot cross-validate {} pictures with {} folds", pictures.size(), folds), {},
        "use at least two folds and one picture per fold");
  const auto parts = static_cast<size_t>(folds);
  for (size_t fold = 0; fold < parts; ++fold) {
    std::vector<const LabelledImage*> seen;
    for (size_t k = 0; k < pictures.size(); ++k)
      if (k % parts != fold) seen.push_back(&pictures[k]);
    const PixelClassifier model = PixelClassifier::train(
        seen, classes, options.limits, options.classifier, key.at(fold), progress);
    for (size_t k = fold; k < pictures.size(); k += parts) {
      progress.check();
      visit(k, model.classify(pictures[k].photo));
    }
  }
}

}  // namespace vug::fit
