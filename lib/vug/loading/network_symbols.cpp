// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/loading/network_symbols.h>
#include <vug/passages/passages.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::loading {
namespace {

using network::Element;
using network::ElementKind;
using network::Network;

Value length(double metres) { return Number{metres, Dimension::length}; }
Value angle(double radians) { return Number{radians, Dimension::angle}; }

const network::Leg& leg_of(const Network& network, const Element& element) {
  return network.legs[static_cast<size_t>(element.index)];
}

const network::StationFlags& flags_of(const Network& network, const Element& element) {
  return network.stations[static_cast<size_t>(element.index)].flags;
}

Vec3d vector_of(const Network& network, const Element& element) {
  return leg_vector(network, leg_of(network, element));
}

double azimuth_of(const Vec3d& direction) {
  const double azimuth = maths::atan2(direction.x, -direction.z);
  return azimuth < 0 ? azimuth + 2 * kPi : azimuth;
}

/// Attributes of all elements.
const ElementAttribute kWidth = {
    "width", "the width of the passage", [](const Network& n, const Element& e) {
      return length(size_of(n, e).width.value_or(passages::DefaultSize{}.width));
    }};
const ElementAttribute kHeight = {
    "height", "the height of the passage", [](const Network& n, const Element& e) {
      return length(size_of(n, e).height.value_or(passages::DefaultSize{}.height));
    }};
const ElementAttribute kPosition = {
    "position", "the middle of the leg, or the station", [](const Network&, const Element& e) {
      return Value(Value::Vector{e.frame.origin(), Dimension::length});
    }};
const ElementAttribute kAzimuth = {
    "azimuth", "the compass direction of the x-axis",
    [](const Network&, const Element& e) { return angle(azimuth_of(e.frame.column(0))); }};

std::vector<ElementAttribute> end_attributes() {
  return {kWidth,
          kHeight,
          kPosition,
          kAzimuth,
          {"entrance", "whether it is an entrance",
           [](const Network& n, const Element& e) { return Value(flags_of(n, e).entrance); }},
          {"sink", "whether water enters there",
           [](const Network& n, const Element& e) { return Value(flags_of(n, e).sink); }},
          {"spring", "whether water leaves there",
           [](const Network& n, const Element& e) { return Value(flags_of(n, e).spring); }}};
}

}  // namespace

const std::vector<NetworkSymbol>& network_symbols() {
  static const std::vector<NetworkSymbol> symbols = {
      {"Leg",
       ElementKind::leg,
       {kWidth,
        kHeight,
        kPosition,
        kAzimuth,
        {"length", "the length of the leg",
         [](const Network& n, const Element& e) { return length(vector_of(n, e).length()); }},
        {"slope", "the angle above the horizontal, downstream",
         [](const Network& n, const Element& e) {
           const Vec3d v = vector_of(n, e);
           return angle(maths::atan2(v.y, Vec3d(v.x, 0, v.z).length()));
         }},
        {"vadose", "whether the passage formed above the water table",
         [](const Network& n, const Element& e) {
           return Value(leg_of(n, e).stage == network::Stage::vadose);
         }},
        {"tier", "the water table that formed it: 0 for the present one",
         [](const Network& n, const Element& e) { return Value(leg_of(n, e).tier); }},
        {"discharge", "the water that flows through it, 1 from each sink",
         [](const Network& n, const Element& e) { return Value(leg_of(n, e).discharge); }}}},
      {"Junction",
       ElementKind::junction,
       {kWidth,
        kHeight,
        kPosition,
        kAzimuth,
        {"legs", "the number of legs that meet",
         [](const Network&, const Element& e) { return Value(e.legs); }}}},
      {"End", ElementKind::end, end_attributes()},
      {"Sump", ElementKind::sump, {kWidth, kHeight, kPosition, kAzimuth}}};
  return symbols;
}

std::string network_symbol_names(const char* last_word) {
  const auto& all = network_symbols();
  std::string text;
  for (size_t i = 0; i < all.size(); ++i)
    text += fmt::format("{}{}",
                        i == 0               ? ""
                        : i + 1 < all.size() ? ", "
                                             : fmt::format(" {} ", last_word),
                        all[i].name);
  return text;
}

const NetworkSymbol* find_network_symbol(const std::string& name) {
  const auto& all = network_symbols();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const NetworkSymbol& one) { return one.name == name; });
  return found == all.end() ? nullptr : &*found;
}

std::vector<Value> attributes_of(const NetworkSymbol& symbol, const Network& network,
                                 const Element& element) {
  std::vector<Value> values;
  for (const ElementAttribute& attribute : symbol.attributes)
    values.push_back(attribute.of(network, element));
  return values;
}

std::string label_of(const NetworkSymbol& symbol, const Network& network, const Element& element) {
  if (element.kind == ElementKind::leg) return fmt::format("{} {}", symbol.name, element.index + 1);
  const std::string& name = network.stations[static_cast<size_t>(element.index)].name;
  return fmt::format("{} {}", symbol.name, name.empty() ? std::to_string(element.index + 1) : name);
}

}  // namespace vug::loading
