// SPDX-License-Identifier: Apache-2.0
// The text from which a value was made, and what was being evaluated at the time.
#pragma once

#include <vug/base/error.h>

#include <memory>
#include <string>

namespace vug::scene {

/// A declaration, name or rule that is being evaluated.
struct Frame {
  std::string what;      ///< E.g. "let 'ball'", "volume 'rock'", "rule 'Room(2)'".
  SourceLocation where;  ///< Its first use, or the item of the rule that is being evaluated.
  std::shared_ptr<const Frame> outer;  ///< What used it; null: nothing.
};
using FramePtr = std::shared_ptr<const Frame>;

struct Provenance {
  SourceLocation where;  ///< The declaration or expression.
  FramePtr frame;        ///< The innermost frame; null for a declaration.
};

/// Adds a frame to a stack for its lifetime.
class FrameScope {
 public:
  FrameScope(FramePtr& stack, std::string what, const SourceLocation& where)
      : stack_(stack), outer_(stack) {
    stack = std::make_shared<const Frame>(Frame{std::move(what), where, outer_});
  }
  ~FrameScope() { stack_ = std::move(outer_); }
  FrameScope(const FrameScope&) = delete;
  FrameScope& operator=(const FrameScope&) = delete;

 private:
  FramePtr& stack_;
  FramePtr outer_;
};

}  // namespace vug::scene
