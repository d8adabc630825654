// SPDX-License-Identifier: Apache-2.0
// The kinds, parameters and words of the scene language, for completion and hover.
#pragma once

#include <vug/loading/kind_params.h>

#include <string>
#include <vector>

namespace vug::language {

/// A kind that expressions can call.
struct CallableKind {
  const KindInfo* info = nullptr;
  std::string type;  ///< The type of its value: "field", "light", "split", ...
};

/// All of them, those of plugins included.
const std::vector<CallableKind>& callable_kinds();
/// Those of that name: `sphere` is both a field and a light.
const std::vector<CallableKind>& callable_kinds(const std::string& name);

using loading::element_type;
using loading::find_param;

/// The description of a declaration or of a kind of grammar ("grammar", "lsystem", "facade"); null
/// for other words.
const KindInfo* find_declaration(const std::string& keyword);

/// The words that begin declarations, in the order of `vug list`.
std::vector<std::string> declaration_words();

/// The parameters of a block: those of its declaration, and with `kind` those of this kind.
std::vector<const ParamInfo*> block_params(const std::string& keyword, const std::string& kind);

/// Whether the word is one of the parameter's choices.
bool has_choice(const ParamInfo& param, const std::string& word);

}  // namespace vug::language
