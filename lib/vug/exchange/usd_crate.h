// SPDX-License-Identifier: Apache-2.0
// Writes USD's binary format (.usdc); see crate_format.h.
#pragma once

#include <vug/exchange/crate_tables.h>
#include <vug/exchange/usd_layer.h>
#include <vug/mesh/byte_writer.h>

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vug::exchange {

/// Writes values as they arrive, equal ones once, and keeps only the structure in memory: paths,
/// names and the offsets of values. The bytes depend only on the calls.
class UsdCrate : public UsdLayer {
 public:
  explicit UsdCrate(const mesh::ByteSink& sink);

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
  void finish() override;

  /// After `finish`: the first bytes of the file, for which the sink has received zeros.
  std::string file_header() const;

 private:
  using Tokens = std::vector<uint32_t>;
  struct Spec {
    uint32_t path = 0;
    CrateSpec type = CrateSpec::prim;
    uint32_t fields = 0;
  };
  /// A spec whose children are being written.
  struct Open {
    size_t spec = 0;
    uint32_t path = 0;
    std::string variant_set = {};  ///< If it is one.
    CrateFields::Set fields = {};
    Tokens prims = {}, properties = {}, variant_sets = {}, variants = {};
  };

  void write(std::string_view bytes);
  /// Writes zeros up to a multiple of 8 bytes, so that readers can map arrays.
  void align();
  void open(uint32_t path, CrateSpec type, CrateFields::Set fields);
  void add_metadata(const UsdPrimMetadata& metadata, CrateFields::Set& fields);
  void add_property(const std::string& name, CrateSpec type, const CrateFields::Set& fields);
  CrateFields::Set attribute_fields(const UsdAttribute& attribute, bool array);

  std::pair<uint32_t, CrateRep> field(const char* name, CrateRep value);
  CrateRep token(const std::string& text);
  CrateRep number(double value);
  /// A value that is written unless an equal one has been.
  CrateRep stored(CrateType type, const std::string& bytes);
  CrateRep token_vector(const Tokens& tokens);
  CrateRep path_list(const std::vector<std::string>& paths);
  CrateRep custom_layer_data(const Provenance& from);

  CrateRep value_of(const std::string& type, const UsdValue& value);
  CrateRep tuple(const std::string& type, const double* numbers, size_t count);
  CrateRep array(CrateType type, const void* data, size_t bytes, size_t count);
  CrateRep integers(const int32_t* numbers, size_t count);
  CrateRep numbers(const std::string& type, const UsdArray& array);

  void write_integers(const std::vector<int32_t>& numbers);
  void write_section(const char* name, const std::function<void()>& write);

  mesh::ByteWriter out_;
  uint64_t offset_ = 0;
  uint64_t contents_ = 0;  ///< Offset of the table of contents.
  std::string sections_;   ///< Entries of the table of contents.
  size_t section_count_ = 0;
  CrateTokens tokens_;
  CratePaths paths_{tokens_};
  CrateFields fields_;
  std::vector<Spec> specs_;
  std::vector<Open> open_;
  std::map<std::string, CrateRep> stored_;  ///< Values by type and bytes.
  std::map<std::string, CrateRep> arrays_;  ///< Arrays by type and digest.
};

}  // namespace vug::exchange
