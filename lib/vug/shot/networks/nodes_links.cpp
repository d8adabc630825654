// SPDX-License-Identifier: Apache-2.0
// A network from the text files of karst research.
#include <vug/network/dat.h>
#include <vug/shot/networks.h>
#include <vug/shot/networks/origin_parameters.h>

namespace vug::shot {
namespace {

struct DatFile : network::OriginOptions {
  std::filesystem::path file;

  static void describe(Schema<DatFile>& s) {
    s.doc(
         "The network in two text files as karstnet and Karst-Synthesis write them: NAME_nodes.dat "
         "with a position in each line, z up, and NAME_links.dat with two numbers of nodes.")
        .param("file", &DatFile::file, {.doc = "one of the two files", .required = true});
    describe_origin(s);
  }
};

}  // namespace
}  // namespace vug::shot

VUG_NETWORK_KIND(nodes_links) {
  return make_kind<NetworkPtr, DatFile>(
      "nodes_links", "network", [](const DatFile& p) -> NetworkPtr {
        return std::make_shared<const network::Network>(network::read_dat(p.file, p));
      });
}
