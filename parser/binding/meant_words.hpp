// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>

#include "parser/binding/table_text.hpp"

namespace contactsim {

/// Where a line or a block that a block does not know belongs, when an inner block of it knows it: what to do
/// about it; "" when none does.
std::string find_inner_place(std::span<const Word> words, bool is_block, const TableText& table);

/// What a line may mean that its block does not know and that is spelled like none: "" when nothing comes to
/// mind.
///   title  of the block
std::string find_meaning(std::span<const Word> words, bool is_block, std::span<const Word> title,
                         const TableText& table);

}  // namespace contactsim
