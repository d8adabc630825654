// SPDX-License-Identifier: Apache-2.0
// A facade session as an immutable value, from which the undo stack of a window is made.
#pragma once

#include <vug/modeller/session.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vug::workbench {

/// Copies share the list of edits and are cheap.
class FacadeDocument {
 public:
  /// The state of the session after its active edits.
  explicit FacadeDocument(const modeller::Session& session);

  const modeller::SessionHeader& header() const { return *header_; }
  const modeller::FacadeState& state() const { return state_; }
  size_t edit_count() const { return last_ ? last_->count : 0; }
  std::vector<modeller::Edit> edits() const;
  /// Number of edits before each checkpoint, by name.
  const std::map<std::string, size_t>& checkpoints() const { return checkpoints_; }
  /// 0 if unknown.
  double metres_per_pixel() const;

  /// The document after one more edit. Throws RejectedEdit if it cannot be performed.
  FacadeDocument edited(const modeller::Edit& edit) const;
  /// The document with other edits from the same start. Throws RejectedEdit.
  FacadeDocument with_edits(const std::vector<modeller::Edit>& edits) const;
  /// The document with another header and these edits, which keep the checkpoints. Throws
  /// RejectedEdit with the first edit that does not fit.
  FacadeDocument with_header(modeller::SessionHeader header,
                             const std::vector<modeller::Edit>& edits) const;
  FacadeDocument with_checkpoint(const std::string& name) const;
  /// The state after the first `count` edits of this document.
  FacadeDocument first_edits(size_t count) const;
  /// Whether the edits of `later` begin with those of this document, with the same header.
  bool is_prefix_of(const FacadeDocument& later) const;

  /// The session with these documents' edits as undone ones, as far as they continue this one.
  modeller::Session session(const std::vector<FacadeDocument>& undone = {}) const;

 private:
  /// A list that grows at its end and shares its beginning.
  struct Link {
    std::shared_ptr<const Link> before;
    modeller::Edit edit;
    size_t count = 1;
  };

  std::shared_ptr<const modeller::SessionHeader> header_;
  modeller::FacadeState state_;
  std::shared_ptr<const Link> last_;
  std::map<std::string, size_t> checkpoints_;
};

}  // namespace vug::workbench
