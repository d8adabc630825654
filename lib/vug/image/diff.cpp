// SPDX-License-Identifier: Apache-2.0
#include <vug/base/diagnostics.h>
#include <vug/base/error.h>
#include <vug/image/brightness.h>
#include <vug/image/description.h>
#include <vug/image/diff_view.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace vug::image {
namespace {

constexpr const char* kSamples = "samples";

bool is_bookkeeping(const std::string& layer) { return layer == kVariance || layer == kSamples; }

const Layer* find_layer(const std::vector<Layer>& layers, const std::string& name) {
  for (const Layer& layer : layers)
    if (layer.name == name) return &layer;
  return nullptr;
}

std::vector<std::string> names_of(const std::vector<Layer>& layers) {
  std::vector<std::string> out;
  for (const Layer& layer : layers) out.push_back(layer.name);
  return out;
}

std::vector<Layer> without_bookkeeping(std::vector<Layer> layers) {
  layers.erase(std::remove_if(layers.begin(), layers.end(),
                              [](const Layer& layer) { return is_bookkeeping(layer.name); }),
               layers.end());
  return layers;
}

/// A layer, and whether all measures and the unnamed limits apply to it.
struct SelectedLayer {
  Layer layer;
  bool main = false;
};

void require_channels(const Layer& layer, const ImageUnderTest& has, const ImageUnderTest& lacks) {
  std::vector<std::string> missing;
  for (const std::string& channel : layer.channels)
    if (lacks.image.find_channel(channel) < 0) missing.push_back(channel);
  if (missing.empty()) return;
  throw Error(ErrorCode::bad_input,
              fmt::format("'{}' has no channel {}, which '{}' has", lacks.name,
                          fmt::join(missing, ", "), has.name),
              {}, "choose the layers to compare, for instance --layer beauty");
}

std::vector<SelectedLayer> choose_layers(const ImageUnderTest& a, const ImageUnderTest& b,
                                         const DiffOptions& options) {
  const std::vector<Layer> of_a = layers_of(a.image.channels), of_b = layers_of(b.image.channels);
  std::vector<SelectedLayer> out;
  if (!options.layers.empty()) {
    for (const std::string& name : options.layers) {
      const Layer *in_a = find_layer(of_a, name), *in_b = find_layer(of_b, name);
      if (!in_a || !in_b)
        throw Error(ErrorCode::bad_input,
                    fmt::format("'{}' has no layer '{}'", in_a ? b.name : a.name, name), {},
                    suggestion(name, names_of(in_a ? of_b : of_a)));
      require_channels(*in_a, a, b);
      require_channels(*in_b, b, a);
      out.push_back({*in_a, true});
    }
    return out;
  }
  for (const Layer& layer : without_bookkeeping(of_b)) require_channels(layer, b, a);
  const std::vector<Layer> layers = without_bookkeeping(of_a);
  const bool beauty = find_layer(layers, kBeauty) != nullptr;
  for (const Layer& layer : layers) {
    require_channels(layer, a, b);
    out.push_back({layer, !beauty || layer.name == kBeauty});
  }
  if (out.empty())
    throw Error(ErrorCode::bad_input, fmt::format("'{}' has nothing to compare", a.name));
  return out;
}

std::vector<const Measure*> measures_for(const SelectedLayer& chosen, const DiffOptions& options,
                                         const std::vector<Limit>& limits) {
  std::vector<const Measure*> out;
  for (const Measure* each : measures()) {
    const std::string& name = each->info.name;
    const bool limited = std::any_of(limits.begin(), limits.end(), [&](const Limit& limit) {
      return limit.measure == name &&
             (limit.layer.empty() ? chosen.main : limit.layer == chosen.layer.name);
    });
    const bool requested =
        std::find(options.measures.begin(), options.measures.end(), name) != options.measures.end();
    const bool usual =
        options.measures.empty() ? chosen.main || !each->needs_colour : requested && chosen.main;
    if (each->needs_colour && !chosen.layer.colour()) {
      if (limited && chosen.layer.name == kBeauty)
        throw Error(
            ErrorCode::bad_input,
            fmt::format("the layer '{}' has no colour, which {} needs", chosen.layer.name, name));
      continue;
    }
    if (limited || usual) out.push_back(each);
  }
  return out;
}

const Limit* limit_for(const SelectedLayer& chosen, const std::string& measure,
                       const std::vector<Limit>& limits) {
  const Limit* general = nullptr;
  for (const Limit& limit : limits) {
    if (limit.measure != measure) continue;
    if (limit.layer == chosen.layer.name) return &limit;
    if (limit.layer.empty() && chosen.main) general = &limit;
  }
  return general;
}

void require_known(const std::vector<SelectedLayer>& chosen, const DiffOptions& options) {
  std::vector<std::string> names;
  for (const SelectedLayer& each : chosen) names.push_back(each.layer.name);
  for (const std::string& name : options.measures) measure_of(name);
  for (const Limit& limit : options.limits) {
    measure_of(limit.measure);
    if (!limit.layer.empty() && std::find(names.begin(), names.end(), limit.layer) == names.end())
      throw Error(ErrorCode::bad_input,
                  fmt::format("a limit names the layer '{}', which is not compared", limit.layer),
                  {}, suggestion(limit.layer, names));
  }
}

bool passes(const Measure& measure, double value, double limit) {
  return measure.better == Measure::Better::low ? value <= limit : value >= limit;
}

/// The exposure at which both images together have a middle grey mean.
double exposure_of(const Comparison& pair) {
  const auto a = grey_exposure(pair.reference, pair.view.space),
             b = grey_exposure(pair.test, pair.view.space);
  if (a && b) return 0.5 * (*a + *b);
  return a ? *a : b.value_or(0);
}

Comparison comparison_of(const Layer& layer, const ImageUnderTest& a, const ImageUnderTest& b,
                         const DiffOptions& options, double exposure) {
  Comparison pair;
  pair.reference = extract(a.image, layer);
  pair.test = b.image.select(layer.channels);  // In the order of the reference.
  pair.test.channels = pair.reference.channels;
  pair.mask = options.mask;
  pair.reference_exposures = options.reference_exposures;
  pair.view.dither = false;
  pair.view.exposure = exposure;
  pair.view.space = a.space;
  if (a.screen && b.screen) pair.view.transform = ViewTransform::srgb;
  return pair;
}

double samples_of(const Metadata& metadata) {
  for (const auto& [name, text] : metadata)
    if (name == "vug:spp") return std::strtod(text.c_str(), nullptr);
  return 0;
}

NoisyPicture noisy(const ImageUnderTest& subject) {
  NoisyPicture out;
  out.mean = subject.image.select({"R", "G", "B"});
  const std::vector<Layer> layers = layers_of(subject.image.channels);
  const Layer* variance = find_layer(layers, kVariance);
  if (variance && variance->colour())
    out.variance = extract(subject.image, *variance).select({"R", "G", "B"});
  if (const int channel = subject.image.find_channel(kSamples); channel >= 0) {
    const size_t stride = subject.image.channels.size();
    for (size_t p = 0; p < subject.image.pixel_count(); ++p)
      out.samples.push_back(subject.image.pixels[p * stride + static_cast<size_t>(channel)]);
  } else if (const double spp = samples_of(subject.metadata); spp > 0) {
    out.samples.assign(subject.image.pixel_count(), static_cast<float>(spp));
  }
  return out;
}

std::optional<Significance> significance_of(const std::vector<SelectedLayer>& chosen,
                                            const ImageUnderTest& a, const ImageUnderTest& b,
                                            const DiffOptions& options, double alarm) {
  const bool beauty = std::any_of(chosen.begin(), chosen.end(), [](const SelectedLayer& each) {
    return each.layer.name == kBeauty && each.layer.colour();
  });
  std::string why = beauty ? "" : "only the beauty (R, G, B) can be tested for significance";
  if (beauty) {
    const NoisyPicture noisy_a = noisy(a), noisy_b = noisy(b);
    if (noisy_a.variance || noisy_b.variance)
      return test_significance(noisy_a, noisy_b, options.mask, {.false_alarm_rate = alarm});
    why = fmt::format("neither '{}' nor '{}' contains the variance of its pixels", a.name, b.name);
  }
  if (options.false_alarm_rate)
    throw Error(ErrorCode::bad_input, why, {},
                "the significance test reads variance.R, variance.G and variance.B; without them "
                "set a limit, for instance --max relative_rmse=0.01");
  return {};
}

/// The given limits or, without any basis for a verdict, the rounding limit for every layer.
std::vector<Limit> limits_for(const std::vector<SelectedLayer>& chosen, const DiffOptions& options,
                              bool tested) {
  std::vector<Limit> out = options.limits;
  if (out.empty() && !tested)
    for (const SelectedLayer& each : chosen)
      out.push_back({each.layer.name, "relative_max", kRounding});
  return out;
}

std::string unlikely(const Finding& finding) {
  if (finding.name == "pixels")
    return fmt::format("{:.2f} % of the pixels differ by more than their noise allows",
                       100 * finding.value);
  const char* what = finding.name == "bias"     ? "blocks are biased to one side"
                     : finding.name == "spread" ? "blocks differ by more than their noise allows"
                                                : "one block deviates";
  return fmt::format("{} (z = {:.1f} in {}, chance {:.2g})", what, finding.value, finding.channel,
                     finding.p_value);
}

void judge(Diff& out, const DiffOptions& options) {
  out.basis = !options.limits.empty() ? Basis::limits
              : out.tested            ? Basis::significance
                                      : Basis::rounding;
  for (const LayerResult& row : out.rows)
    if (!row.passed)
      out.reasons.push_back(fmt::format(
          "{} of {} is {:.4g}, {} {:.4g} is allowed", row.measure, row.layer, row.value,
          measure_of(row.measure).better == Measure::Better::low ? "at most" : "at least",
          *row.limit));
  if (out.tested)
    for (const Finding& finding : out.significance->findings)
      if (finding.different) out.reasons.push_back(unlikely(finding));
  out.same = out.reasons.empty();
}

/// True if the layer is a reason for the verdict "different".
bool fails(const Diff& diff, const std::string& layer) {
  if (layer == kBeauty && diff.tested && !diff.same)
    if (diff.significance->different || diff.not_finite > 0) return true;
  return std::any_of(diff.rows.begin(), diff.rows.end(),
                     [&](const LayerResult& row) { return row.layer == layer && !row.passed; });
}

/// Collects layers that differ but are not judged.
void find_unjudged(Diff& out, const std::vector<SelectedLayer>& chosen,
                   const std::vector<double>& largest) {
  for (size_t i = 0; i < chosen.size(); ++i) {
    const std::string& name = chosen[i].layer.name;
    const bool limited = std::any_of(out.rows.begin(), out.rows.end(), [&](const LayerResult& row) {
      return row.layer == name && row.limit;
    });
    const bool tested = name == kBeauty && out.tested;
    if (largest[i] != 0 && !limited && !tested) out.unjudged.push_back(name);
  }
}

void fill_heat(Diff& out, const Comparison& pair, bool colour) {
  out.heat_measure = colour ? "flip" : "max";
  out.heat = measure_of(out.heat_measure).measure(pair).map;
  if (colour) return;
  float most = 0;
  for (const float v : out.heat)
    if (std::isfinite(v)) most = std::max(most, v);
  for (float& v : out.heat) v = std::isfinite(v) ? (most > 0 ? v / most : 0) : 1;
}

}  // namespace

