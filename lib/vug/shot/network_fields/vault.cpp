// SPDX-License-Identifier: Apache-2.0
// The vault of a chamber whose roof has fallen, bed by bed.
#include <vug/shot/networks.h>
#include <vug/shot/vault_params.h>

namespace vug::shot {
namespace {

struct VaultKind : VaultParams {
  static void describe(Schema<VaultKind>& s) {
    s.doc(
         "The air of a stepped vault above a chamber, to be subtracted from rock: the places of "
         "the blocks that fell because their bed was too thin for the span.")
        .cite("white1969breakdown");
    describe_vault(s);
  }
};

}  // namespace
}  // namespace vug::shot

VUG_NETWORK_FIELD_KIND(vault) {
  return field::field_kind<VaultKind>(
      "vault", "passage", [](const VaultKind& p) { return passages::vault_body(p.vault()); });
}
