// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/lsystem/turtle_interpreter.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::lsystem {

namespace {

constexpr double kLargestNode = 100;

void require_valid(const TurtleOptions& options) {
  const Vec3d& t = options.tropism;
  for (const double value : {options.angle, options.step, options.width, options.thinner, t.x, t.y,
                             t.z, options.elasticity, options.smooth})
    if (!std::isfinite(value))
      throw Error(ErrorCode::bad_input, "an option of the turtle is not a finite number");
  if (!(options.width >= 0 && options.width <= TurtleInterpreter::kFarthest))
    throw Error(ErrorCode::bad_input, fmt::format("the turtle's width is {} m; it must be 0 to {}",
                                                  options.width, TurtleInterpreter::kFarthest));
  if (!(options.thinner >= 0 && options.smooth > 0))
    throw Error(ErrorCode::bad_input,
                "the turtle's 'thinner' must be at least 0 and 'smooth' above 0");
}

}  // namespace

TurtleInterpreter::TurtleInterpreter(const Word& word, const Alphabet& alphabet,
                                     const TurtleOptions& options, DrawingBuilder* builder)
    : word_(word),
      alphabet_(alphabet),
      options_(options),
      builder_(builder),
      symbol_actions_(symbol_actions(alphabet, options)) {
  require_valid(options);
  for (const Bezier& guide : options.guides) guides_.emplace_back(guide);
  state_.radius = 0.5 * options.width;
  state_.elasticity = options.elasticity;
}

void TurtleInterpreter::walk(const std::vector<SymbolId>& symbols, const PoseVisitor& visit) {
  std::vector<bool> requested(alphabet_.size());
  for (const SymbolId id : symbols) requested[id] = true;
  for (at_ = 0; at_ < word_.size(); ++at_) {
    const SymbolId id = word_.symbol(at_);
    if (requested[id]) visit(at_, state_.pose);
    if (symbol_actions_[id].type != TurtleAction::nothing)
      execute(symbol_actions_[id], word_.parameters(at_));
  }
  if (!stack_.empty()) fail("a '[' is not closed");
  if (braces_ > 0) fail("a '{' is not closed");
}

void TurtleInterpreter::fail(const std::string& what) const {
  const size_t at = std::min(at_, word_.size() - 1);
  throw Error(ErrorCode::bad_input, fmt::format("{}, at '{}', module {} of the word", what,
                                                to_string(word_, alphabet_, at, at + 1), at + 1));
}

void TurtleInterpreter::execute(const SymbolAction& action, Parameters p) {
  for (const double value : p)
    if (!std::isfinite(value)) fail("a parameter is not a finite number");
  const Frame& frame = state_.pose.frame;
  const double angle = p.empty() ? options_.angle : p[0];
  switch (action.type) {
    case TurtleAction::draw:
      forward(p, braces_ == 0);
      if (braces_ > 0 && builder_) builder_->corner(state_);
      break;
    case TurtleAction::trace:
      forward(p, true);
      break;
    case TurtleAction::move:
      forward(p, false);
      state_.axis = Axis::kNone;
      if (braces_ > 0 && builder_) builder_->corner(state_);
      break;
    case TurtleAction::left:
      rotate(frame.binormal, angle);
      break;
    case TurtleAction::right:
      rotate(frame.binormal, -angle);
      break;
    case TurtleAction::down:
      rotate(frame.normal, angle);
      break;
    case TurtleAction::up:
      rotate(frame.normal, -angle);
      break;
    case TurtleAction::roll_left:
      rotate(frame.tangent, -angle);
      break;
    case TurtleAction::roll_right:
      rotate(frame.tangent, angle);
      break;
    case TurtleAction::back:
      state_.pose.frame = {-frame.tangent, -frame.normal, frame.binormal};
      break;
    case TurtleAction::level:
      level();
      break;
    case TurtleAction::width:
      if (!p.empty() && p[0] < 0) fail("negative width");
      set_radius(p.empty() ? state_.radius * options_.thinner : 0.5 * p[0]);
      break;
    case TurtleAction::colour:
      state_.colour = p.empty() ? state_.colour + 1 : static_cast<int>(std::clamp(p[0], -1e9, 1e9));
      break;
    case TurtleAction::push:
      push();
      break;
    case TurtleAction::pop:
      pop();
      break;
    case TurtleAction::open:
    case TurtleAction::corner:
    case TurtleAction::close:
      brace(action.type);
      break;
    case TurtleAction::node:
      if (!p.empty() && !(p[0] >= 0 && p[0] <= kLargestNode))
        fail(fmt::format("a node's size must be 0 to {}", kLargestNode));
      if (builder_) builder_->node(state_, p.empty() ? 1 : p[0]);
      break;
    case TurtleAction::age:
      state_.age = p[0];
      break;
    case TurtleAction::guide:
      begin_guide(p);
      break;
    case TurtleAction::elasticity:
      state_.elasticity = p[0];
      break;
    case TurtleAction::instance:
      if (!p.empty() && std::fabs(p[0]) > kFarthest)
        fail(fmt::format("a size of more than {} m", kFarthest));
      if (builder_) builder_->instance(state_, action.name, p);
      break;
    case TurtleAction::nothing:
      break;
  }
}

