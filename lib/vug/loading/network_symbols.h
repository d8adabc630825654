// SPDX-License-Identifier: Apache-2.0
// The symbols with which a grammar dresses a network: one for each leg, junction, end and sump.
#pragma once

#include <vug/base/value.h>
#include <vug/network/elements.h>

namespace vug::loading {

/// A value of an element that a rule can use under its name.
struct ElementAttribute {
  const char* name;
  const char* doc;
  Value (*of)(const network::Network& network, const network::Element& element);
};

struct NetworkSymbol {
  const char* name;  ///< E.g. "Leg".
  network::ElementKind kind;
  std::vector<ElementAttribute> attributes;
};

const std::vector<NetworkSymbol>& network_symbols();

/// For example "Leg, Junction, End or Sump" for the word "or".
std::string network_symbol_names(const char* last_word);

/// The symbol of that name, or null.
const NetworkSymbol* find_network_symbol(const std::string& name);

/// The values of all attributes, in order.
std::vector<Value> attributes_of(const NetworkSymbol& symbol, const network::Network& network,
                                 const network::Element& element);

/// E.g. "Leg 17" or "End dow.choke2.14".
std::string label_of(const NetworkSymbol& symbol, const network::Network& network,
                     const network::Element& element);

}  // namespace vug::loading
