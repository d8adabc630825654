// SPDX-License-Identifier: Apache-2.0
// The interface of the writers of USD layers, which receive prims,
// properties and typed values one after the other. The terms are those of OpenUSD's Sdf.
#pragma once

#include <vug/base/transform.h>
#include <vug/exchange/assembly.h>

#include <array>
#include <initializer_list>
#include <string>
#include <variant>
#include <vector>

namespace vug::exchange {

struct UsdToken {
  std::string text;
};
struct UsdString {
  std::string text;
};
/// A path to another file.
struct UsdAsset {
  std::string path;
};
using UsdTokens = std::vector<std::string>;
/// One tuple of numbers.
using UsdTuple = std::vector<double>;
/// A short array of points or colours.
using UsdTuples = std::vector<Vec3d>;
/// Row-major, for row vectors.
using UsdMatrix = std::array<double, 16>;
/// `count` tuples of `arity` numbers, which are not copied. The numbers of a quaternion begin with
/// its real part.
struct UsdArray {
  std::variant<const int32_t*, const uint32_t*, const float*> numbers;
  size_t count = 0;
  int arity = 1;
};
/// The value of an attribute; none: the attribute is only declared. Writers convert numbers to the
/// attribute's type.
using UsdValue = std::variant<std::monostate, bool, int, double, UsdToken, UsdString, UsdAsset,
                              UsdTokens, UsdTuple, UsdTuples, UsdMatrix, UsdArray>;

/// The type of an attribute, for arrays that of the elements, and its name and metadata.
struct UsdAttribute {
  std::string type;
  std::string name;
  bool uniform = false;  ///< Never animated.
  bool custom = false;   ///< Not defined by a schema.
  std::string interpolation = {};
  int element_size = 0;  ///< Numbers per vertex; 0: the default.
};

/// Metadata of a prim or a variant, in the order of writing.
struct UsdPrimMetadatum {
  enum class Field { kind, api_schema, variant_set, variant_selection, payload, reference };
  Field field = Field::kind;
  std::string value;
  std::string variant_set = {};  ///< That of a variant selection.
};
using UsdPrimMetadata = std::vector<UsdPrimMetadatum>;

inline UsdPrimMetadatum usd_kind(std::string kind) {
  return {UsdPrimMetadatum::Field::kind, std::move(kind)};
}
inline UsdPrimMetadatum usd_api_schema(std::string schema) {
  return {UsdPrimMetadatum::Field::api_schema, std::move(schema)};
}
inline UsdPrimMetadatum usd_variant_set(std::string set) {
  return {UsdPrimMetadatum::Field::variant_set, std::move(set)};
}
inline UsdPrimMetadatum usd_variant_selection(std::string set, std::string variant) {
  return {UsdPrimMetadatum::Field::variant_selection, std::move(variant), std::move(set)};
}
/// `file`: a layer.
inline UsdPrimMetadatum usd_payload(std::string file) {
  return {UsdPrimMetadatum::Field::payload, std::move(file)};
}
/// `prim`: the path of a prim of the same layer.
inline UsdPrimMetadatum usd_reference(std::string prim) {
  return {UsdPrimMetadatum::Field::reference, std::move(prim)};
}

/// Metadata of a layer: its provenance, its default prim and its space.
struct UsdHeader {
  std::string default_prim;
  Provenance provenance;
  Space space;
};

/// Receives the specs of a layer. Prims, variant sets and variants are nested: each `begin` needs
/// an `end`. A variant set is in a prim and contains only variants.
class UsdLayer {
 public:
  UsdLayer() = default;
  UsdLayer(const UsdLayer&) = delete;
  UsdLayer& operator=(const UsdLayer&) = delete;
  virtual ~UsdLayer() = default;

  /// Must be called first.
  virtual void header(const UsdHeader& header) = 0;
  virtual void begin_prim(const std::string& type, const std::string& name,
                          const UsdPrimMetadata& metadata) = 0;
  virtual void begin_variant_set(const std::string& name) = 0;
  virtual void begin_variant(const std::string& name, const UsdPrimMetadata& metadata) = 0;
  virtual void end() = 0;

  /// A value refers to its numbers only during the call.
  virtual void attribute(const UsdAttribute& attribute, const UsdValue& value) = 0;
  /// `source`: the path of an attribute of another prim.
  virtual void connection(const UsdAttribute& attribute, const std::string& source) = 0;
  /// A relationship with one target.
  virtual void relationship(const std::string& name, const std::string& target) = 0;
  /// A relationship that may have several targets.
  virtual void relationships(const std::string& name, const std::vector<std::string>& targets) = 0;
  /// Must be called last.
  virtual void finish() = 0;

  void begin_prim(const std::string& type, const std::string& name) { begin_prim(type, name, {}); }
  void begin_variant(const std::string& name) { begin_variant(name, {}); }
  /// Writes the transform of a prim; nothing for the identity.
  void transform(const Transform& place);
};

/// A box without content has corners of this and of the negative size, as in UsdGeom. It becomes
/// the largest float.
inline constexpr double kUsdEmptyExtent = 3.4028235e38;

}  // namespace vug::exchange
