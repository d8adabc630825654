// SPDX-License-Identifier: Apache-2.0
#include <vug/loading/reader.h>

namespace vug::loading {

const DeclarationKind& render_declaration() {
  static const DeclarationKind kind = {
      shot::render_schema().info(),
      [](const scene::Declaration& declaration, ReadContext& context) -> Value {
        std::optional<shot::RenderSettings> settings =
            read_block(shot::render_schema(), declaration, context);
        if (!settings) return Value();
        if (const auto fault = shot::find_fault(*settings)) {
          for (const scene::Entry& entry : declaration.entries)
            if (entry.key == fault->setting)
              context.diagnostics.error(entry.where, fault->message, fault->hint);
          return Value();
        }
        context.shot.renders.push_back({declaration.name, std::move(*settings), declaration.where});
        return Value(Value::Name{declaration.name});
      }};
  return kind;
}

}  // namespace vug::loading
