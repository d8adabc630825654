// SPDX-License-Identifier: Apache-2.0
// SVG drawings of derivation trees.
#include <vug/base/xml.h>
#include <vug/grammar/layout.h>
#include <vug/grammar/tree_output.h>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

namespace vug::grammar {
namespace {

bool starts_character(char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }

/// At most `limit` characters of UTF-8 text; a truncated text ends in an ellipsis.
std::string shortened(const std::string& text, double limit) {
  double seen = 0;
  for (size_t i = 0; i < text.size(); ++i) {
    if (!starts_character(text[i])) continue;
    if (++seen > limit - 1 && std::count_if(text.begin() + static_cast<std::ptrdiff_t>(i),
                                            text.end(), starts_character) > 1)
      return text.substr(0, i) + "…";
  }
  return text;
}

std::string hover(const Tree& tree, int id) {
  const Node& node = tree.nodes[static_cast<size_t>(id)];
  std::string out = tree.path(id);
  if (node.production >= 0) {
    const ProductionInfo& p = tree.productions[static_cast<size_t>(node.production)];
    out += "; " + p.name;
    if (p.where.known()) out += "; " + vug::to_string(p.where);
  }
  return node.stuck ? out + "; no production applies" : out;
}

constexpr double kPadding = 6;  // left and right of a label

/// Pale colours for dark text, assigned to symbols in order of appearance.
constexpr const char* kFills[] = {"#ece7df", "#dfe9f4", "#e3f0dc", "#f9e3dc", "#f8efcf",
                                  "#ebe3f5", "#dcf0ee", "#f6e0ec", "#e6e6e6"};

/// The fill colour of every node's box: one per symbol name.
std::vector<const char*> fills(const Tree& tree) {
  std::map<std::string, size_t> order;
  std::vector<const char*> out;
  for (const Node& node : tree.nodes) {
    const size_t at = order.emplace(node.symbol.name, order.size()).first->second;
    out.push_back(kFills[at % std::size(kFills)]);
  }
  return out;
}

}  // namespace

std::string tree_svg(const Tree& tree, const SvgOptions& options) {
  const std::vector<double> place = tidy_layout(tree);
  const double margin = options.row;
  std::vector<std::string> labels;
  std::vector<double> widths;  // of boxes, for glyphs of 0.61 em
  std::vector<double> column;  // first the widest label of a generation, then its left edge
  for (const Node& node : tree.nodes) {
    labels.push_back(shortened(to_string(node.symbol), options.max_label));
    const auto glyphs = std::count_if(labels.back().begin(), labels.back().end(), starts_character);
    widths.push_back(0.61 * options.font_size * static_cast<double>(glyphs) + 2 * kPadding);
    const auto depth = static_cast<size_t>(node.depth);
    if (column.size() <= depth) column.resize(depth + 1, 0);
    column[depth] = std::max(column[depth], widths.back());
  }
  double left = margin;
  for (double& c : column) {
    const double width = c;
    c = left;
    left += width + options.column_gap;
  }
  const double highest = place.empty() ? 0 : *std::max_element(place.begin(), place.end());
  const auto x = [&](size_t i) { return column[static_cast<size_t>(tree.nodes[i].depth)]; };
  const auto y = [&](size_t i) { return margin + options.row * place[i]; };

  std::string out;
  const auto to = std::back_inserter(out);
  fmt::format_to(to,
                 "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{:.0f}\" height=\"{:.0f}\" "
                 "font-family=\"DejaVu Sans Mono, monospace\" font-size=\"{:.1f}\">\n"
                 "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n"
                 "<g fill=\"none\" stroke=\"#9a8f80\">\n",
                 left - options.column_gap + margin, 2 * margin + options.row * highest,
                 options.font_size);
  for (size_t i = 1; i < tree.nodes.size(); ++i) {
    const auto p = static_cast<size_t>(tree.nodes[i].parent);
    const double x0 = x(p) + widths[p], x1 = x(i), bend = 0.5 * options.column_gap;
    fmt::format_to(to, "<path d=\"M{:.1f} {:.1f}C{:.1f} {:.1f} {:.1f} {:.1f} {:.1f} {:.1f}\"/>\n",
                   x0, y(p), x1 - bend, y(p), x1 - bend, y(i), x1, y(i));
  }
  fmt::format_to(to, "</g>\n<g stroke=\"#c9c0b2\" stroke-width=\"0.7\">\n");
  const std::vector<const char*> fill = fills(tree);
  const double box = std::min(options.row - 3, 1.5 * options.font_size);
  for (size_t i = 0; i < tree.nodes.size(); ++i)
    fmt::format_to(to,
                   "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" "
                   "rx=\"4\" fill=\"{}\"/>\n",
                   x(i), y(i) - 0.5 * box, widths[i], box, fill[i]);
  // Avoids dominant-baseline, which some programs do not support: 0.35 em is half the cap height.
  fmt::format_to(to, "</g>\n<g fill=\"#2b241c\">\n");
  for (size_t i = 0; i < tree.nodes.size(); ++i)
    fmt::format_to(to, "<text x=\"{:.1f}\" y=\"{:.1f}\"{}><title>{}</title>{}</text>\n",
                   x(i) + kPadding, y(i) + 0.35 * options.font_size,
                   tree.nodes[i].production >= 0 ? " font-weight=\"bold\"" : "",
                   xml_text(hover(tree, static_cast<int>(i))), xml_text(labels[i]));
  return out + "</g>\n</svg>\n";
}

}  // namespace vug::grammar
