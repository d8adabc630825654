// SPDX-License-Identifier: Apache-2.0
// Small files for tests of kinds with a `file` parameter, created on first use.
#pragma once

#include <string>

namespace vug::field {

/// A folder for the files of this test process; removed at exit.
const std::string& fixture_folder();

/// The path of a file for the kind of this name; empty if the kind needs no file.
std::string fixture_file(const std::string& kind);

}  // namespace vug::field
