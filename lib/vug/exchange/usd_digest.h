// SPDX-License-Identifier: Apache-2.0
// Internal to exchange/: the digest of parts of a USD layer.
#pragma once

#include <vug/base/hash.h>
#include <vug/exchange/usd_layer.h>

#include <string>

namespace vug::exchange {

/// Writes nothing. Equal parts have equal digests, and different parts have different ones.
class UsdDigest : public UsdLayer {
 public:
  using UsdLayer::begin_prim;
  using UsdLayer::begin_variant;
  void header(const UsdHeader& header) override;
  void begin_prim(const std::string& type, const std::string& name,
                  const UsdPrimMetadata& metadata) override;
  void begin_variant_set(const std::string& name) override;
  void begin_variant(const std::string& name, const UsdPrimMetadata& metadata) override;
  void end() override;
  void attribute(const UsdAttribute& attribute, const UsdValue& value) override;
  void connection(const UsdAttribute& attribute, const std::string& source) override;
  void relationship(const std::string& name, const std::string& target) override;
  void relationships(const std::string& name, const std::vector<std::string>& targets) override;
  void finish() override {}

  /// The digest of everything since the last call.
  Digest take();

 private:
  void add(const std::string& text);
  void add(const UsdAttribute& attribute);
  void add(const UsdPrimMetadata& metadata);

  Hasher hasher_;
};

}  // namespace vug::exchange
