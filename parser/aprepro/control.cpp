// SPDX-License-Identifier: BSD-3-Clause
#include "parser/aprepro/control.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "parser/aprepro/groups.hpp"

namespace contactsim {

namespace {

using Word = ApreproGroup::Word;
using Kind = ApreproNode::Kind;
using Test = ApreproBranch::Test;
using Nodes = std::vector<ApreproNode>;

constexpr std::size_t max_depth = 64;

/// How a construct that needs an end is written.
struct Form {
  const char* begin;
  const char* end;
};

Form form_of(Kind kind) {
  if (kind == Kind::conditional) return {"{if(...)}", "{endif}"};
  if (kind == Kind::choice) return {"{switch(...)}", "{endswitch}"};
  return {"{loop(...)}", "{endloop}"};
}

class StructureReader {
 public:
  StructureReader(const Source& source, Diagnostics& diagnostics)
      : source_(source), diagnostics_(diagnostics), text_(source.text()) {}
  Nodes read();

 private:
  void read_special();
  void read_group();
  bool read_comment_group();
  void read_simple(const ApreproGroup& group);
  void read_verbatim(const ApreproGroup& group);
  void read_include(const ApreproGroup& group, bool is_glued);
  void read_control(const ApreproGroup& group);
  void begin_construct(Kind kind, const ApreproGroup& group);
  void begin_branch(const ApreproGroup& group);
  bool close_down_to(Kind kind, const ApreproGroup& group);
  void close_innermost();
  void add(ApreproNode node);
  void flush(std::size_t end);
  bool flush_before_control(std::size_t at);
  void resume(std::size_t at) { at_ = text_from_ = at; }
  std::size_t line_end(std::size_t at, std::size_t limit = std::string_view::npos) const {
    const std::string_view part = text_.substr(at, limit == std::string_view::npos ? limit : limit - at);
    return at + std::min(part.find('\n'), part.size());
  }
  void keep_rest_of_line(const ApreproGroup& group);
  void drop_rest_of_line(std::size_t from) { resume(std::min(line_end(from) + 1, text_.size())); }

