// SPDX-License-Identifier: Apache-2.0
// The values of a variant as overrides, for recipes: a recipe then depends on no variant.
#pragma once

#include <vug/scene/document.h>
#include <vug/scene/evaluator.h>

#include <string>
#include <vector>

namespace vug::loading {

/// The parameters that the variant sets and `given` does not, with the texts of their values on one
/// line each; none for an unknown variant.
std::vector<scene::Override> variant_overrides(const scene::Document& document,
                                               const std::string& variant,
                                               const std::vector<scene::Override>& given);

}  // namespace vug::loading
