// Values of options as people write them, and what is said of those that are none.
#pragma once

#include "verb.h"

#include <vug/base/error.h>
#include <vug/base/value.h>

#include <string>
#include <vector>

namespace vug::cli {

/// A number from `low` to `high`, in base units; the text may carry a unit of the dimension, as in
/// scenes: 3% or 0.03, 90s or 90.
CLI::Validator number_in(Dimension dimension, double low, double high);
CLI::Validator integer_in(int low, int high);
/// From 0 to 2^64 - 1.
CLI::Validator seed_number();

/// The answer to a command without a verb (the word is empty) or with one that there is not.
/// `before` is what stands before the verb: "facade", or nothing.
Error unknown_verb_error(const std::string& word, const std::vector<std::string>& verbs,
                         const std::string& before = "");

/// Error(bad_input) unless the file's name is one with that ending (with its dot, in small
/// letters).
void require_extension(const std::string& file, const std::string& ending, const std::string& hint);

}  // namespace vug::cli
