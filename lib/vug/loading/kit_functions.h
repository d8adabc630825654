// SPDX-License-Identifier: Apache-2.0
// The functions that the files of data/kit declare.
#pragma once

#include <string>

namespace vug::loading {

/// The include that declares a function, as "kit/lamps.vug"; empty if no file of the kit in
/// data_folders() does. Files with errors are skipped.
std::string kit_file_of(const std::string& function);

}  // namespace vug::loading
