// SPDX-License-Identifier: Apache-2.0
#include <vug/shot/vault_params.h>

namespace vug::shot {

passages::Vault VaultParams::vault() const {
  passages::VaultOptions options;
  options.at = at;
  options.span = span;
  options.length = length > 0 ? length : span;
  options.bed = bed;
  options.spacing = spacing;
  options.strength = strength;
  options.azimuth = azimuth;
  options.bedding = bedding;
  options.seed = static_cast<uint64_t>(seed);
  options.rock = rock;
  return passages::vault(options);
}

}  // namespace vug::shot
