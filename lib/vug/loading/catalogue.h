// SPDX-License-Identifier: Apache-2.0
// The catalogue of all kinds and their parameters as data, for `vug list`, the manual and tests.
#pragma once

#include <vug/base/schema.h>

#include <nlohmann/json_fwd.hpp>

namespace vug::loading {

/// The kinds of all registries and declarations, by category, in the order of their lists. With a
/// word: the kinds of that name, of that category and of the registry of that type: "material"
/// finds the declaration and all materials.
std::vector<const KindInfo*> find_kinds(const std::string& word = {});
/// The kinds whose names, categories, descriptions, synonyms or parameters contain all words of the
/// text, regardless of case; those whose names or synonyms contain them come first.
std::vector<const KindInfo*> search_kinds(const std::string& text);
/// Names, categories and product types, for suggestions.
std::vector<std::string> kind_words();

/// Type, range and default of a parameter, such as "number (angle), above 0, at most 170deg,
/// default 60deg".
std::string describe(const ParamInfo& param);

/// The kinds as JSON, with examples. Bounds are numbers in the parameter's `unit`; defaults are
/// scene text.
nlohmann::ordered_json catalogue_json(const std::vector<const KindInfo*>& kinds);

}  // namespace vug::loading
