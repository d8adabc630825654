// SPDX-License-Identifier: Apache-2.0
// Cancellation of work that has no Progress at hand: parallel loops and long serial loops.
#pragma once

namespace vug {

class Progress;

/// While it exists, the parallel loops that its thread starts, and those nested in them, throw
/// Error(cancelled) before their next task once `progress` was cancelled, and so does
/// check_cancelled(). The innermost scope counts: with Progress::none(), the work inside runs to
/// its end. `progress` must outlive the scope; null: like Progress::none().
class CancellableScope {
 public:
  explicit CancellableScope(const Progress& progress) : CancellableScope(&progress) {}
  explicit CancellableScope(const Progress* progress) : outer_(innermost_) {
    innermost_ = progress;
  }
  ~CancellableScope() { innermost_ = outer_; }
  CancellableScope(const CancellableScope&) = delete;
  CancellableScope& operator=(const CancellableScope&) = delete;

  /// The progress of the innermost scope of this thread; null: none.
  static const Progress* innermost() { return innermost_; }

 private:
  static inline constinit thread_local const Progress* innermost_ = nullptr;

  const Progress* outer_;
};

/// For long serial loops. Throws Error(cancelled) if the progress of the innermost scope was
/// cancelled.
void check_cancelled();

}  // namespace vug
