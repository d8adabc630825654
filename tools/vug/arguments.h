// SPDX-License-Identifier: Apache-2.0
// Validators for option values, and the error for unknown verbs.
#pragma once

#include "verb.h"

#include <vug/base/error.h>
#include <vug/base/schema.h>
#include <vug/base/value.h>

#include <string>
#include <vector>

namespace vug::cli {

/// Validator for a number from `low` to `high`, in base units. The text may carry a unit of the
/// dimension as in scenes: 3% or 0.03, 90s or 90.
CLI::Validator number_in(Dimension dimension, double low, double high);
/// Validator for a parameter that is a number, as above, or one of the names in its `choices`.
CLI::Validator number_or_name(const ParamInfo& info);
/// Validator for an integer from `low` to `high`.
CLI::Validator integer_in(int low, int high);
/// Validator for an integer from 0 to 2^64 - 1.
CLI::Validator seed_number();

/// The numbers of a text of the form `pattern`, in which each 'N' stands for a non-negative
/// integer. Error(bad_input) with `what` and `hint` for other texts.
std::vector<int> parse_numbers(const std::string& text, const std::string& pattern,
                               const std::string& what, const std::string& hint);

/// Left, top, right and bottom of a crop window that contains pixels. Error(bad_input).
std::vector<int> parse_crop(const std::string& text);

/// The error for a command line with a missing verb (`word` is empty) or an unknown one. `before`
/// is the parent command, "facade", or empty.
Error unknown_verb_error(const std::string& word, const std::vector<std::string>& verbs,
                         const std::string& before = "");

/// Validator for one of the words, which its message lists.
CLI::Validator one_of(const std::vector<std::string>& words);

/// Error(bad_input), with the verbs that read scenes, if the file is a scene.
void require_no_scene(const std::string& file);

/// Error(bad_input) unless the file name has a stem and this extension (lower case, with its dot).
void require_extension(const std::string& file, const std::string& ending, const std::string& hint);

}  // namespace vug::cli
