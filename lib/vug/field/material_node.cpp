// SPDX-License-Identifier: Apache-2.0
#include <vug/field/material_node.h>
#include <vug/field/translated.h>

#include <utility>

namespace vug::field {
namespace {

/// Evaluates as its child, into which it is pruned and translated: materials are evaluated on whole
/// expressions.
class MaterialNode final : public EvaluationModes<MaterialNode>,
                           public MaterialSource,
                           public NearMaterials {
 public:
  MaterialNode(std::string name, NodePtr child, std::shared_ptr<const MaterialRule> rule)
      : EvaluationModes(child->traits()),
        name_(std::move(name)),
        child_(std::move(child)),
        rule_(std::move(rule)) {}

  template <class T>
  T at(const Point<T>& p) const {
    return child_->eval(p);
  }
  template <class T>
  void fill(const Point<Pack>* points, int count, T* out, Scratch& scratch) const {
    child_->eval(points, count, out, scratch);
  }
  Restriction restrict_to(const Ball& ball) const override {
    Restriction restriction = child_->restrict_to(ball);
    if (!restriction.node) restriction.node = child_;
    return restriction;
  }
  NodePtr translated(const Vec3d& by) const override { return field::translated(child_, by); }
  std::string name() const override { return name_; }
  std::vector<NodePtr> children() const override { return {child_}; }

  MaterialSample sample_materials(const Vec3d& p) const override {
    return rule_->sample(*child_, p);
  }
  NearMixes mixes_near(const NearPoints& points) const override {
    return rule_->mixes_near(*child_, points);
  }
  Coat coat(const Vec3d& p) const override { return rule_->coat(*child_, p); }
  std::optional<Field> material_mean(const MaterialNumber& number) const override {
    return rule_->mean(Field(child_), number);
  }
  std::vector<RockMaterialPtr> assigned() const override { return rule_->assigned(); }
  std::vector<NodePtr> material_operands() const override {
    std::vector<NodePtr> out = rule_->bodies();
    if (rule_->keeps_child()) out.push_back(child_);
    return out;
  }

 protected:
  void add_to(Digester& digester) const override { digester(name_, child_, rule_); }

 private:
  std::string name_;
  NodePtr child_;
  std::shared_ptr<const MaterialRule> rule_;
};

}  // namespace

Field with_materials(std::string name, const Field& field,
                     std::shared_ptr<const MaterialRule> rule) {
  return Field(std::make_shared<MaterialNode>(std::move(name), field.node(), std::move(rule)));
}

}  // namespace vug::field
