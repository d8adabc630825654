// SPDX-License-Identifier: Apache-2.0
#include <vug/sgm/named_places.h>

#include <vug/field/material_source.h>
#include <vug/field/translated.h>

namespace vug::sgm {
namespace {

/// Evaluates as its child, into which it is pruned.
class PlacesNode : public field::EvaluationModes<PlacesNode>, public field::MaterialSource {
 public:
  PlacesNode(field::NodePtr child, std::vector<NamedPlace> named)
      : EvaluationModes(child->traits()), places(std::move(named)), child_(std::move(child)) {}

  template <class T>
  T at(const field::Point<T>& p) const {
    return child_->eval(p);
  }
  template <class T>
  void fill(const field::Point<field::Pack>* points, int count, T* out,
            field::Scratch& scratch) const {
    child_->eval(points, count, out, scratch);
  }
  field::Restriction restrict_to(const field::Ball& ball) const override {
    field::Restriction restriction = child_->restrict_to(ball);
    if (!restriction.node) restriction.node = child_;
    return restriction;
  }
  field::NodePtr translated(const Vec3d& by) const override {
    return field::translated(child_, by);
  }
  std::string name() const override { return child_->name(); }
  std::vector<field::NodePtr> children() const override { return child_->children(); }

  field::MaterialSample sample_materials(const Vec3d& p) const override {
    return field::sample_materials(*child_, p);
  }
  field::Coat coat(const Vec3d& p) const override { return field::coat_at(*child_, p); }
  std::optional<field::Field> material_mean(const field::MaterialNumber& number) const override {
    return field::material_mean(field::Field(child_), number);
  }
  std::vector<field::NodePtr> material_operands() const override { return {child_}; }

  const std::vector<NamedPlace> places;

 protected:
  void add_to(Digester& digester) const override { digester(child_); }

 private:
  field::NodePtr child_;
};

}  // namespace

field::Field with_places(const field::Field& field, std::vector<NamedPlace> places) {
  return field::Field(std::make_shared<PlacesNode>(field.node(), std::move(places)));
}

const std::vector<NamedPlace>& places_of(const field::Field& field) {
  static const std::vector<NamedPlace> none;
  const auto* node = dynamic_cast<const PlacesNode*>(field.node().get());
  return node ? node->places : none;
}

}  // namespace vug::sgm
