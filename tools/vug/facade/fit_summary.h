// SPDX-License-Identifier: Apache-2.0
// The printed result of `vug facade fit`.
#pragma once

#include <vug/session/facade_fit.h>

#include <filesystem>
#include <string>
#include <vector>

namespace vug::cli {

/// An output file and its content, for example "scene".
struct NamedFile {
  std::string content;
  std::filesystem::path file;
};

/// The size and the elements of the facade, the agreement of the chains, and the files that exist,
/// in a few lines. `assumed_size` marks a size that was not measured.
std::string fit_summary(const session::FacadeFit& fit, bool assumed_size,
                        const std::vector<NamedFile>& files);

}  // namespace vug::cli
