// SPDX-License-Identifier: BSD-3-Clause
#include "parser/command_tree.hpp"

#include <map>

#include "parser/commands/deck_commands.hpp"

namespace contactsim {

namespace {

class TreeBuilder {
 public:
  std::vector<TreeRow> build() {
    add(deck_table(DeckForm::full).text(), {});
    return std::move(rows_);
  }

 private:
  void add(const TableText& table, const std::vector<const RowText*>& around) {
    for (const RowText& row : table.rows) {
      TreeRow added{&row, around, nullptr};
      const TableText* contents = row.contents ? &row.contents() : nullptr;
      if (contents == nullptr) {
        rows_.push_back(added);
        continue;
      }
      const auto [listed, is_new] = listed_.try_emplace(contents, &row);
      if (!is_new) added.same_as = listed->second;
      rows_.push_back(added);
      if (!is_new) continue;
      std::vector<const RowText*> inner = around;
      inner.push_back(&row);
      add(*contents, inner);
    }
  }

  std::vector<TreeRow> rows_;
  std::map<const TableText*, const RowText*> listed_;  ///< looked up only, never walked
};

}  // namespace

const std::vector<TreeRow>& command_tree() {
  static const std::vector<TreeRow> tree = TreeBuilder().build();
  return tree;
}

}  // namespace contactsim
