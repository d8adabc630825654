// SPDX-License-Identifier: Apache-2.0
// Results of the language module as the JSON of the protocol.
#pragma once

#include "lsp/documents.h"

#include <vug/language/completion.h>
#include <vug/language/outline.h>

namespace vug::lsp {

Json markdown(const std::string& text);
Json to_json(const language::Completions& completions, const Documents& documents, bool snippets);
Json to_json(const language::OutlineItem& item, const Documents& documents);
/// A snippet without its fields.
std::string plain_text(const std::string& snippet);

}  // namespace vug::lsp
