// SPDX-License-Identifier: Apache-2.0
// Words of a command line: separated by spaces, with quotes around words that contain spaces.
#pragma once

#include <string>
#include <vector>

namespace vug::workbench {

/// Splits a line. Inside of quotes, \", \\ and \n are a quote, a backslash and the end of a line; #
/// outside of quotes, at the start of a word, begins a comment. Error(bad_input) for a quote that
/// is never closed.
std::vector<std::string> split_words(const std::string& line);

/// The word with quotes if it needs them; the inverse of split_words.
std::string quoted(const std::string& word);

/// A length in metres: "3.4m", "90cm", "3.4". Error(bad_input) for anything else.
double parse_length(const std::string& word);
/// A finite number. Error(bad_input) for anything else.
double parse_number(const std::string& word);

}  // namespace vug::workbench
