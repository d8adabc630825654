// SPDX-License-Identifier: Apache-2.0
#include <vug/loading/reader.h>
#include <vug/shot/networks.h>

namespace vug::loading {

const DeclarationKind& network_declaration() {
  static const DeclarationKind kind = {
      kind_declaration_info("network",
                            "The plan of a cave, a graph of stations and legs: network NAME = "
                            "graph(...).",
                            "network", ""),
      [](const scene::Declaration& declaration, ReadContext& context) {
        const Value value = read_kind_declaration("network", "", declaration, context);
        if (const auto* network = value.object<shot::NetworkPtr>())
          context.shot.networks.push_back({declaration.name, *network});
        return value;
      }};
  return kind;
}

}  // namespace vug::loading
