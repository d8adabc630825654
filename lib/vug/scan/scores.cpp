// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/scan/scores.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace vug::scan {
namespace {

double area(const Box& box) { return box.isEmpty() ? 0 : box.size().x * box.size().y; }

Box common(const Box& a, const Box& b) {
  return {{std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y)},
          {std::min(a.max.x, b.max.x), std::min(a.max.y, b.max.y)}};
}

/// IoU of each true object (row) with each detection (column).
using Table = std::vector<std::vector<double>>;

Scores matched(const Table& table, size_t found, double min_iou) {
  Scores out;
  out.found = found;
  out.truth.resize(table.size());
  std::vector<std::tuple<double, size_t, size_t>> pairs;
  for (size_t t = 0; t < table.size(); ++t)
    for (size_t f = 0; f < found; ++f) {
      out.truth[t].best = std::max(out.truth[t].best, table[t][f]);
      if (table[t][f] > min_iou) pairs.emplace_back(-table[t][f], t, f);
    }
  std::sort(pairs.begin(), pairs.end());
  std::vector<bool> used(found, false);
  for (const auto& [worse, t, f] : pairs) {
    if (out.truth[t].found || used[f]) continue;
    out.truth[t].found = f;
    used[f] = true;
    ++out.matched;
  }
  const auto part = [&](size_t of) {
    return of > 0 ? static_cast<double>(out.matched) / static_cast<double>(of) : 0;
  };
  out.precision = part(found);
  out.recall = part(table.size());
  return out;
}

/// The rows or columns of pixels whose centres lie between two positions.
std::pair<int, int> between(double low, double high, int size) {
  const auto bound = [&](double v) {
    return static_cast<int>(std::clamp(std::ceil(v - 0.5), 0.0, static_cast<double>(size)));
  };
  return {bound(low), bound(high)};
}

}  // namespace

double iou(const Box& a, const Box& b) {
  const double both = area(common(a, b));
  return both > 0 ? both / (area(a) + area(b) - both) : 0;
}

double union_area(const std::vector<Box>& boxes) {
  std::vector<double> xs;
  for (const Box& box : boxes)
    if (!box.isEmpty()) xs.insert(xs.end(), {box.min.x, box.max.x});
  std::sort(xs.begin(), xs.end());
  double out = 0;
  for (size_t i = 0; i + 1 < xs.size(); ++i) {
    std::vector<std::pair<double, double>> spans;
    for (const Box& box : boxes)
      if (!box.isEmpty() && box.min.x <= xs[i] && box.max.x >= xs[i + 1])
        spans.emplace_back(box.min.y, box.max.y);
    std::sort(spans.begin(), spans.end());
    double reached = -kInfinity, high = 0;
    for (const auto& [low, top] : spans) {
      high += std::max(0.0, top - std::max(low, reached));
      reached = std::max(reached, top);
    }
    out += high * (xs[i + 1] - xs[i]);
  }
  return out;
}

Scores score(const std::vector<Box>& found, const std::vector<Box>& truth, double min_iou) {
  Table table(truth.size(), std::vector<double>(found.size()));
  std::vector<Box> both, all = found;
  all.insert(all.end(), truth.begin(), truth.end());
  for (size_t t = 0; t < truth.size(); ++t)
    for (size_t f = 0; f < found.size(); ++f) {
      table[t][f] = iou(truth[t], found[f]);
      both.push_back(common(truth[t], found[f]));
    }
  Scores out = matched(table, found.size(), min_iou);
  const double together = union_area(all);
  out.area_iou = together > 0 ? union_area(both) / together : 0;
  return out;
}

Scores score(const std::vector<Box>& found, const ObjectMap& truth, double min_iou) {
  const size_t width = static_cast<size_t>(std::max(truth.width, 0));
  if (truth.label.size() != width * static_cast<size_t>(std::max(truth.height, 0)) ||
      !(truth.pixel > 0))
    throw Error(ErrorCode::bad_input,
                "an object map needs one label per pixel and a pixel size above 0");
  const uint32_t objects =
      truth.label.empty() ? 0 : *std::max_element(truth.label.begin(), truth.label.end());
  if (objects > truth.label.size())
    throw Error(ErrorCode::bad_input, "an object map must number objects from 1 without gaps");
  std::vector<double> sizes(objects, 0);
  double all = 0, both = 0;
  for (const uint32_t label : truth.label)
    if (label > 0) ++sizes[label - 1], ++all;
  Table table(objects, std::vector<double>(found.size(), 0));
  std::vector<bool> hit(truth.label.size(), false);
  for (size_t f = 0; f < found.size(); ++f) {
    const Box& box = found[f];
    if (box.isEmpty()) continue;
    const auto [x0, x1] = between(box.min.x / truth.pixel, box.max.x / truth.pixel, truth.width);
    const auto [y0, y1] = between(truth.height - box.max.y / truth.pixel,
                                  truth.height - box.min.y / truth.pixel, truth.height);
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x) {
        const size_t p = static_cast<size_t>(y) * width + static_cast<size_t>(x);
        if (truth.label[p] > 0) ++table[truth.label[p] - 1][f];
        if (truth.label[p] > 0 && !hit[p]) ++both;
        hit[p] = true;
      }
    // The part of the box outside of the map counts too.
    const double pixels = area(box) / (truth.pixel * truth.pixel);
    for (uint32_t t = 0; t < objects; ++t)
      if (const double n = table[t][f]; n > 0) table[t][f] = n / (sizes[t] + pixels - n);
  }
  Scores out = matched(table, found.size(), min_iou);
  const double together = all + union_area(found) / (truth.pixel * truth.pixel) - both;
  out.area_iou = together > 0 ? both / together : 0;
  return out;
}

}  // namespace vug::scan
