// SPDX-License-Identifier: Apache-2.0
#include <vug/language/completion_list.h>
#include <vug/language/includable_files.h>

namespace vug::language {

Completions complete(const Workspace& workspace, const Analysis& analysis,
                     const Position& position) {
  const Context context = context_at(analysis, position);
  CompletionList list(analysis, position, context);
  switch (context.place) {
    case Place::statement:
      list.add_statements();
      break;
    case Place::path:
      for (const std::string& name : includable_files(workspace, analysis.file))
        list.add({name, CompletionKind::file, "scene", "", "", 0});
      break;
    case Place::grammar_kind:
      for (const char* kind : {"shape", "facade", "lsystem"})
        list.add(
            {kind, CompletionKind::keyword, "kind of grammar", find_declaration(kind)->doc, "", 0});
      break;
    case Place::key:
      list.add_keys();
      break;
    case Place::value:
      list.add_values();
      break;
    case Place::symbols:
      list.add_symbols();
      break;
    case Place::member:
      list.add_members();
      break;
    case Place::unit:
      list.add_units();
      break;
    case Place::after_value:
      list.add_words(inner_words(), {"in", "on", "as", "where", "and", "or", "if", "for"}, 0);
      break;
    case Place::nothing:
    case Place::new_name:
      break;
  }
  return {context.range, list.take()};
}

}  // namespace vug::language
