// SPDX-License-Identifier: BSD-3-Clause
#include "parser/binding/deck_names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "parser/text/phrases.hpp"

namespace contactsim {

namespace {

int length_of(const DeckName& name) { return std::max(1, static_cast<int>(name.text.size())); }

/// Whether a definition of the kind counts only when something uses it.
bool waits_for_use(std::optional<NameKind> kind) { return kind && text_of(*kind).counts != Counts::always; }

}  // namespace

DeckNames::DeckNames() : blocks_(1) {}

void DeckNames::begin_block(std::string_view phrase, std::optional<NameKind> kind, const DeckName& name) {
  blocks_[current_].inner.push_back(blocks_.size());
  NamedBlock& block = blocks_.emplace_back();
  block.around = current_;
  block.phrase = phrase;
  block.kind = kind;
  block.name = name;
  current_ = blocks_.size() - 1;
}

void DeckNames::note(std::string_view phrase, const NameNotes& notes) {
  for (const NamedKind& defined : notes.defined) begin_block(phrase, defined.kind, defined.name);
  for (const NamedKind& referred : notes.referred) refer(referred.kind, referred.name);
  for (std::size_t i = 0; i < notes.defined.size(); ++i) end_block();
  auto& left_open = blocks_[current_].left_open;
  left_open.insert(left_open.end(), notes.left_open.begin(), notes.left_open.end());
}

void DeckNames::refer(NameKind kind, const DeckName& name) {
  if (!text_of(kind).is_in_mesh) blocks_[current_].references.push_back({kind, name});
}

Diagnostics& DeckNames::problems_of_lines(Diagnostics& otherwise) {
  NamedBlock& block = blocks_[current_];
  const bool waits = block.kind && text_of(*block.kind).counts == Counts::even_reading_when_used;
  return waits ? block.of_lines : otherwise;
}

std::string DeckNames::block_for_message() const {
  const NamedBlock& block = blocks_[current_];
  const std::string_view word = waits_for_use(block.kind) ? text_of(*block.kind).word : block.phrase;
  return block.name.text.empty() ? fmt::format("the {}", word)
                                 : fmt::format("the {} '{}'", word, block.name.text);
}

void DeckNames::note_wrong_lines() {
  NamedBlock& block = blocks_[current_];
  block.has_wrong_lines = true;
  if (!block.inner.empty()) return;
  Diagnostics kept;
  for (const Diagnostic& problem : block.of_block.all()) {
    if (problem.severity == Severity::warning) kept.add(problem);
  }
  block.of_block = std::move(kept);
}

void DeckNames::add_problem_of_block(std::string_view text, std::string hint) {
  NamedBlock& block = blocks_[current_];
  block.of_block.add_error(block.name.location, fmt::format("{} {}", block_for_message(), text),
                           std::move(hint), length_of(block.name));
}

KnownNames& DeckNames::known_in(const Home& home) {
  const auto found = known_.find(home);
  if (found != known_.end()) return found->second;
  const NameKindText& text = text_of(home.second);
  const DeckName& name = blocks_[home.first].name;
  KnownNames& known = known_
                          .try_emplace(home, std::string(text.word),
                                       fmt::format(fmt::runtime(text.owner), name.text), text.made_by)
                          .first->second;
  for (const std::string_view built_in : text.built_in) known.add_built_in(built_in, text.redefines_built_in);
  if (is_fragment_ && text.home != NameKind::contact_definition) known.allow_unknown();
  return known;
}

std::size_t DeckNames::home_around(NameKind kind, std::size_t block) const {
  const auto home = text_of(kind).home;
  if (!home) return 0;
  while (block != 0 && blocks_[block].kind != *home) block = blocks_[block].around;
  return block;
}

void DeckNames::define_all(Diagnostics& diagnostics) {
  for (std::size_t i = 1; i < blocks_.size(); ++i) {
    NamedBlock& block = blocks_[i];
    block.is_dropped = block.is_dropped || blocks_[block.around].is_dropped;
    if (block.is_dropped) continue;
    if (block.kind) {
      const std::size_t home = home_around(*block.kind, block.around);
      known_in({home, *block.kind}).define(block.name, i, diagnostics);
    }
    for (const NameKind kind : block.left_open) known_in({home_around(kind, i), kind}).allow_unknown();
  }
  for (const NameKind kind : blocks_[0].left_open) known_in({0, kind}).allow_unknown();
}

void DeckNames::resolve(Diagnostics& diagnostics) {
  define_all(diagnostics);
  mark_used(0);
  look_up_in_used(diagnostics);
}

void DeckNames::use(NameKind kind, const DeckName& reference, Diagnostics& diagnostics) {
  look_up({kind, reference}, 0, diagnostics);
  look_up_in_used(diagnostics);
}

void DeckNames::use_all(NameKind kind, Diagnostics& diagnostics) {
  for (std::size_t i = 1; i < blocks_.size(); ++i) {
    if (blocks_[i].kind == kind) mark_used(i);
  }
  look_up_in_used(diagnostics);
}

void DeckNames::mark_used(std::size_t i) {
  NamedBlock& block = blocks_[i];
  if (block.is_used || block.is_dropped) return;
  block.is_used = true;
  new_in_use_.push_back(i);
  for (const std::size_t inner : block.inner) {
    if (!waits_for_use(blocks_[inner].kind)) mark_used(inner);
  }
}

void DeckNames::look_up_in_used(Diagnostics& diagnostics) {
  while (!new_in_use_.empty()) {
    const std::size_t i = new_in_use_.back();
    new_in_use_.pop_back();
    diagnostics.append(blocks_[i].of_block);
    for (const NamedKind& reference : blocks_[i].references) look_up(reference, i, diagnostics);
  }
}

/// A name that is known inside a definition which is itself used by name, a model of a material, is looked up
/// in the one around or else in the one that the same block names.
std::vector<std::size_t> DeckNames::homes_of(const NamedKind& reference, std::size_t i,
                                             Diagnostics& diagnostics) {
  const std::size_t around = home_around(reference.kind, i);
  const auto home = text_of(reference.kind).home;
  if (around != 0 || !waits_for_use(home)) return {around};
  for (const NamedKind& other : blocks_[i].references) {
    if (other.kind == *home) return known_in({home_around(*home, i), *home}).find(other.name.text);
  }
  const std::string_view word = text_of(*home).word;
  diagnostics.add_error(reference.name.location,
                        fmt::format("the {} '{}' is chosen without a {}", text_of(reference.kind).word,
                                    reference.name.text, word),
                        fmt::format("add {} = <{}>", upper(word), word), length_of(reference.name));
  return {};
}

void DeckNames::look_up(const NamedKind& reference, std::size_t i, Diagnostics& diagnostics) {
  const DeckName& name = reference.name;
  const auto& mistake = text_of(reference.kind).mistake;
  for (const std::size_t home : homes_of(reference, i, diagnostics)) {
    const KnownNames& known = known_in({home, reference.kind});
    if (mistake && !known.knows(name.text) && known_in({0, mistake->kind}).knows(name.text)) {
      diagnostics.add_error(name.location,
                            fmt::format("'{}' is a {}, not a {}", name.text, text_of(mistake->kind).word,
                                        text_of(reference.kind).word),
                            std::string(mistake->hint), length_of(name));
      continue;
    }
    for (const std::size_t definition : known.look_up(name, diagnostics)) mark_used(definition);
  }
}

const DeckNames::NamedBlock* DeckNames::find_block(NameKind kind, const DeckName& definition) const {
  for (const auto& [home, known] : known_) {
    if (home.second != kind) continue;
    for (const std::size_t i : known.find(definition.text)) {
      const DeckLocation& place = blocks_[i].name.location;
      if (place.line == definition.location.line && place.column == definition.location.column)
        return &blocks_[i];
    }
  }
  return nullptr;
}

bool DeckNames::is_used(NameKind kind, const DeckName& definition) const {
  const NamedBlock* block = find_block(kind, definition);
  return block != nullptr && block->is_used;
}

bool DeckNames::has_wrong_lines(NameKind kind, const DeckName& definition) const {
  const NamedBlock* block = find_block(kind, definition);
  return block != nullptr && block->has_wrong_lines;
}

void DeckNames::report_problems_of_lines(Diagnostics& diagnostics) const {
  for (const NamedBlock& block : blocks_) {
    for (Diagnostic problem : block.of_lines.all()) {
      if (!block.is_used && problem.severity == Severity::error) {
        problem.severity = Severity::warning;
        problem.id = "deck-unused";
        problem.text += ", but nothing uses this definition";
      }
      diagnostics.add(std::move(problem));
    }
  }
}

}  // namespace contactsim
