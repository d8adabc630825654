// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/facade_document.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::workbench {

using modeller::Edit;
using modeller::FacadeState;

FacadeDocument::FacadeDocument(const modeller::Session& session)
    : header_(std::make_shared<const modeller::SessionHeader>(session.header)),
      state_(session.current()) {
  for (size_t i = 0; i < session.history.done(); ++i)
    last_ = std::make_shared<const Link>(Link{last_, session.history.edits()[i], i + 1});
  for (const auto& [name, count] : session.history.checkpoints())
    if (count <= session.history.done() && !name.empty()) checkpoints_[name] = count;
}

std::vector<Edit> FacadeDocument::edits() const {
  std::vector<Edit> out;
  for (const Link* at = last_.get(); at; at = at->before.get()) out.push_back(at->edit);
  std::reverse(out.begin(), out.end());
  return out;
}

double FacadeDocument::metres_per_pixel() const {
  if (!header_->photo) return 0;
  if (header_->photo->scale > 0) return header_->photo->scale;
  return header_->photo->width > 0 ? state_.canvas().width / header_->photo->width : 0;
}

FacadeDocument FacadeDocument::edited(const Edit& edit) const {
  FacadeDocument out = *this;
  out.state_ = modeller::perform_edit(state_, edit);
  out.last_ = std::make_shared<const Link>(Link{last_, edit, edit_count() + 1});
  return out;
}

FacadeDocument FacadeDocument::with_edits(const std::vector<Edit>& edits) const {
  FacadeDocument out = *this;
  out.state_ = FacadeState(state_.style_ptr(), state_.canvas());
  out.last_.reset();
  out.checkpoints_.clear();
  for (const Edit& edit : edits) out = out.edited(edit);
  return out;
}

FacadeDocument FacadeDocument::with_header(modeller::SessionHeader header,
                                           const std::vector<Edit>& edits) const {
  // The grammar stays the same, so that it is not loaded again.
  const modeller::StyleLoader same = [this](const std::string&, const std::string&) {
    return state_.style_ptr();
  };
  FacadeDocument out(modeller::new_session(std::move(header), same));
  for (const Edit& edit : edits) {
    try {
      out = out.edited(edit);
    } catch (Error& error) {
      error.within(fmt::format("doing '{}' again", to_string(edit)));
      throw;
    }
  }
  out.checkpoints_ = checkpoints_;
  return out;
}

FacadeDocument FacadeDocument::with_checkpoint(const std::string& name) const {
  if (name.empty())
    throw Error(ErrorCode::bad_input, "a checkpoint needs a name", {},
                "such as checkpoint storeys");
  FacadeDocument out = *this;
  out.checkpoints_[name] = edit_count();
  return out;
}

FacadeDocument FacadeDocument::first_edits(size_t count) const {
  std::vector<Edit> all = edits();
  all.resize(std::min(count, all.size()));
  FacadeDocument out = with_edits(all);
  for (const auto& [name, at] : checkpoints_)
    if (at <= count) out.checkpoints_[name] = at;
  return out;
}

bool FacadeDocument::is_prefix_of(const FacadeDocument& later) const {
  if (header_ != later.header_ || later.edit_count() < edit_count()) return false;
  const Link* at = later.last_.get();
  while (at && at->count > edit_count()) at = at->before.get();
  return at == last_.get();
}

modeller::Session FacadeDocument::session(const std::vector<FacadeDocument>& undone) const {
  const FacadeDocument* longest = this;
  for (const FacadeDocument& each : undone) {
    if (!longest->is_prefix_of(each)) break;
    longest = &each;
  }
  modeller::Session out{*header_,
                        modeller::History(FacadeState(state_.style_ptr(), state_.canvas()))};
  const std::vector<Edit> all = longest->edits();
  for (size_t i = 0;; ++i) {
    for (const auto& [name, count] : longest->checkpoints_)
      if (count == i) out.history.set_checkpoint(name);
    if (i == all.size()) break;
    out.history.apply(all[i]);
  }
  out.history.undo(all.size() - edit_count());
  return out;
}

}  // namespace vug::workbench
