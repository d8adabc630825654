// SPDX-License-Identifier: Apache-2.0
#include <vug/field/thickened.h>
#include <vug/field/translated.h>

#include <algorithm>

namespace vug::field {
namespace {

class ThickenedNode final : public EvaluationModes<ThickenedNode> {
 public:
  ThickenedNode(Traits traits, NodePtr rock, NodePtr thickness, double most)
      : EvaluationModes(std::move(traits)),
        rock_(std::move(rock)),
        thickness_(std::move(thickness)),
        most_(most) {}

  template <class T>
  T at(const Point<T>& p) const {
    if constexpr (std::is_same_v<T, Interval>)
      return rock_->eval(p) - intersection(thickness_->eval(p), Interval(0, most_));
    else
      return rock_->eval(p) - thickness_->eval(p);
  }
  template <class T>
  void fill(const Point<Pack>* points, int count, T* out, Scratch& scratch) const {
    Scratch::Frame frame(scratch);
    T* layer = frame.template take<T>(static_cast<size_t>(count));
    thickness_->eval(points, count, layer, scratch);
    rock_->eval(points, count, out, scratch);
    for (int i = 0; i < count; ++i) out[i] = out[i] - layer[i];
  }
  Restriction restrict_to(const Ball& ball) const override {
    const Restriction rock = rock_->restrict_to(ball);
    const Restriction layer = thickness_->restrict_to(ball);
    const NodePtr& base = rock.node ? rock.node : rock_;
    if (layer.range.hi <= 0) return {rock.range, base};
    Restriction out;
    out.range = rock.range - intersection(layer.range, Interval(0, most_));
    if (rock.node || layer.node)
      out.node = std::make_shared<ThickenedNode>(traits(), base,
                                                 layer.node ? layer.node : thickness_, most_);
    return out;
  }
  NodePtr translated(const Vec3d& by) const override {
    return std::make_shared<ThickenedNode>(traits().translated(by), field::translated(rock_, by),
                                           field::translated(thickness_, by), most_);
  }
  std::string name() const override { return "thickened"; }
  std::vector<NodePtr> children() const override { return {rock_, thickness_}; }

 protected:
  void add_to(Digester& digester) const override { digester(rock_, thickness_, most_); }

 private:
  NodePtr rock_, thickness_;
  double most_;
};

}  // namespace

Field thickened(const Field& rock, const Field& thickness, double most) {
  Traits traits = rock.node()->traits();
  traits.growth = traits.growth_rate();
  traits.lipschitz += thickness.lipschitz();
  traits.exactness = Exactness::sign;
  traits.bounds = rock.node()->traits().bounds_below(most);
  return Field(std::make_shared<ThickenedNode>(traits, rock.node(), thickness.node(), most));
}

}  // namespace vug::field
