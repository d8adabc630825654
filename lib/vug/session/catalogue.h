// Everything a scene can say, as data: for `vug list`, the manual and tests.
#pragma once

#include <vug/base/schema.h>

#include <nlohmann/json_fwd.hpp>

namespace vug::session {

/// Kinds of all families and declarations, by category, in the order of their lists.
/// With a word: the kinds of that name and those of that category.
std::vector<const KindInfo*> find_kinds(const std::string& word = {});
/// Names and categories, for suggestions.
std::vector<std::string> kind_words();

/// "length above 0, default 1m": type, range and default of a parameter.
std::string describe(const ParamInfo& param);

nlohmann::ordered_json catalogue_json(const std::vector<const KindInfo*>& kinds);

}  // namespace vug::session
