// SPDX-License-Identifier: Apache-2.0
// The text files of karst networks, as karstnet and Karst-Synthesis exchange them: NAME_nodes.dat
// has a line "x y z" for each station, in metres with z up, and NAME_links.dat a line "i j" for
// each leg, with stations counted from 1. Lines that start with # and empty lines are skipped.
#pragma once

#include <vug/network/network.h>
#include <vug/network/scene_origin.h>

#include <filesystem>
#include <string_view>

namespace vug::network {

/// Whether the name of the file ends in _nodes.dat or _links.dat.
bool is_dat_name(const std::filesystem::path& file);

/// Reads NAME_nodes.dat and NAME_links.dat, of which `file` is one. Throws Error(bad_input) with
/// the line of the fault.
Network read_dat(const std::filesystem::path& file, const OriginOptions& options = {});

/// Parses the two texts; the file names are for messages only.
struct DatText {
  std::string_view text;
  std::string file;
};
Network parse_dat(const DatText& nodes, const DatText& links, const OriginOptions& options = {});

/// The lines of the nodes and links in survey space; positions have the digits that reading needs
/// to return the same numbers.
std::string nodes_dat(const Network& network);
std::string links_dat(const Network& network);

/// Writes both files, of which `file` is one. Throws Error(bad_input) for another name, Error(io)
/// if a file cannot be written.
void write_dat(const Network& network, const std::filesystem::path& file);

}  // namespace vug::network
