// SPDX-License-Identifier: Apache-2.0
#include <vug/passages/water/body_builder.h>

#include <algorithm>

namespace vug::passages {

BodyBuilder::BodyBuilder(const FloorPlan& plan, const std::vector<double>& top, double overlap)
    : plan_(plan), top_(top), overlap_(overlap), adjacent_(neighbours(plan)) {}

SurfacePoint BodyBuilder::point(const FloorPoint& place, double height) const {
  const FloorNode& node = plan_.nodes[static_cast<size_t>(place.node)];
  return {place, node.position, height, std::min(node.floor, height)};
}

void BodyBuilder::append(const FloorLine& line, const std::vector<char>& separate) {
  for (size_t first = 0; first < line.size(); ++first) {
    if (!covered(line[first])) continue;
    size_t last = first;
    while (last + 1 < line.size() && !separate[last] && covered(line[last + 1])) ++last;
    append_run(line, separate, first, last);
    first = last;
  }
}

void BodyBuilder::append_run(const FloorLine& line, const std::vector<char>& separate, size_t first,
                             size_t last) {
  const auto falls_to = [&](size_t edge, size_t other) {
    return separate[edge] && covered(line[other]) && top(line[other]) < top(line[first]);
  };
  // A point within a fall has no surface of its own.
  if (first == last && ((first > 0 && falls_to(first - 1, first - 1)) ||
                        (last + 1 < line.size() && falls_to(last, last + 1))))
    return;
  std::vector<SurfacePoint> run;
  for (size_t i = first; i <= last; ++i) run.push_back(point(line[i], top(line[i])));
  SurfaceOptions options{.overlap = overlap_};
  const auto is_dead_end = [&](size_t i) {
    return adjacent_[static_cast<size_t>(line[i].node)].size() == 1;
  };
  if (first == 0) {
    options.rounded_start = is_dead_end(0);
  } else if (!covered(line[first - 1])) {
    run.insert(run.begin(), point(line[first - 1], top(line[first])));
  } else if (top(line[first]) < top(line[first - 1])) {
    options.rounded_start = true;
    for (size_t i = first; i > 0 && separate[i - 1]; --i)
      run.front().place.reach = std::max(run.front().place.reach, line[i - 1].reach);
  }
  if (last + 1 == line.size()) {
    options.rounded_end = is_dead_end(last);
  } else if (!covered(line[last + 1])) {
    run.push_back(point(line[last + 1], top(line[last])));
  } else if (top(line[last]) < top(line[last + 1])) {
    options.rounded_end = true;
    for (size_t i = last; i + 1 < line.size() && separate[i]; ++i)
      run.back().place.reach = std::max(run.back().place.reach, line[i + 1].reach);
  }
  append_body(run, options, parts);
}

}  // namespace vug::passages
