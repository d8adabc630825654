// SPDX-License-Identifier: Apache-2.0
// Built-in functions on lists, and the limit of their size.
#pragma once

#include <vug/scene/functions.h>

#include <vector>

namespace vug::scene {

/// False, with an error, if a list of that many elements (see Value::element_count) would be too
/// long: a chain of lists could double its size with each `let`.
bool may_have_elements(size_t count, const FaultSite& site);

/// min, max, len, at, concat, zip, sum.
std::vector<Function> list_functions();

}  // namespace vug::scene
