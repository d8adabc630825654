// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/json_file.h>
#include <vug/fit/json_integer.h>
#include <vug/fit/learning/pixel_classifier.h>
#include <vug/fit/likelihood.h>
#include <vug/inference/bits.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace vug::fit {
namespace {

constexpr int kVersion = 1;
/// Upper limits of the working size, since each pixel has more than a hundred features.
constexpr int kMaxRows = 4096, kMaxPixels = 4'000'000;

Planes concatenated(Planes a, const Planes& b) {
  a.planes.insert(a.planes.end(), b.planes.begin(), b.planes.end());
  return a;
}

}  // namespace

Planes PixelClassifier::classify(const image::Image& linear) const {
  const Planes seen =
      features(downsampled(linear, working_size(linear.width, linear.height, limits_)));
  return second_.classify(concatenated(seen, context_features(first_.classify(seen))));
}

nlohmann::json PixelClassifier::to_json() const {
  return {{"format", "vug looks"},
          {"version", kVersion},
          {"classes", fit::to_json(classes_)},
          {"working", {{"height", limits_.height}, {"pixels", limits_.pixels}}},
          {"first", first_.to_json()},
          {"second", second_.to_json()}};
}

PixelClassifier PixelClassifier::from_json(const nlohmann::json& text) {
  const auto refused = [](const char* reason) {
    return Error(ErrorCode::bad_input, reason, {}, "train a classifier with `vug facade train`");
  };
  PixelClassifier out;
  try {
    if (!text.is_object() || text.value("format", "") != "vug looks")
      throw refused("this is not a trained pixel classifier");
    if (json_integer(text.at("version")) != kVersion)
      throw refused("the pixel classifier has an unsupported version");
    out.classes_ = classes_from_json(text.at("classes"));
    out.limits_.height = json_integer(text.at("working").at("height")).value_or(0);
    out.limits_.pixels = json_integer(text.at("working").at("pixels")).value_or(0);
    out.first_ = Forest::from_json(text.at("first"));
    out.second_ = Forest::from_json(text.at("second"));
  } catch (const nlohmann::json::exception&) {
    throw refused("the pixel classifier is damaged");
  }
  const int classes = out.classes_.count();
  if (out.limits_.height < 1 || out.limits_.height > kMaxRows || out.limits_.pixels < 1 ||
      out.limits_.pixels > kMaxPixels || out.first_.classes() != classes ||
      out.second_.classes() != classes)
    throw refused("the pixel classifier is damaged");
  if (out.first_.features() != feature_count() ||
      out.second_.features() != feature_count() + context_count() * static_cast<size_t>(classes))
    throw refused("the pixel classifier has an unsupported version");
  return out;
}

PixelClassifier PixelClassifier::read(const std::filesystem::path& file) {
  try {
    return from_json(read_json<nlohmann::json>(file));
  } catch (Error& error) {
    throw error.within(fmt::format("reading '{}'", file.string()));
  }
}

Planes enlarged(const Planes& maps, int width, int height) {
  Planes out{width, height, std::vector<Plane>(maps.count())};
  const auto share = [](int i, int to, int from) {
    return std::clamp((i + 0.5) * from / to - 0.5, 0.0, from - 1.0);
  };
  for (size_t c = 0; c < maps.count(); ++c) {
    out.planes[c].reserve(out.pixels());
    const auto at = [&](int x, int y) {
      return maps.planes[c][static_cast<size_t>(y) * static_cast<size_t>(maps.width) +
                            static_cast<size_t>(x)];
    };
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const double u = share(x, width, maps.width), v = share(y, height, maps.height);
        const int x0 = static_cast<int>(u), y0 = static_cast<int>(v);
        const int x1 = std::min(x0 + 1, maps.width - 1), y1 = std::min(y0 + 1, maps.height - 1);
        const double a = u - x0, b = v - y0;
        out.planes[c].push_back(
            static_cast<float>((1 - b) * ((1 - a) * at(x0, y0) + a * at(x1, y0)) +
                               b * ((1 - a) * at(x0, y1) + a * at(x1, y1))));
      }
  }
  return out;
}

Evidence classifier_evidence(const Planes& maps, const Classes& classes,
                             const ClassifierEvidenceOptions& options) {
  if (maps.count() != classes.names.size())
    throw Error(ErrorCode::bad_input, "the number of maps must match the number of classes");
  std::vector<uint32_t> bits;
  bits.reserve(maps.pixels() * kRegionTypes);
  for (size_t i = 0; i < maps.pixels(); ++i) {
    std::array<double, kRegionTypes> likely{};
    for (int c = 0; c < classes.count(); ++c)
      likely[static_cast<size_t>(classes.region_type(c))] += maps.planes[static_cast<size_t>(c)][i];
    auto& [wall, window, door, shop] = likely;
    window *= options.windows;
    wall += options.unnamed * (door + shop);
    const double sum = wall + window + door + shop;
    for (const double p : likely)
      bits.push_back(static_cast<uint32_t>(
          std::lround(-inference::log2(std::max(p / sum, options.min_probability)) / kBitStep)));
  }
  return Evidence(maps.width, maps.height, kRegionTypes, bits);
}

}  // namespace vug::fit
