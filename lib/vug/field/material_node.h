// SPDX-License-Identifier: Apache-2.0
// A field with the values of another one and with materials of its own.
#pragma once

#include <vug/field/material_source.h>
#include <vug/field/near_materials.h>

#include <memory>
#include <string>
#include <vector>

namespace vug::field {

/// The rule by which such a field has its materials.
class MaterialRule {
 public:
  virtual ~MaterialRule() = default;
  virtual MaterialSample sample(const Node& child, const Vec3d& p) const = 0;
  /// The mixes of `sample`; unknown by default.
  virtual NearMixes mixes_near(const Node&, const NearPoints& points) const {
    return {points.size(), {}, false};
  }
  virtual Coat coat(const Node& child, const Vec3d& p) const { return coat_at(child, p); }
  virtual std::optional<Field> mean(const Field& child, const MaterialNumber& number) const {
    return material_mean(child, number);
  }
  virtual std::vector<RockMaterialPtr> assigned() const = 0;
  /// The fields besides the child from which it takes materials.
  virtual std::vector<NodePtr> bodies() const { return {}; }
  /// Whether materials of the child remain.
  virtual bool keeps_child() const { return false; }
  /// Adds all parameters to the digest of the node.
  virtual void add_to(Digester& digester) const = 0;
};

/// `name`: of the kind, for people.
Field with_materials(std::string name, const Field& field,
                     std::shared_ptr<const MaterialRule> rule);

}  // namespace vug::field
