// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/usd_header.h>

namespace vug::exchange {

void write_usd_header(UsdText& out, const std::string& default_prim, const Provenance& from,
                      const Space& space) {
  out.line("#usda 1.0").line("(").line("    customLayerData = {{");
  out.line("        string \"vug:recipe\" = {}", usd_string(from.recipe));
  out.line("        string \"vug:seed\" = \"{}\"", from.seed);
  out.line("        double \"vug:frame\" = {}", from.frame);
  out.line("        string \"vug:version\" = {}", usd_string(from.version));
  out.line("    }}").line("    defaultPrim = \"{}\"", default_prim);
  out.line("    metersPerUnit = {}", space.metres_per_unit);
  out.line("    upAxis = \"{}\"", space.up == UpAxis::y ? "Y" : "Z").line(")");
}

}  // namespace vug::exchange
