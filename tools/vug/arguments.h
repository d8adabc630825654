// Values of options as people write them, and what is said of those that are none.
#pragma once

#include "verb.h"

#include <vug/base/value.h>

#include <string>

namespace vug::cli {

/// A number from `low` to `high`, in base units; the text may carry a unit of the dimension, as in
/// scenes: 3% or 0.03, 90s or 90.
CLI::Validator number_in(Dimension dimension, double low, double high);
CLI::Validator whole_number_in(int low, int high);
/// From 0 to 2^64 - 1.
CLI::Validator seed_number();

/// Error(bad_input) unless the file's name is one with that ending (with its dot, in small
/// letters).
void require_ending(const std::string& file, const std::string& ending, const std::string& hint);

}  // namespace vug::cli
