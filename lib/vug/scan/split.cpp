// SPDX-License-Identifier: Apache-2.0
#include <vug/scan/split.h>

#include <algorithm>

namespace vug::scan {
namespace {

/// A straight cut between rows (or columns) at - 1 and `at`.
struct Cut {
  bool between_rows = true;
  int at = 0;
  int64_t area = INT64_MAX;  ///< Area of the boxes around the parts on both sides.
};

/// For each line (a column for cuts between rows): the extent of its pixels on one side of a cut.
struct LineExtent {
  int begin = 0, end = 0;
  bool empty() const { return begin >= end; }
};

/// Area of the boxes around runs of adjacent non-empty lines.
int64_t area_of_runs(const std::vector<LineExtent>& lines) {
  int64_t area = 0;
  for (size_t i = 0; i < lines.size();) {
    if (lines[i].empty()) {
      ++i;
      continue;
    }
    const size_t first = i;
    LineExtent all = lines[i];
    for (; i < lines.size() && !lines[i].empty(); ++i)
      all = {std::min(all.begin, lines[i].begin), std::max(all.end, lines[i].end)};
    area += static_cast<int64_t>(i - first) * (all.end - all.begin);
  }
  return area;
}

/// For each cut the area before it, in a mask oriented so that cuts are between rows; `backwards`:
/// the area after it.
template <class At>
std::vector<int64_t> areas(int width, int height, const At& on, bool backwards) {
  std::vector<int64_t> out(static_cast<size_t>(height) + 1, 0);
  std::vector<LineExtent> lines(static_cast<size_t>(width));
  for (int step = 0; step < height; ++step) {
    const int y = backwards ? height - 1 - step : step;
    for (int x = 0; x < width; ++x) {
      if (!on(x, y)) continue;
      LineExtent& line = lines[static_cast<size_t>(x)];
      line = line.empty() ? LineExtent{y, y + 1}
                          : LineExtent{std::min(line.begin, y), std::max(line.end, y + 1)};
    }
    out[static_cast<size_t>(backwards ? y : y + 1)] = area_of_runs(lines);
  }
  return out;
}

template <class At>
void find_cut(int width, int height, bool between_rows, const At& on, Cut& best) {
  const std::vector<int64_t> before = areas(width, height, on, false);
  const std::vector<int64_t> behind = areas(width, height, on, true);
  for (int at = 1; at < height; ++at) {
    const int64_t area = before[static_cast<size_t>(at)] + behind[static_cast<size_t>(at)];
    if (area < best.area) best = {between_rows, at, area};
  }
}

}  // namespace

std::vector<FilledBox> split(const Component& group, double gain, double fill) {
  const Mask& mask = group.mask;
  Cut cut;
  find_cut(
      mask.width, mask.height, true, [&](int x, int y) { return mask.at(x, y); }, cut);
  find_cut(
      mask.height, mask.width, false, [&](int x, int y) { return mask.at(y, x); }, cut);
  const auto whole = static_cast<double>(group.box.area());
  const auto parts = static_cast<double>(cut.area);
  const bool worth =
      parts <= (1 - gain) * whole && static_cast<double>(group.pixels) >= fill * parts;
  if (!worth) return {{group.box, group.pixels}};
  std::vector<FilledBox> out;
  for (const bool behind : {false, true}) {
    Mask side = mask;
    for (int y = 0; y < mask.height; ++y)
      for (int x = 0; x < mask.width; ++x)
        if (((cut.between_rows ? y : x) >= cut.at) != behind) side.on[side.index(x, y)] = 0;
    for (Component& part : components_of(side)) {
      const int x = group.box.x0, y = group.box.y0;
      part.box = {part.box.x0 + x, part.box.y0 + y, part.box.x1 + x, part.box.y1 + y};
      const std::vector<FilledBox> pieces = split(part, gain, fill);
      out.insert(out.end(), pieces.begin(), pieces.end());
    }
  }
  return out;
}

}  // namespace vug::scan
