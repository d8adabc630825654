// SPDX-License-Identifier: Apache-2.0
// Comparison of stereo images: each view is compared by itself, and both have to be the same.
#include <vug/base/error.h>
#include <vug/image/diff_view.h>
#include <vug/image/views.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace vug::image {
namespace {

ImageUnderTest in_view(const ImageUnderTest& subject, const View& view) {
  return {subject.name,     extract(subject.image, view),
          subject.metadata, subject.left,
          subject.top,      subject.space,
          subject.screen};
}

/// The options for one view; none if they request layers of the other view only.
std::optional<DiffOptions> in_view(const DiffOptions& options, const View& view) {
  DiffOptions out = options;
  out.layers.clear(), out.limits.clear();
  for (const std::string& layer : options.layers)
    if (auto own = layer_in(view, layer)) out.layers.push_back(std::move(*own));
  if (out.layers.empty() && !options.layers.empty()) return {};
  for (const Limit& limit : options.limits)
    if (auto own = layer_in(view, limit.layer))
      out.limits.push_back({std::move(*own), limit.measure, limit.value});
  return out;
}

std::string name_of(const View& view, const std::string& layer) {
  return layer == kBeauty && !view.name.empty() ? view.name : view.full(layer);
}

/// Renames layers as in the whole image.
Diff named(Diff diff, const View& view) {
  if (view.name.empty()) return diff;
  for (LayerResult& row : diff.rows) row.layer = name_of(view, row.layer);
  for (auto* names : {&diff.identical, &diff.unjudged})
    for (std::string& layer : *names) layer = name_of(view, layer);
  for (auto* sentences : {&diff.words, &diff.reasons})
    for (std::string& sentence : *sentences) sentence = fmt::format("{}: {}", view.name, sentence);
  diff.shown_layer = name_of(view, diff.shown_layer);
  return diff;
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

void add(Diff& all, const Diff& one, const View& view) {
  all.same = all.same && one.same;
  if (one.basis != Basis::identical)  // The most informative basis.
    all.basis = all.basis == Basis::identical ? one.basis : std::min(all.basis, one.basis);
  append(all.rows, one.rows);
  append(all.identical, one.identical);
  if (one.significance) all.other_views.emplace_back(view.name, *one.significance);
  all.tested = all.tested || one.tested;
  all.not_finite += one.not_finite;
  append(all.unjudged, one.unjudged);
  append(all.words, one.words);
  append(all.reasons, one.reasons);
}

void require_same_views(const ImageUnderTest& a, const ImageUnderTest& b) {
  const auto names = [](const ImageUnderTest& subject) {
    std::vector<std::string> out;
    for (const View& view : views_of(subject.image.channels)) out.push_back(view.name);
    return out;
  };
  const auto of_a = names(a), of_b = names(b);
  if (of_a == of_b) return;
  const bool more = of_a.size() > of_b.size();
  throw Error(ErrorCode::bad_input,
              fmt::format("'{}' is a stereo image, '{}' is not", more ? a.name : b.name,
                          more ? b.name : a.name),
              {}, "render one view by itself with --eye left");
}

}  // namespace

Diff diff(const ImageUnderTest& reference, const ImageUnderTest& test, const DiffOptions& options) {
  require_same_views(reference, test);
  const double alarm = options.false_alarm_rate.value_or(kFalseAlarmRate);
  const std::vector<View> all = views_of(reference.image.channels);
  if (all.size() == 1 && all[0].name.empty()) return diff_view(reference, test, options, alarm);
  std::vector<std::pair<View, DiffOptions>> views;
  for (const View& view : all)
    if (auto own = in_view(options, view)) views.emplace_back(view, std::move(*own));
  std::optional<Diff> out;
  for (auto& [view, own] : views) {
    // Sidak: all views together raise no more false alarms than one would.
    const double share = 1 - std::pow(1 - alarm, 1.0 / static_cast<double>(views.size()));
    if (out) own.exposure = out->exposure;
    const auto there = views_of(test.image.channels);
    const auto other =
        std::find_if(there.begin(), there.end(),
                     [&name = view.name](const View& each) { return each.name == name; });
    const Diff one =
        named(diff_view(in_view(reference, view), in_view(test, *other), own, share), view);
    if (out)
      add(*out, one, view);
    else
      out = one;
  }
  return *out;
}

}  // namespace vug::image
