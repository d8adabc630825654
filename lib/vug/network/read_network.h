// SPDX-License-Identifier: Apache-2.0
// Networks from files of any format: surveys, and the text files of karst networks.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/network/network.h>

#include <filesystem>

namespace vug::network {

/// Whether the extension, in any case, is one of a survey or of the files of dat.h.
bool is_network_file(const std::filesystem::path& file);

/// The network in NAME_nodes.dat, NAME_links.dat or a survey, about the origin and without legs
/// over the surface. Throws Error(bad_input) for other extensions and with the place of a fault;
/// adds the warnings of a survey.
Network read_network(const std::filesystem::path& file, Diagnostics& warnings);

}  // namespace vug::network