  const Source& source_;
  Diagnostics& diagnostics_;
  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t text_from_ = 0;                              ///< text from here to at_ is still to be added
  std::size_t dropped_line_end_ = std::string_view::npos;  ///< a line end that is not copied
  std::size_t next_line_end_ = 0;  ///< the one found last, to search a long line but once
  Nodes top_;
  Nodes open_;  ///< constructs without their end yet, the innermost last
};

Nodes StructureReader::read() {
  while ((at_ = text_.find_first_of("{\\", at_)) != std::string_view::npos) read_special();
  flush(text_.size());
  while (!open_.empty()) {
    const Form form = form_of(open_.back().kind);
    diagnostics_.add_error(source_.locate(open_.back().at),
                           fmt::format("this {} has no {}", form.begin, form.end));
    close_innermost();
  }
  return std::move(top_);
}

void StructureReader::read_special() {
  const bool is_brace = text_[at_] == '{';
  const bool is_escape =
      !is_brace && at_ + 1 < text_.size() && (text_[at_ + 1] == '{' || text_[at_ + 1] == '}');
  if (is_escape) {
    flush(at_);
    text_from_ = at_ + 1;
    at_ += 2;
  } else if (!is_brace) {
    ++at_;
  } else if (!read_comment_group()) {
    read_group();
  }
}

/// {#} at the start of a line: the rest of the line is copied behind a #.
bool StructureReader::read_comment_group() {
  std::size_t line_begin = at_;
  while (line_begin > 0 && (text_[line_begin - 1] == ' ' || text_[line_begin - 1] == '\t')) --line_begin;
  const bool is_first = line_begin == 0 || text_[line_begin - 1] == '\n';
  if (!is_first || !text_.substr(at_).starts_with("{#}")) return false;
  flush(at_);
  add({Kind::text, {at_ + 1, at_ + 2}});
  add({Kind::text, {at_ + 3, line_end(at_)}});
  resume(line_end(at_));
  return true;
}

void StructureReader::read_group() {
  const ApreproGroup group = read_aprepro_group(text_, at_);
  if (group.word == Word::none) {
    flush(at_);
    const Kind kind = group.is_silent ? Kind::silent : Kind::expression;
    add({group.is_closed ? kind : Kind::unclosed, group.inside, at_});
    resume(group.is_closed ? group.end : std::min(group.end, line_end(at_, group.end)));
  } else if (group.word == Word::verbatim_on || group.word == Word::verbatim_off) {
    read_verbatim(group);
  } else if (group.word >= Word::echo_on) {
    read_simple(group);
  } else {
    read_control(group);
  }
}

void StructureReader::read_simple(const ApreproGroup& group) {
  std::size_t end = group.at;
  while (end > text_from_ && (text_[end - 1] == ' ' || text_[end - 1] == '\t')) --end;
  flush(end);
  const auto kind =
      static_cast<int>(Kind::echo_on) + static_cast<int>(group.word) - static_cast<int>(Word::echo_on);
  add({static_cast<Kind>(kind), {}, group.at});
  resume(group.end);
}

void StructureReader::read_verbatim(const ApreproGroup& group) {
  flush(group.at);
  resume(group.end);
  if (group.word == Word::verbatim_off) return;
  const bool by_aprepro = text_.substr(group.at).starts_with("{APREPRO");
  const std::string_view end_mark = by_aprepro ? "{APREPRO(ON)}" : "{VERBATIM(OFF)}";
  const std::size_t end = std::min(text_.find(end_mark, group.end), text_.size());
  flush(end);
  resume(std::min(end + end_mark.size(), text_.size()));
}

void StructureReader::read_include(const ApreproGroup& group, bool is_glued) {
  ApreproNode node{group.word == Word::include ? Kind::include : Kind::optional_include, group.argument,
                   group.at};
  node.is_glued = is_glued;
  std::size_t end = group.end;
  while (end < text_.size() && (text_[end] == '\n' || text_.substr(end).starts_with("\r\n"))) ++end;
  node.ends_line = end > group.end || end == text_.size();
  add(std::move(node));
  resume(end);
}

void StructureReader::read_control(const ApreproGroup& group) {
  const bool is_glued = flush_before_control(group.at);
  const bool is_include = group.word == Word::include || group.word == Word::optional_include;
  if (is_glued && !is_include) add({Kind::glued_mark, {}, group.at - 1});
  if (const auto kind = construct_begun_by(group.word)) {
    begin_construct(*kind, group);
  } else if (const auto ended = construct_ended_by(group.word)) {
    if (close_down_to(*ended, group)) close_innermost();
    drop_rest_of_line(group.end);
  } else if (const auto split = construct_split_by(group.word)) {
    if (close_down_to(*split, group)) begin_branch(group);
    const bool has_condition = group.argument.end > group.argument.begin;
    has_condition ? keep_rest_of_line(group) : drop_rest_of_line(group.end);
  } else {
    read_include(group, is_glued);
  }
}

void StructureReader::begin_construct(Kind kind, const ApreproGroup& group) {
  if (open_.size() >= max_depth) {
    diagnostics_.add_error(source_.locate(group.at),
                           fmt::format("ifs, switches and loops are nested more than {} deep", max_depth));
    open_.clear();
    resume(text_.size());
    return;
  }
  open_.push_back({kind, group.argument, group.at});
  if (kind == Kind::conditional) {
    begin_branch(group);
    keep_rest_of_line(group);
  } else {
    drop_rest_of_line(group.end);
  }
}

void StructureReader::begin_branch(const ApreproGroup& group) {
  auto& branches = open_.back().branches;
  if (!branches.empty() && branches.back().test == Test::otherwise) {
    const bool is_if = open_.back().kind == Kind::conditional;
    diagnostics_.add_error(
        source_.locate(group.at),
        fmt::format("this stands behind {}, which must be last", is_if ? "{else}" : "{default}"),
        "the " + std::string(is_if ? "if" : "switch") + " begins at " +
            to_string(source_.locate(open_.back().at)));
  }
  branches.push_back({test_of(group.word), group.argument, {}});
}

/// Makes the innermost open construct of the kind the innermost of all; false and an error when none is open.
bool StructureReader::close_down_to(Kind kind, const ApreproGroup& group) {
  const bool is_open =
      std::any_of(open_.begin(), open_.end(), [&](const ApreproNode& node) { return node.kind == kind; });
  const std::string_view shown = text_.substr(group.at, group.end - group.at);
  if (!is_open) {
    diagnostics_.add_error(source_.locate(group.at), fmt::format("{} without {}", shown, form_of(kind).begin),
                           "", static_cast<int>(shown.size()));
    return false;
  }
  while (open_.back().kind != kind) {
    const Form form = form_of(open_.back().kind);
    diagnostics_.add_error(
        source_.locate(open_.back().at), fmt::format("this {} has no {}", form.begin, form.end),
        fmt::format("it is missing before {} at {}", shown, to_string(source_.locate(group.at))));
    close_innermost();
  }
  return true;
}

void StructureReader::close_innermost() {
  ApreproNode node = std::move(open_.back());
  open_.pop_back();
  add(std::move(node));
}

/// What stands between a switch and its first case is dropped.
void StructureReader::add(ApreproNode node) {
  if (open_.empty()) {
    top_.push_back(std::move(node));
  } else if (open_.back().kind == Kind::loop) {
    open_.back().body.push_back(std::move(node));
  } else if (!open_.back().branches.empty()) {
    open_.back().branches.back().body.push_back(std::move(node));
  }
}

void StructureReader::flush(std::size_t end) {
  std::size_t dropped = dropped_line_end_;
  if (dropped < text_from_ || dropped >= end) dropped = end;
  std::size_t first_end = dropped;
  if (dropped < end && dropped > text_from_ && text_[dropped - 1] == '\r') --first_end;
  if (first_end > text_from_) add({Kind::text, {text_from_, first_end}});
  if (dropped + 1 < end) add({Kind::text, {dropped + 1, end}});
  text_from_ = end;
}

/// Adds the pending text but for the blanks that begin the control group's line, and for a comment mark there
/// with blanks behind it. Returns whether a mark without blank is left before the group.
bool StructureReader::flush_before_control(std::size_t at) {
  const auto is_blank = [&](std::size_t i) { return text_[i] == ' ' || text_[i] == '\t'; };
  std::size_t end = at;
  while (end > text_from_ && is_blank(end - 1)) --end;
  std::size_t mark = end;
  while (mark > text_from_ && std::string_view("#$/").find(text_[mark - 1]) != std::string_view::npos) --mark;
  std::size_t line_begin = mark;
  while (line_begin > text_from_ && is_blank(line_begin - 1)) --line_begin;
  const bool is_at_start = line_begin == 0 || text_[line_begin - 1] == '\n';
  const bool has_mark = mark < end && !(end == mark + 1 && text_[mark] == '/');
  const bool is_removed = is_at_start && (mark == end || (has_mark && end < at));
  flush(is_removed ? line_begin : at);
  return is_at_start && has_mark && !is_removed;
}

/// Aprepro copies what follows an if or a case on its line, but not the line end.
void StructureReader::keep_rest_of_line(const ApreproGroup& group) {
  resume(group.end);
  if (next_line_end_ < group.end) next_line_end_ = line_end(group.end);
  dropped_line_end_ = next_line_end_;
  const std::size_t text = text_.find_first_not_of(" \t\r", group.end);
  const bool is_text = text < next_line_end_ && text_[text] != '{';
  if (is_text) add({Kind::joined_text, {group.at, group.end}, text});
}

}  // namespace

std::vector<ApreproNode> read_aprepro_structure(const Source& source, Diagnostics& diagnostics) {
  return StructureReader(source, diagnostics).read();
}

}  // namespace contactsim
