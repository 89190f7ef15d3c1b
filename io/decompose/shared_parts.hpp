// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/decompose/piece_layout.hpp"

namespace contactsim {

/// Adds to a piece what the Nemesis variables of the Exodus library say: the numbers of the whole, which
/// nodes and elements are the piece's alone (internal) and which lie at other pieces (border), and lists of
/// what is shared with whom. Source: Hennigan & Shadid, NEMESIS I (Sandia National Laboratories, 1998); file
/// type 0, one processor a file.
void add_shared_parts(const WholeFile& whole, std::uint32_t piece, PieceLayout& made);

}  // namespace contactsim
