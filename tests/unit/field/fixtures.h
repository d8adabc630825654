// Small files that kinds with a `file` parameter are tested with, made when first asked for.
#pragma once

#include <string>

namespace vug::field {

/// A folder for the files of this process' tests; gone when it ends.
const std::string& fixture_folder();

/// The path of a file for the kind of that name; empty when there is none.
std::string fixture_file(const std::string& kind);

}  // namespace vug::field
