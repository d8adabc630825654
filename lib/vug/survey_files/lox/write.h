// SPDX-License-Identifier: Apache-2.0
// Writer of Loch's .lox files.
#pragma once

#include <vug/survey/survey.h>

#include <string>

namespace vug::survey::lox {

/// The bytes of a .lox file. The parts of names between '.' become nested surveys. A shot gets the
/// cross-sections of the tube that contains both of its stations in succession, shots without one
/// none. Styles, dates, misclosures and exported stations are dropped. Throws Error(bad_input) for
/// coordinates that are not finite, for names that the reader refuses and for surveys that need
/// chunks of 4 GiB or more.
std::string write(const Survey& survey);

}  // namespace vug::survey::lox