Limit limit_of(const std::string& name, double value) {
  const size_t dot = name.rfind('.');
  Limit out;
  if (dot != std::string::npos) out.layer = name.substr(0, dot);
  out.measure = dot == std::string::npos ? name : name.substr(dot + 1);
  out.value = value;
  const Measure& measure = measure_of(out.measure);
  if (!passes(measure, measure.equal, value))
    throw Error(ErrorCode::bad_input,
                fmt::format("no image can meet the limit {} of {}: equal images have {}", value,
                            name, measure.equal));
  return out;
}

Diff diff_view(const ImageUnderTest& reference, const ImageUnderTest& test,
               const DiffOptions& options, double alarm) {
  if (reference.image.width != test.image.width || reference.image.height != test.image.height)
    throw Error(ErrorCode::bad_input,
                fmt::format("'{}' has {} x {} pixels and '{}' {} x {}", reference.name,
                            reference.image.width, reference.image.height, test.name,
                            test.image.width, test.image.height),
                {}, "compare pictures of one size");
  if (reference.left != test.left || reference.top != test.top)
    throw Error(
        ErrorCode::bad_input,
        fmt::format("'{}' shows a crop from {}, {} and '{}' a crop from {}, {}", reference.name,
                    reference.left, reference.top, test.name, test.left, test.top),
        {}, "compare crops of the same region");
  if (reference.space != test.space)
    throw Error(ErrorCode::bad_input,
                fmt::format("'{}' is in the colour space {} and '{}' in {}", reference.name,
                            info(reference.space).name, test.name, info(test.space).name),
                {}, "render both in one working_space");
  const std::vector<SelectedLayer> chosen = choose_layers(reference, test, options);
  require_known(chosen, options);
  const auto main = std::find_if(chosen.begin(), chosen.end(),
                                 [](const SelectedLayer& each) { return each.main; });
  Diff out;
  out.shown_layer = main->layer.name;
  const bool screen = reference.screen && test.screen;
  if (!screen)
    out.exposure = options.exposure.value_or(
        exposure_of(comparison_of(main->layer, reference, test, options, 0)));
  out.significance = significance_of(chosen, reference, test, options, alarm);
  const std::vector<Limit> limits = limits_for(chosen, options, out.significance.has_value());
  const auto of_beauty = [&](const SelectedLayer& each) {
    return each.layer.name == kBeauty &&
           std::any_of(limits.begin(), limits.end(), [&](const Limit& limit) {
             return limit.layer == kBeauty || (limit.layer.empty() && each.main);
           });
  };
  out.tested = out.significance &&
               (options.false_alarm_rate || std::none_of(chosen.begin(), chosen.end(), of_beauty));
  std::vector<double> largest;     // Per layer, the largest difference.
  std::vector<std::string> words;  // Per layer, the difference in words.
  for (const SelectedLayer& each : chosen) {
    const Comparison pair = comparison_of(each.layer, reference, test, options, out.exposure);
    const Differences d = differences(pair);
    out.not_finite += d.not_finite;
    largest.push_back(d.largest);
    words.push_back(describe_difference(pair, each.layer.name));
    const bool brief = d.largest == 0 && !each.main;  // "identical" suffices.
    if (brief) out.identical.push_back(each.layer.name);
    if (each.layer.name == kBeauty && out.tested && std::isinf(d.largest))
      out.reasons.push_back("values of the beauty are not finite in one picture only");
    for (const Measure* measure : measures_for(each, options, limits)) {
      LayerResult row{each.layer.name, measure->info.name, measure->equal, {}, true};
      if (d.largest > 0) row.value = measure->measure(pair).value;
      if (const Limit* limit = limit_for(each, row.measure, limits)) row.limit = limit->value;
      if (row.limit) row.passed = passes(*measure, row.value, *row.limit);
      if (!brief || row.limit) out.rows.push_back(row);
    }
    if (&each == &*main) {
      out.shown = pair;
      fill_heat(out, pair, each.layer.colour());
    }
  }
  judge(out, options);
  for (size_t i = 0; i < chosen.size(); ++i)
    if (fails(out, chosen[i].layer.name) && !words[i].empty()) out.words.push_back(words[i]);
  if (out.same && *std::max_element(largest.begin(), largest.end()) == 0)
    out.basis = Basis::identical;
  find_unjudged(out, chosen, largest);
  return out;
}

}  // namespace vug::image
