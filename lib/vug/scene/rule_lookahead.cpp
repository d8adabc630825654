// SPDX-License-Identifier: Apache-2.0
#include <vug/scene/rule_lookahead.h>

namespace vug::scene {

size_t RuleLookahead::beyond_newlines(size_t ahead) const {
  while (cursor_.peek(ahead).kind == TokenKind::newline && cursor_.peek(ahead).text != ";") ++ahead;
  return ahead;
}

void RuleLookahead::read(size_t at) {
  if (begin_ <= at && at < end_) return;
  const size_t here = cursor_.position();
  begin_ = end_ = at;
  closing_.clear();
  std::vector<size_t> open;
  for (;; ++end_) {
    const Token& token = cursor_.peek(end_ - here);
    if (token.kind == TokenKind::end || token.is("}")) break;
    closing_.push_back(end_);
    if (token.is("(")) open.push_back(end_);
    if (token.is(")") && !open.empty()) {
      closing_[open.back() - begin_] = end_;
      open.pop_back();
    }
  }
  arrow_.assign(closing_.size(), end_);
  for (size_t i = end_, next = end_; i-- > begin_;) {
    if (cursor_.peek(i - here).is("->")) next = i;
    arrow_[i - begin_] = next;
  }
}

bool RuleLookahead::arrow_ahead(size_t from) {
  const size_t here = cursor_.position();
  read(here + from);
  for (size_t at = here + from; at < end_; at = closing_[at - begin_] + 1) {
    if (closing_[at - begin_] >= arrow_[at - begin_]) return arrow_[at - begin_] < end_;
    if (cursor_.peek(at - here).kind == TokenKind::newline)
      return cursor_.peek(beyond_newlines(at - here)).is("->");
  }
  return false;
}

}  // namespace vug::scene
