// SPDX-License-Identifier: Apache-2.0
#include <vug/fit/search/element_rows.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace vug::fit {
namespace {

/// An element between two positions of a row.
struct RowElement {
  double bits = 0;
  int id = -1;  ///< The production of its element; -1: none.
  Rect rect;
};

class ElementRowSearch {
 public:
  ElementRowSearch(const MoveContext& context, const Evidence& evidence, const TreeState& state,
                   int i, int id)
      : model_(context.model),
        rules_(model_.rules()),
        evidence_(evidence),
        state_(state),
        i_(i),
        area_(state.area(i)),
        id_(id) {
    element_ = rules_.production(id).parts[0];
    whole_ = sum_of(evidence, state, area_);
    wall_bits_ = model_.likelihood()->bits(RegionType::wall, whole_);
    xs_ = with_borders(strongest_edges(evidence, state, area_, true, kColumns), area_.width);
    ys_ = with_borders(strongest_edges(evidence, state, area_, false, kHeights), area_.height);
  }

  /// The best separate elements, with the wall between them split among them; empty if there are
  /// none.
  std::vector<TreeState> make() const {
    const size_t n = xs_.size();
    // min_bits[k]: bits of everything before position k, counting wall outside of the
    // elements.
    std::vector<double> min_bits(n, 0);
    std::vector<RowElement> last(n);
    std::vector<size_t> from(n, 0);
    const int x_bits = bits_for(model_.width()), y_bits = bits_for(model_.height());
    const double node = std::log2(static_cast<double>(rules_.symbols.size()));
    const double cost = 2 * node + 3 * x_bits + 2 * y_bits;
    for (size_t k = 1; k < n; ++k) {
      min_bits[k] = min_bits[k - 1];
      from[k] = k - 1;
      for (size_t j = 0; j < k; ++j) {
        const RowElement element = between(xs_[j], xs_[k]);
        if (element.id < 0 || min_bits[j] + element.bits + cost >= min_bits[k]) continue;
        min_bits[k] = min_bits[j] + element.bits + cost;
        last[k] = element;
        from[k] = j;
      }
    }
    std::vector<RowElement> row_elements;
    for (size_t k = n - 1; k > 0; k = from[k])
      if (last[k].id >= 0) row_elements.push_back(last[k]);
    std::reverse(row_elements.begin(), row_elements.end());
    if (row_elements.empty() ||
        static_cast<int>(row_elements.size()) > model_.limits().max_elements)
      return {};
    return built(row_elements);
  }

 private:
  static constexpr int kColumns = 28, kHeights = 6;

  static std::vector<int> with_borders(std::vector<int> places, int size) {
    places.insert(places.begin(), 0);
    places.push_back(size);
    return places;
  }

  /// The element that saves most there, relative to the area's code as wall.
  RowElement between(int x0, int x1) const {
    RowElement best;
    const int min_size = model_.limits().min_size;
    if (x1 - x0 < min_size) return best;
    const Likelihood& likelihood = *model_.likelihood();
    for (size_t top = 0; top + 1 < ys_.size(); ++top)
      for (size_t bottom = top + 1; bottom < ys_.size(); ++bottom) {
        if (ys_[bottom] - ys_[top] < min_size) continue;
        const Rect rect{x0, ys_[top], x1, ys_[bottom]};
        const Sums sums = sum_of(evidence_, state_, area_, rect);
        Sums rest = whole_;
        rest -= sums;
        const double saved = wall_bits_ - likelihood.bits(RegionType::wall, rest);
        for (const int id : rules_.productions_of(element_)) {
          if (rules_.production(id).op != Op::terminal) continue;
          const RegionType type = rules_.symbol(rules_.production(id).parts[0]).type;
          if (!model_.admits(type, area_, rect)) continue;
          const double bits = model_.pixel_weight() * (likelihood.bits(type, sums) - saved);
          if (bits < best.bits) best = {bits, id, rect};
        }
      }
    return best;
  }

  std::vector<TreeState> built(const std::vector<RowElement>& row_elements) const {
    TreeState out = state_;
    std::vector<Node> parts;
    int x = 0;
    for (size_t k = 0; k < row_elements.size(); ++k) {
      Node part;
      part.symbol = static_cast<int16_t>(element_);
      part.parent_op = static_cast<int8_t>(Op::elements);
      const int end = k + 1 < row_elements.size()
                          ? (row_elements[k].rect.x1 + row_elements[k + 1].rect.x0) / 2
                          : 0;
      part.extent = static_cast<int16_t>(k + 1 < row_elements.size() ? end - x : 0);
      x = end;
      parts.push_back(part);
    }
    out.grow(i_, id_, parts);
    if (!std::isfinite(model_.energy(out))) return {};
    for (size_t k = row_elements.size(); k-- > 0;) {
      const int at = i_ + 1 + static_cast<int>(k);
      const RowElement& element = row_elements[k];
      const int begin = k > 0 ? (row_elements[k - 1].rect.x1 + element.rect.x0) / 2 : 0;
      Node node;
      node.symbol = static_cast<int16_t>(rules_.production(element.id).parts[0]);
      node.parent_op = static_cast<int8_t>(Op::terminal);
      node.x = static_cast<int16_t>(element.rect.x0 - begin);
      node.y = static_cast<int16_t>(element.rect.y0);
      node.width = static_cast<int16_t>(element.rect.x1 - element.rect.x0);
      node.height = static_cast<int16_t>(element.rect.y1 - element.rect.y0);
      out.grow(at, element.id, {node});
    }
    if (!std::isfinite(model_.energy(out))) return {};
    return {out};
  }

