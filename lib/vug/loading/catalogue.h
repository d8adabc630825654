// Everything a scene can say, as data: for `vug list`, the manual and tests.
#pragma once

#include <vug/base/schema.h>

#include <nlohmann/json_fwd.hpp>

namespace vug::loading {

/// Kinds of all families and declarations, by category, in the order of their lists.
/// With a word: the kinds of that name, of that category and of the family that the word declares:
/// "material" finds the declaration and all that can stand there.
std::vector<const KindInfo*> find_kinds(const std::string& word = {});
/// Names, categories and families, for suggestions.
std::vector<std::string> kind_words();

/// "number (angle), above 0, at most 170deg, default 60deg": type, range and default of a
/// parameter.
std::string describe(const ParamInfo& param);

/// Bounds are numbers in the parameter's `unit`; defaults are scene text.
nlohmann::ordered_json catalogue_json(const std::vector<const KindInfo*>& kinds);

}  // namespace vug::loading
