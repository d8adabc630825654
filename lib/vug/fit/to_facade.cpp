// SPDX-License-Identifier: Apache-2.0
#include <vug/fit/to_facade.h>

#include <algorithm>
#include <map>

namespace vug::fit {
namespace {

class FacadeTreeBuilder {
 public:
  FacadeTreeBuilder(const facade::Rules& text, const Model& model, const TreeState& state,
                    const Vec2d& pixel)
      : text_(text), model_(model), state_(state), pixel_(pixel) {}

  facade::Tree run() {
    out_.name = text_.name;
    out_.width = model_.width() * pixel_.x;
    out_.height = model_.height() * pixel_.y;
    convert(0, -1);
    return std::move(out_);
  }

 private:
  const Node& node(int i) const { return state_.tree[i]; }
  const SymbolInfo& symbol(int i) const { return model_.rules().symbol(node(i).symbol); }
  facade::Node& out(int i) { return out_.nodes[static_cast<size_t>(i)]; }

  /// Rectangle of the first instance of an area, which is never mirrored.
  facade::Rect rect_of(const Area& area) const {
    return metres(area, 0, 0, area.width, area.height);
  }
  facade::Rect metres(const Area& area, int x, int y, int width, int height) const {
    const Rect r = Model::in_picture(area, state_.instance(area, 0), x, y, width, height);
    return {r.x0 * pixel_.x, (model_.height() - r.y1) * pixel_.y, (r.x1 - r.x0) * pixel_.x,
            (r.y1 - r.y0) * pixel_.y};
  }

  int add(int i, int parent, const facade::Rect& rect) {
    facade::Node made;
    made.symbol = symbol(i).name;
    made.text = made.symbol;
    made.parent = parent;
    made.rect = rect;
    if (symbol(i).terminal) made.element = element(made.symbol);
    const int at = static_cast<int>(out_.nodes.size());
    out_.nodes.push_back(std::move(made));
    if (parent >= 0) out(parent).children.push_back(at);
    return at;
  }

  facade::ElementPtr element(const std::string& name) {
    facade::ElementPtr& known = elements_[name];
    if (!known) known = make_product(facade::elements(), name);
    return known;
  }

  void convert(int i, int parent) {
    const int at = add(i, parent, rect_of(state_.area(i)));
    set_numbers(i, parent, at);
    if (node(i).production < 0) return;
    const Production& production = model_.rules().production(node(i).production);
    out(at).rule = to_string(text_.rules[static_cast<size_t>(node(i).production)]);
    const auto& items = text_.rules[static_cast<size_t>(node(i).production)].items;
    if (items[0].split) out(at).split = items[0].name;
    if (production.op == Op::windows) return windows(i, at);
    if (production.op == Op::terminal) {
      const Node& seen = node(i + 1);
      add(i + 1, at, metres(state_.area(i), seen.x, seen.y, seen.width, seen.height));
      return;
    }
    for (int part = i + 1; part < state_.tree.end(i); part = state_.tree.end(part))
      convert(part, at);
  }

  /// Sets the numbers and copies that the parent's production gives to a child.
  void set_numbers(int i, int parent, int at) {
    if (parent < 0) return;
    const int above = state_.tree.parent(i);
    const facade::Rect from = out(parent).rect, rect = out(at).rect;
    const bool first = i == above + 1, last = state_.tree.end(i) == state_.tree.end(above);
    switch (static_cast<Op>(node(i).parent_op)) {
      case Op::rows:
        out(at).given = {{"height", rect.height}};
        return;
      case Op::repeat:
        out(at).given = {{"count", node(i).extent}};
        for (int k = 1; k < node(i).extent; ++k)
          out(at).copies.push_back(facade::Placement::shift(k * rect.width, 0));
        return;
      case Op::mirror:
        if (first)
          out(at).copies = {facade::Placement::mirror(from.x + from.width / 2)};
        else
          out(at).given = {{"width", rect.width}};
        return;
      case Op::elements:
        if (!(first && last)) out(at).given = {{"width", rect.width}};
        return;
      default:
        return;
    }
  }

  /// Windows of a grid, one node per kind, and its door.
  void windows(int i, int at) {
    std::map<int, std::vector<facade::Rect>> rects;
    model_.each_window(state_.tree, i, [&](int part, const Rect& r) {
      rects[part].push_back(metres(state_.area(i), r.x0, r.y0, r.x1 - r.x0, r.y1 - r.y0));
    });
    out(at).numbers = numbers(i);
    for (auto& [part, all] : rects) {
      // From the lowest row up, in the order of splits.
      std::stable_sort(all.begin(), all.end(),
                       [](const auto& a, const auto& b) { return a.y < b.y; });
      const int made = add(part, at, all[0]);
      for (size_t k = 1; k < all.size(); ++k)
        out(made).copies.push_back(
            facade::Placement::shift(all[k].x - all[0].x, all[k].y - all[0].y));
    }
    const int last = state_.tree.end(i) - 1;
    if (symbol(last).type == RegionType::window) return;
    const Node& door = node(last);
    add(last, at, metres(state_.area(i), door.x, door.y, door.width, door.height));
  }

  /// Counts, the position of the lower left cell, and the spacings.
  facade::Numbers numbers(int i) const {
    const Node& grid = node(i);
    const Area& area = state_.area(i);
    // Lines count from the top, splits from the bottom, where the highest window of a row ends.
    std::vector<double> x, y;
    for (int c = 0; c < grid.columns; ++c)
      x.push_back(grid.left[static_cast<size_t>(c)] * pixel_.x);
    for (int r = grid.rows; r-- > 0;)
      y.push_back((area.height - grid.top[static_cast<size_t>(r)] - row_height(i, r)) * pixel_.y);
    facade::Numbers out = {{"columns", static_cast<double>(grid.columns)},
                           {"rows", static_cast<double>(grid.rows)},
                           {"x", x[0]},
                           {"y", y[0]}};
    for (const auto& [name, line] : {std::pair("dx", &x), std::pair("dy", &y)}) {
      if (line->size() == 1) out.emplace_back(name, 0);
      const size_t listed = symbol(i).regular ? std::min<size_t>(2, line->size()) : line->size();
      for (size_t k = 1; k < listed; ++k) out.emplace_back(name, (*line)[k] - (*line)[k - 1]);
    }
    return out;
  }

  /// Height of the highest window in that row of grid i, pixels.
  int row_height(int i, int row) const {
    int most = 0;
    for (int c = 0; c < node(i).columns; ++c) {
      const int kind = symbol(i).identical ? 1 : node(i).kind(c, row);
      if (kind > 0) most = std::max<int>(most, node(i + kind).height);
    }
    return most;
  }

  const facade::Rules& text_;
  const Model& model_;
  const TreeState& state_;
  Vec2d pixel_;
  facade::Tree out_;
  std::map<std::string, facade::ElementPtr> elements_;
};

}  // namespace

facade::Tree to_facade_tree(const facade::Rules& text, const Model& model, const TreeState& state,
                            const Vec2d& pixel) {
  return FacadeTreeBuilder(text, model, state, pixel).run();
}

}  // namespace vug::fit
