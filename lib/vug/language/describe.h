// SPDX-License-Identifier: Apache-2.0
// Descriptions of kinds, parameters and symbols as Markdown.
#pragma once

#include <vug/language/expectation.h>

namespace vug::language {

/// "sphere(center: vector, radius: number) -> light", with brackets around optional parameters.
std::string signature_text(const CallMeaning& meaning);
/// The signature, the description, and the source of a kind.
std::string describe(const CallMeaning& meaning);
/// The type, the range, the default and the description of a parameter.
std::string describe(const ParamInfo& param);
/// The declaration of a symbol with its description: that of the text, or the comment above it.
std::string describe(const Symbol& symbol, const scene::Document& document);
std::string describe(const LanguageWord& word);
/// A declaration or a kind of grammar.
std::string describe(const KindInfo& declaration);

/// A block of scene text.
std::string code_block(const std::string& text);

}  // namespace vug::language
