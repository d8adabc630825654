// SPDX-License-Identifier: Apache-2.0
#include <vug/field/deferred.h>

#include <tbb/task_arena.h>

#include <mutex>
#include <utility>

namespace vug::field {
namespace {

class DeferredNode final : public Node {
 public:
  DeferredNode(Traits traits, std::function<Field()> make)
      : Node(std::move(traits)), make_(std::move(make)) {}

  double eval(const Point<double>& p) const override { return made().eval(p); }
  Dual<double> eval(const Point<Dual<double>>& p) const override { return made().eval(p); }
  Interval eval(const Point<Interval>& p) const override { return made().eval(p); }
  void eval(const Point<Pack>* points, int count, Pack* out, Scratch& scratch) const override {
    made().eval(points, count, out, scratch);
  }
  void eval(const Point<Pack>* points, int count, Dual<Pack>* out,
            Scratch& scratch) const override {
    made().eval(points, count, out, scratch);
  }
  Restriction restrict_to(const Ball& ball) const override { return made().restrict_to(ball); }
  std::string name() const override { return made().name(); }
  std::vector<NodePtr> children() const override { return made().children(); }

 private:
  const Node& made() const {
    std::call_once(once_, [&] {
      // Isolated: a thread that waits for its own loop must not start a task of an outer loop that
      // evaluates this field, because it would wait for itself.
      tbb::this_task_arena::isolate([&] { field_ = make_(); });
    });
    return *field_.node();
  }

  std::function<Field()> make_;
  mutable std::once_flag once_;
  mutable Field field_;
};

}  // namespace

Field deferred(Traits traits, std::function<Field()> make) {
  return Field(std::make_shared<DeferredNode>(std::move(traits), std::move(make)));
}

}  // namespace vug::field
