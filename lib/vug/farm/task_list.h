// SPDX-License-Identifier: Apache-2.0
// Lists of task numbers as texts, in the form that Slurm and OpenJD use.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace vug::farm {

/// The numbers of "3", "0-7", "0-20:5" or several of them separated by commas, each once and in the
/// order of the text. Error(bad_input) for other texts, and for more than a million numbers.
std::vector<size_t> parse_tasks(const std::string& text);

}  // namespace vug::farm