  const Model& model_;
  const Rules& rules_;
  const Evidence& evidence_;
  const TreeState& state_;
  const int i_;
  const Area area_;
  const int id_;
  int element_ = 0;
  Sums whole_;
  double wall_bits_ = 0;
  std::vector<int> xs_, ys_;
};

}  // namespace

std::vector<int> strongest_edges(const Evidence& evidence, const TreeState& state, const Area& area,
                                 bool along_x, int most) {
  constexpr int kHalfStrip = 2;
  const int size = along_x ? area.width : area.height;
  const auto strip = [&](int begin, int end) {
    const int low = std::max(0, begin), high = std::min(size, end);
    return sum_of(evidence, state, area,
                  along_x ? Rect{low, 0, high, area.height} : Rect{0, low, area.width, high});
  };
  std::vector<double> change(static_cast<size_t>(size) + 1, 0);
  for (int place = kHalfStrip; place + kHalfStrip <= size; ++place) {
    const Sums a = strip(place - kHalfStrip, place), b = strip(place, place + kHalfStrip);
    for (size_t lane = 0; lane < a.lane.size(); ++lane)
      change[static_cast<size_t>(place)] +=
          std::fabs(static_cast<double>(a.lane[lane]) - static_cast<double>(b.lane[lane]));
  }
  std::vector<int> order;
  for (int place = 1; place < size; ++place) {
    const auto at = static_cast<size_t>(place);
    if (change[at] > 0 && change[at] >= change[at - 1] && change[at] > change[at + 1])
      order.push_back(place);
  }
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return change[static_cast<size_t>(a)] > change[static_cast<size_t>(b)];
  });
  if (static_cast<int>(order.size()) > most) order.resize(static_cast<size_t>(most));
  std::sort(order.begin(), order.end());
  return order;
}

std::vector<Rect> ground_elements_between(const MoveContext& context, const Evidence& evidence,
                                          const TreeState& state, int i,
                                          const std::vector<Segment>& columns) {
  constexpr int kColumns = 24, kTops = 10;
  const Model& model = context.model;
  const Likelihood& likelihood = *model.likelihood();
  const Area area = state.area(i);
  std::vector<int> xs = strongest_edges(evidence, state, area, true, kColumns);
  const std::vector<int> tops = strongest_edges(evidence, state, area, false, kTops);
  const auto inside = [&](int x0, int x1) {
    return std::any_of(columns.begin(), columns.end(),
                       [&](const Segment& c) { return c.start < x1 && x0 < c.end; });
  };
  const Sums whole = sum_of(evidence, state, area);
  Sums rest = whole;
  for (const Segment& c : columns)
    rest -= sum_of(evidence, state, area, {c.start, 0, c.end, area.height});
  const double wall = likelihood.bits(RegionType::wall, rest);
  const int min_size = model.limits().min_size;
  std::vector<std::pair<double, Rect>> found;
  for (const int top : tops) {
    std::pair<double, Rect> best;
    for (size_t a = 0; a < xs.size(); ++a)
      for (size_t b = a + 1; b < xs.size() && !inside(xs[a], xs[b]); ++b) {
        if (xs[b] - xs[a] < min_size || area.height - top < min_size) continue;
        const Rect rect{xs[a], top, xs[b], area.height};
        if (!model.admits(RegionType::door, area, rect)) continue;
        const Sums sums = sum_of(evidence, state, area, rect);
        Sums left = rest;
        left -= sums;
        const double saved = wall - likelihood.bits(RegionType::wall, left) -
                             likelihood.bits(RegionType::door, sums);
        if (saved > best.first) best = {saved, rect};
      }
    if (best.first > 0) found.push_back(best);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Rect> out;
  for (const auto& one : found) out.push_back(one.second);
  return out;
}

std::vector<TreeState> element_row_candidates(const MoveContext& context, const Evidence& evidence,
                                              const TreeState& state, int i) {
  for (const int id : context.model.rules().productions_of(state.tree[i].symbol))
    if (context.model.rules().production(id).op == Op::elements && context.model.likelihood())
      return ElementRowSearch(context, evidence, state, i, id).make();
  return {};
}

}  // namespace vug::fit
