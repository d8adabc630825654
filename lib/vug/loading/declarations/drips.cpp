// SPDX-License-Identifier: Apache-2.0
#include <vug/loading/reader.h>
#include <vug/shot/drips_plan.h>

namespace vug::loading {

const DeclarationKind& drips_declaration() {
  static const DeclarationKind kind = {
      kind_declaration_info("drips",
                            "The drips of a cave, with what grows from them: drips NAME = "
                            "seepage(ROCK, ...).",
                            "drips", ""),
      [](const scene::Declaration& declaration, ReadContext& context) {
        const Value value = read_kind_declaration("drips", "", declaration, context);
        if (const auto* drips = value.object<shot::DripsPtr>())
          context.shot.drips.push_back({declaration.name, *drips});
        return value;
      }};
  return kind;
}

}  // namespace vug::loading
