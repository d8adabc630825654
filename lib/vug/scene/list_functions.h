// SPDX-License-Identifier: Apache-2.0
// Built-in functions on lists, and the limit of their size.
#pragma once

#include <vug/scene/functions.h>

#include <vector>

namespace vug::scene {

/// The number of elements of a value, including those of nested lists; 1 if it is not a list.
size_t element_count(const Value& value);

/// False, with an error, if a list of that many elements (see element_count) would be too long: a
/// chain of lists could double its size with each `let`.
bool may_have_elements(size_t count, const FaultSite& site);

/// min, max, len, at, concat, zip, sum.
std::vector<Function> list_functions();

}  // namespace vug::scene