void TurtleInterpreter::rotate(const Vec3d& axis, double angle) {
  constexpr double kExact = 1e5;  // range of the accurate sine: see base/maths.h
  if (!std::isfinite(angle)) fail("the angle of a rotation is not finite");
  if (std::fabs(angle) > kExact) angle = std::remainder(angle, 2 * kPi);
  state_.pose.frame = state_.pose.frame.rotated(axis, angle);
}

void TurtleInterpreter::set_radius(double radius) {
  if (!(radius <= kFarthest)) fail(fmt::format("a stem radius of more than {} m", kFarthest));
  state_.radius = radius;
  state_.radius_set = true;
}

void TurtleInterpreter::level() {
  Frame& frame = state_.pose.frame;
  const Vec3d left = Vec3d(0, 1, 0).cross(frame.tangent);
  if (left.length() < 1e-9) return;  // vertical heading: its left is always horizontal
  frame.normal = left.normalized();
  frame = frame.orthonormalized();
}

void TurtleInterpreter::push() {
  if (stack_.size() >= options_.max_depth)
    fail(fmt::format("brackets are nested more than {} levels deep", options_.max_depth));
  stack_.push_back(state_);
  if (state_.axis != Axis::kNone && builder_) {
    state_.parent_along = builder_->length(state_);
    state_.parent = state_.axis;
    state_.axis = Axis::kNone;
    state_.radius_set = false;
  }
  state_.guide = -1;  // a branch does not follow the guide
}

void TurtleInterpreter::pop() {
  if (stack_.empty()) fail("a ']' without a matching '['");
  state_ = stack_.back();
  stack_.pop_back();
}

void TurtleInterpreter::brace(TurtleAction action) {
  if (action == TurtleAction::open) {
    ++braces_;
    if (builder_) builder_->open(state_);
    return;
  }
  if (braces_ == 0)
    fail(action == TurtleAction::close ? "a '}' without a matching '{'" : "a '.' outside of { }");
  if (action == TurtleAction::close) --braces_;
  if (builder_) action == TurtleAction::close ? builder_->close() : builder_->corner(state_);
}

Drawing draw(const Word& word, const Alphabet& alphabet, const TurtleOptions& options) {
  Drawing drawing;
  drawing.names = options.instances;
  DrawingBuilder builder(drawing);
  TurtleInterpreter(word, alphabet, options, &builder).walk({}, {});
  return drawing;
}

void visit_poses(const Word& word, const Alphabet& alphabet, const TurtleOptions& options,
                 const std::vector<SymbolId>& symbols, const PoseVisitor& visit) {
  TurtleInterpreter(word, alphabet, options, nullptr).walk(symbols, visit);
}

}  // namespace vug::lsystem
