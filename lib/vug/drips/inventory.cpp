// SPDX-License-Identifier: Apache-2.0
#include <vug/drips/inventory.h>
#include <vug/field/path.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace vug::drips {
namespace {

/// A number with commas between its thousands.
std::string grouped(double number) {
  std::string digits = fmt::format("{:.0f}", number);
  for (size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, ",");
  return digits;
}

/// Two significant digits.
double rounded(double number) {
  const double unit = std::pow(10.0, std::floor(std::log10(number)) - 1);
  return std::round(number / unit) * unit;
}

std::string interval_text(double seconds) {
  if (seconds < 10) return fmt::format("{:.1f} s a drop", seconds);
  return seconds < 600 ? fmt::format("{} s a drop", grouped(rounded(seconds)))
                       : fmt::format("{} min a drop", grouped(rounded(seconds / 60)));
}

std::string years_text(double years) { return years > 0 ? grouped(rounded(years)) : "0"; }

/// What happened to a form, for the end of its sentence.
std::string event_text(const Speleothem& s) {
  if (!(s.since > 0)) return "";
  const bool met = s.kind == kind_name(FormKind::column);
  return fmt::format(", {} {} years ago", met ? "met" : "broke", years_text(s.since));
}

/// The rate, the age and the joint of the water at a node.
Speleothem fed_by(const Node& node, const Graph& graph, const char* kind) {
  Speleothem out;
  out.kind = kind;
  out.drip = node.id;
  out.interval = graph.interval(node);
  out.age = node.water.age;
  out.plane = node.plane;
  return out;
}

/// The first node of each id: seeps come before landings.
std::map<int64_t, const Node*> sources_of(const Graph& graph, NodeKind kind) {
  std::map<int64_t, const Node*> out;
  for (const Node& node : graph.nodes)
    if (node.kind == kind) out.emplace(node.id, &node);
  return out;
}

void include(const field::Deposit& layer, Speleothem& out) {
  const bool first = out.size == 0;
  for (const Vec3d& p : {layer.from, layer.to}) {
    if (first || p.y > out.top.y) out.top = p;
    if (first || p.y < out.bottom.y) out.bottom = p;
  }
  out.length += (layer.to - layer.from).length();
  out.size = std::max({out.size, layer.thickness_from, layer.thickness_to});
}

}  // namespace

Speleothem listed(const Form& form) {
  return {
      kind_name(form.kind), form.drip,     form.top, form.bottom, (form.top - form.bottom).length(),
      form.radius,          form.interval, form.age, form.since,  form.plane};
}

std::vector<Speleothem> inventory(const Dripstone& grown, const Graph& graph) {
  std::vector<Speleothem> out;
  for (const Form& form : grown.forms) out.push_back(listed(form));
  const auto seeps = sources_of(graph, NodeKind::seep);
  for (const HungDrapery& drapery : grown.draperies) {
    const auto seep = seeps.find(drapery.drip);
    if (seep == seeps.end()) continue;
    Speleothem sheet = fed_by(*seep->second, graph, "drapery");
    sheet.top = drapery.sheet.path.front();
    sheet.bottom = drapery.sheet.path.back();
    sheet.length = field::path_length(drapery.sheet.path);
    sheet.size = drapery.sheet.width;
    out.push_back(sheet);
  }
  std::map<int64_t, const Node*> landings = sources_of(graph, NodeKind::landing);
  landings.insert(seeps.begin(), seeps.end());  // Of films that run down walls.
  std::map<int64_t, Speleothem> layers;
  for (const field::Deposit& layer : grown.layers) {
    const auto source = landings.find(layer.drip);
    if (source == landings.end()) continue;
    const auto place =
        layers.emplace(layer.drip, fed_by(*source->second, graph, "flowstone")).first;
    include(layer, place->second);
  }
  for (const auto& [drip, layer] : layers) out.push_back(layer);
  return out;
}

std::string explain(const Speleothem& s, size_t number, const Graph& graph) {
  const std::string on = s.plane < 0 ? "" : " on " + graph.planes[static_cast<size_t>(s.plane)];
  return fmt::format("{} {}: drip {}{}, {}, {} years{}", s.kind, number, s.drip, on,
                     interval_text(s.interval), years_text(s.age), event_text(s));
}

}  // namespace vug::drips
