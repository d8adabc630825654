// SPDX-License-Identifier: Apache-2.0
#include <vug/base/memory.h>
#include <vug/field/deferred.h>
#include <vug/field/evaluates_below.h>
#include <vug/field/material_source.h>
#include <vug/field/near_materials.h>
#include <vug/field/translated.h>
#include <vug/field/value_below.h>

#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <unordered_set>
#include <utility>
#include <vector>

namespace vug::field {
namespace {

class DeferredNode final : public Node,
                           public MaterialSource,
                           public NearMaterials,
                           public EvaluatesBelow,
                           public ValueBelow {
 public:
  DeferredNode(Traits traits, DeferredWork work, Digest inputs, std::function<Field()> make)
      : Node(std::move(traits)), work_(std::move(work)), inputs_(inputs), make_(std::move(make)) {}

  const DeferredWork& work() const { return work_; }
  bool is_computed() const { return ready_; }
  void compute() const { made(); }

  double eval(const Point<double>& p) const override { return made().eval(p); }
  Dual<double> eval(const Point<Dual<double>>& p) const override { return made().eval(p); }
  Interval eval(const Point<Interval>& p) const override {
    constexpr double kWidest = 1e6;  // As the value of the empty field.
    const Box3d& box = traits().bounds;
    if (box.isEmpty()) return kWidest;
    double squared = 0;
    const Interval* axes[] = {&p.x, &p.y, &p.z};
    for (int axis = 0; axis < 3; ++axis) {
      const double away =
          std::max({box.min[axis] - axes[axis]->hi, axes[axis]->lo - box.max[axis], 0.0});
      squared += away * away;
    }
    return {squared > 0 ? traits().growth_rate() * std::sqrt(squared) : -kWidest, kWidest};
  }
  void eval(const Point<Pack>* points, int count, Pack* out, Scratch& scratch) const override {
    made().eval(points, count, out, scratch);
  }
  void eval(const Point<Pack>* points, int count, Dual<Pack>* out,
            Scratch& scratch) const override {
    made().eval(points, count, out, scratch);
  }
  Restriction restrict_to(const Ball& ball) const override { return made().restrict_to(ball); }
  void eval_below(const Point<Pack>* points, const Pack* limits, int count, Pack* out,
                  Scratch& scratch) const override {
    evaluate_below(made(), points, limits, count, out, scratch);
  }
  void eval_below(const Point<Pack>* points, const Pack* limits, int count, Dual<Pack>* out,
                  Scratch& scratch) const override {
    evaluate_below(made(), points, limits, count, out, scratch);
  }
  Restriction restrict_below(const Ball& ball, double limit) const override {
    return field::restrict_below(made(), ball, limit);
  }
  double value_below(const Point<double>& p, double limit) const override {
    return field::value_below(made(), p, limit);
  }
  NodePtr translated(const Vec3d& by) const override {
    made();
    return field::translated(field_.node(), by);
  }
  std::string name() const override { return ready_ ? made().name() : "deferred"; }
  std::vector<NodePtr> children() const override {
    return ready_ ? made().children() : std::vector<NodePtr>();
  }
  MaterialSample sample_materials(const Vec3d& p) const override {
    return field::sample_materials(made(), p);
  }
  NearMixes mixes_near(const NearPoints& points) const override {
    return field::mixes_near(made(), points);
  }
  Coat coat(const Vec3d& p) const override { return coat_at(made(), p); }
  std::optional<Field> material_mean(const MaterialNumber& number) const override {
    made();
    return field::material_mean(field_, number);
  }
  std::vector<NodePtr> material_operands() const override {
    return ready_ ? std::vector<NodePtr>{field_.node()} : std::vector<NodePtr>();
  }

 protected:
  void add_to(Digester& digester) const override { digester(work_.stage, inputs_); }

 private:
  const Node& made() const {
    if (!ready_) {
      // Not std::call_once: after an exception, that of glibc never returns under ThreadSanitizer.
      const std::lock_guard lock(computing_);
      // Isolated: a thread that waits for its own loop must not start a task of an outer loop that
      // evaluates this field, because it would wait for itself.
      if (!ready_) tbb::this_task_arena::isolate([&] { field_ = make_(); });
      ready_ = true;
    }
    return *field_.node();
  }

  DeferredWork work_;
  Digest inputs_;
  std::function<Field()> make_;
  mutable std::mutex computing_;
  mutable std::atomic<bool> ready_ = false;
  mutable Field field_;
};

}  // namespace

Field detail::deferred(Traits traits, DeferredWork work, Digest inputs,
                       std::function<Field()> make) {
  return Field(
      std::make_shared<DeferredNode>(std::move(traits), std::move(work), inputs, std::move(make)));
}

void compute_deferred(const Field& whole, Progress& progress, uint64_t memory) {
  std::vector<NodePtr> pending{whole.node()};
  std::unordered_set<const Node*> seen;
  while (!pending.empty()) {
    const NodePtr node = std::move(pending.back());
    pending.pop_back();
    if (!seen.insert(node.get()).second) continue;
    const auto* deferred = dynamic_cast<const DeferredNode*>(node.get());
    if (deferred && !deferred->is_computed()) {
      require_memory(deferred->work().bytes, memory, deferred->work().stage,
                     "use a larger spacing, a smaller box");
      run_stage(progress, deferred->work().stage, [&] { deferred->compute(); });
    }
    for (NodePtr& child : node->children()) pending.push_back(std::move(child));
  }
}

}  // namespace vug::field
