// SPDX-License-Identifier: BSD-3-Clause
#include "parser/text/source.hpp"

#include <algorithm>
#include <utility>

namespace contactsim {

IndexedFile::IndexedFile(SourceFile read_file) : file(std::move(read_file)), line_starts{0} {
  for (std::size_t i = 0; i < file.text.size(); ++i) {
    if (file.text[i] == '\n') line_starts.push_back(i + 1);
  }
}

DeckLocation to_location(const Origin& origin) {
  if (!origin.file) return {};
  const auto& starts = origin.file->line_starts;
  const auto next = std::upper_bound(starts.begin(), starts.end(), origin.offset);
  const auto line = next - starts.begin();
  const std::size_t column = origin.offset - *std::prev(next) + 1;
  return {std::shared_ptr<const SourceFile>(origin.file, &origin.file->file), static_cast<int>(line),
          static_cast<int>(column), origin.trail};
}

std::size_t Source::run_at(std::size_t offset) const {
  const auto next = std::upper_bound(runs_.begin(), runs_.end(), offset,
                                     [](std::size_t value, const Run& run) { return value < run.begin; });
  return static_cast<std::size_t>(std::prev(next) - runs_.begin());
}

Origin Source::origin(std::size_t offset) const {
  if (runs_.empty()) return {};
  const std::size_t inside = std::min(offset, text_.size());
  const Run& run = runs_[run_at(inside)];
  Origin origin = run.origin;
  if (!run.is_made) origin.offset += inside - run.begin;
  return origin;
}

void Source::append_copied(std::string_view text, const Origin& first) {
  if (text.empty()) return;
  const bool continues = !runs_.empty() && !runs_.back().is_made && runs_.back().origin.file == first.file &&
                         runs_.back().origin.trail == first.trail &&
                         runs_.back().origin.offset + (text_.size() - runs_.back().begin) == first.offset;
  if (!continues) runs_.push_back({text_.size(), first, false});
  text_ += text;
}

void Source::append_made(std::string_view text, const Origin& at) {
  if (text.empty()) return;
  runs_.push_back({text_.size(), at, true});
  text_ += text;
}

void Source::append_part(const Source& from, std::size_t begin, std::size_t end,
                         const std::shared_ptr<const Trail>& trail) {
  const std::string_view text = from.text_;
  std::size_t at = begin;
  for (std::size_t i = at < end ? from.run_at(at) : 0; at < end; ++i) {
    const bool is_last = i + 1 == from.runs_.size();
    const std::size_t stop = is_last ? end : std::min(end, from.runs_[i + 1].begin);
    Origin origin = from.origin(at);
    if (trail) origin.trail = trail;
    if (from.runs_[i].is_made) {
      append_made(text.substr(at, stop - at), origin);
    } else {
      append_copied(text.substr(at, stop - at), origin);
    }
    at = stop;
  }
}

Source make_source(std::string name, std::string text, const std::shared_ptr<const Trail>& trail) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
  const auto file = std::make_shared<const IndexedFile>(SourceFile{std::move(name), std::move(text)});
  Source source;
  source.append_copied(file->file.text, {file, 0, trail});
  return source;
}

}  // namespace contactsim
