// SPDX-License-Identifier: Apache-2.0
// Training of pixel classifiers from labelled pictures.
#include <vug/base/error.h>
#include <vug/base/memory.h>
#include <vug/base/parallel.h>
#include <vug/fit/learning/pixel_classifier.h>

#include <algorithm>
#include <functional>

namespace vug::fit {
namespace {

using Pictures = std::vector<const LabelledImage*>;

/// Random labelled pixels of each picture.
class PixelSample {
 public:
  PixelSample(const Pictures& pictures, const PixelClassifierOptions& options, RandomKey key)
      : places_(pictures.size()) {
    const size_t each = of_each(pictures.size(), options);
    parallel_for(pictures.size(), [&](size_t k) {
      const std::vector<uint8_t>& labels = pictures[k]->labels;
      std::vector<uint32_t> known;
      for (size_t i = 0; i < labels.size(); ++i)
        if (labels[i] != kUnlabelled) known.push_back(static_cast<uint32_t>(i));
      RandomStream stream(key.at(k));
      for (size_t i = 0; i < each && !known.empty(); ++i)
        places_[k].push_back(known[stream.below(static_cast<uint32_t>(known.size()))]);
    });
  }
  static size_t of_each(size_t pictures, const PixelClassifierOptions& options) {
    const auto most = static_cast<size_t>(std::max(1, options.max_examples));
    return std::min(static_cast<size_t>(std::max(1, options.examples)),
                    most / std::max<size_t>(1, pictures) + 1);
  }
  const std::vector<uint32_t>& of(size_t picture) const { return places_[picture]; }

 private:
  std::vector<std::vector<uint32_t>> places_;
};

/// Collects the examples of those pictures. Each thread computes the planes of one picture at a
/// time, so that they are never all in memory.
Examples gather(const Pictures& pictures, const PixelSample& sample,
                const std::vector<size_t>& which, const std::function<Planes(size_t)>& planes_of,
                Progress& progress) {
  std::vector<std::vector<float>> values(which.size());
  std::vector<size_t> counts(which.size(), 0);
  progress.begin("computing features", which.size());
  parallel_for(which.size(), [&](size_t n) {
    progress.check();
    const Planes planes = planes_of(which[n]);
    counts[n] = planes.count();
    for (const uint32_t at : sample.of(which[n]))
      for (const Plane& plane : planes.planes) values[n].push_back(plane[at]);
    progress.advance();
  });
  progress.end();
  Examples out;
  for (size_t n = 0; n < which.size(); ++n) {
    out.features = counts[n];
    out.values.insert(out.values.end(), values[n].begin(), values[n].end());
    values[n] = {};
    for (const uint32_t at : sample.of(which[n]))
      out.classes.push_back(pictures[which[n]]->labels[at]);
  }
  return out;
}

}  // namespace

PixelClassifier PixelClassifier::train(const Pictures& pictures, const Classes& classes,
                                       const WorkingLimits& limits,
                                       const PixelClassifierOptions& options, RandomKey key,
                                       Progress& progress) {
  const auto features_of_all =
      static_cast<double>(feature_count() + context_count() * static_cast<size_t>(classes.count()));
  // Once per picture and once concatenated.
  require_memory(
      2.0 * sizeof(float) * features_of_all *
          static_cast<double>(pictures.size() * PixelSample::of_each(pictures.size(), options)),
      options.max_memory ? options.max_memory : available_memory(), "training the pixel classifier",
      "use fewer examples");
  const PixelSample sample(pictures, options, key.at("pixels"));
  std::vector<size_t> all, odd, even;
  for (size_t k = 0; k < pictures.size(); ++k) {
    if (sample.of(k).empty()) continue;
    (all.size() % 2 ? odd : even).push_back(k);
    all.push_back(k);
  }
  if (all.empty()) throw Error(ErrorCode::bad_input, "no labelled pixels to train on");
  const auto see = [&](size_t k) { return features(pictures[k]->photo); };
  const auto forest = [&](const std::vector<size_t>& which, const ForestOptions& how,
                          std::string_view name, const std::function<Planes(size_t)>& planes) {
    return Forest::train(gather(pictures, sample, which, planes, progress), classes.count(), how,
                         key.at(name), progress);
  };
  PixelClassifier out;
  out.classes_ = classes;
  out.limits_ = limits;
  out.first_ = forest(all, options.first, "first", see);
  // With a single picture there is no other one to train on.
  const Forest of_odd = odd.empty() ? out.first_ : forest(odd, options.first, "odd", see);
  const Forest of_even = odd.empty() ? out.first_ : forest(even, options.first, "even", see);
  std::vector<const Forest*> stranger(pictures.size(), &of_odd);
  for (const size_t k : odd) stranger[k] = &of_even;
  out.second_ = forest(all, options.second, "second", [&](size_t k) {
    Planes seen = see(k);
    const Planes context = context_features(stranger[k]->classify(seen));
    seen.planes.insert(seen.planes.end(), context.planes.begin(), context.planes.end());
    return seen;
  });
  return out;
}

}  // namespace vug::fit
