// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/image/io.h>
#include <vug/session/facade_model.h>
#include <vug/workbench/facade_bench.h>
#include <vug/workbench/step_name.h>
#include <vug/workbench/words.h>

#include <fmt/format.h>

#include <cmath>

namespace vug::workbench {

namespace fs = std::filesystem;
using modeller::Edit;
using modeller::FacadeState;

namespace {

fs::path folder_of(const fs::path& file) {
  return fs::absolute(file).lexically_normal().parent_path();
}

}  // namespace

FacadeBench::FacadeBench(std::function<void()> notify)
    : scoring_(notify), fit_(std::move(notify)) {}

FacadeBench::~FacadeBench() = default;

const UndoStack<FacadeDocument>& FacadeBench::stack() const {
  if (!stack_)
    throw Error(ErrorCode::bad_input, "no facade is open", {}, "open a photo or a session");
  return *stack_;
}

const FacadeState& FacadeBench::state() const { return preview_ ? *preview_ : document().state(); }

fs::path FacadeBench::photo() const {
  if (!has_document() || !document().header().photo) return {};
  return (folder_ / document().header().photo->file).lexically_normal();
}

void FacadeBench::open(const fs::path& file) {
  const fs::path folder = folder_of(file);
  const modeller::Session session =
      modeller::read_session(read_text(file), file.string(), session::facade_style_loader(folder));
  file_ = fs::absolute(file).lexically_normal(), folder_ = folder;
  set_document(session);
}

void FacadeBench::open_photo(const fs::path& photo, const std::string& grammar, double width) {
  const image::FileInfo info = image::read_info(photo);
  const fs::path folder = folder_of(photo);
  modeller::SessionHeader header{.grammar = grammar};
  if (fs::exists(grammar)) header.grammar = session::relative_path_from(folder, grammar);
  header.photo = modeller::Photo{session::relative_path_from(folder, photo), info.width,
                                 info.height, width / info.width};
  const modeller::Session session =
      modeller::new_session(std::move(header), session::facade_style_loader(folder));
  file_.clear(), folder_ = folder;
  set_document(session);
}

void FacadeBench::set_document(const modeller::Session& session) {
  fit_.stop();
  preview_.reset(), best_tree_.reset(), handle_.reset();
  fit_update_ = {};
  comparisons_.clear();
  modeller::History history = session.history;
  history.undo(history.done());
  const auto with_checkpoints = [&](FacadeDocument at) {
    for (const auto& [name, count] : session.history.checkpoints())
      if (count == at.edit_count()) at = at.with_checkpoint(name);
    return at;
  };
  stack_.emplace(with_checkpoints(FacadeDocument({session.header, history})));
  // All edits are steps, so that the window can undo and redo those of the file.
  for (const Edit& edit : session.history.edits()) {
    const FacadeDocument& current = document();
    stack_->push(step_name(current.state(), edit), with_checkpoints(current.edited(edit)));
  }
  stack_->undo(stack_->done());
  stack_->redo(session.history.done());
  stack_->set_clean();
  selection_ = {};
  scorer_.reset();
  changed();
  start_scoring();
}

modeller::Session FacadeBench::session_for(const fs::path& file) const {
  modeller::Session out = document().session(stack().undone());
  out.header = session::moved_header(std::move(out.header), folder_, folder_of(file));
  return out;
}

void FacadeBench::save(const fs::path& file) {
  write_text(file, modeller::session_text(session_for(file)));
  file_ = fs::absolute(file).lexically_normal();
  stack_->set_clean();
}

std::string FacadeBench::opening_line() const {
  if (!file_.empty()) return "open " + quoted(file_.string());
  const modeller::SessionHeader& header = stack_->start().header();
  const modeller::Photo& photo = *header.photo;
  const fs::path grammar = folder_ / header.grammar;
  return fmt::format("photo {} {}m {}", quoted((folder_ / photo.file).lexically_normal().string()),
                     photo.scale * photo.width,
                     quoted(fs::exists(grammar) ? grammar.string() : header.grammar));
}

void FacadeBench::changed() {
  ++revision_;
  score_.reset();
}

void FacadeBench::edit(const Edit& edit, const std::string& merge) {
  preview_.reset();
  const FacadeDocument& current = document();
  const FacadeDocument& base = stack_->merges(merge) ? stack_->before() : current;
  FacadeDocument next = base.edited(edit);
  stack_->push(step_name(base.state(), edit), std::move(next), merge);
  changed();
}

void FacadeBench::replace(const std::vector<Edit>& edits, const std::string& step) {
  change_document(document().with_edits(edits), step);
}

void FacadeBench::change_document(FacadeDocument to, const std::string& step) {
  preview_.reset();
  stack_->push(step, std::move(to));
  changed();
}

bool FacadeBench::undo() {
  preview_.reset();
  const bool done = has_document() && stack_->undo() > 0;
  if (done) changed();
  return done;
}

bool FacadeBench::redo() {
  preview_.reset();
  const bool done = has_document() && stack_->redo() > 0;
  if (done) changed();
  return done;
}

void FacadeBench::select(int node) {
  if (node != selected()) handle_.reset();
  selection_.set(state(), node);
}

std::vector<Handle> FacadeBench::current_handles() const {
  return handles(state(), numbers_node(state(), selected()));
}

std::optional<Handle> FacadeBench::handle() const {
  if (!handle_) return std::nullopt;
  for (const Handle& each : current_handles())
    if (each.index == handle_->first && each.instance == handle_->second) return each;
  return std::nullopt;
}

void FacadeBench::select_handle(std::optional<size_t> index, size_t instance) {
  handle_.reset();
  if (index) handle_ = {*index, instance};
}

bool FacadeBench::preview(const Edit& edit) {
  try {
    preview_ = modeller::perform_edit(document().state(), edit);
  } catch (const modeller::RejectedEdit&) {
    return false;
  }
  changed();
  return true;
}

void FacadeBench::end_preview() {
  if (!preview_) return;
  preview_.reset();
  changed();
}

void FacadeBench::compare(const fs::path& file) {
  const modeller::Session session = modeller::read_session(
      read_text(file), file.string(), session::facade_style_loader(folder_of(file)));
  const modeller::Canvas &here = state().canvas(), there = session.current().canvas();
  if (std::abs(here.width * there.height - here.height * there.width) >
      0.01 * here.width * there.height)
    throw Error(ErrorCode::bad_input, "the facades differ in shape", {},
                "compare sessions of the same photo");
  comparisons_.push_back({file.filename().string(), session.current()});
}

}  // namespace vug::workbench
