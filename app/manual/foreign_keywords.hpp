// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace contactsim {

/// Where lines of ours stand in a deck.
enum class DeckPlace : std::uint8_t {
  sierra,                ///< outside procedures
  region,                ///< in BEGIN PRESTO REGION
  contact,               ///< in BEGIN CONTACT DEFINITION
  surface_options,       ///< in BEGIN SURFACE OPTIONS
  interaction_defaults,  ///< in BEGIN INTERACTION DEFAULTS
  interaction,           ///< in BEGIN INTERACTION
  results,               ///< in BEGIN RESULTS OUTPUT
  heartbeat,             ///< in BEGIN HEARTBEAT OUTPUT
  death,                 ///< in BEGIN ELEMENT DEATH
  none                   ///< nothing is written
};

/// What the manual says of a place: "in BEGIN INTERACTION".
std::string_view to_string(DeckPlace place);

/// Row of the page for users of other programs: what they write, and what a deck of ours has for it.
struct ForeignKeyword {
  std::string_view program;  ///< one of foreign_programs()
  std::string_view keyword;
  DeckPlace place = DeckPlace::none;
  std::string_view lines;  ///< ours; a and b are surfaces, rub and glue friction models, t1 a period
  std::string_view note;   ///< what differs; "" for nothing
};

/// The programs that the page is for.
std::span<const std::string_view> foreign_programs();

/// By program; every line of ours can be read.
/// Source: Abaqus 36.4.1, 38.1.3, 38.2.1; CalculiX *CONTACT PAIR; LS-DYNA keyword manual I, *CONTACT;
/// OptiStruct contact control.
std::span<const ForeignKeyword> foreign_keywords();

/// Those of one program, each in a file of its own.
std::span<const ForeignKeyword> abaqus_keywords();
std::span<const ForeignKeyword> calculix_keywords();
std::span<const ForeignKeyword> optistruct_keywords();
std::span<const ForeignKeyword> dyna_keywords();

/// Row of what others have and contactsim leaves out on purpose.
struct LeftOut {
  std::string_view what, why;
};
std::span<const LeftOut> left_out_rows();

/// The page: rows of a program, or all of them, then what is left out. "" when the words do not ask for it:
/// "coming from abaqus", or what the page calls a keyword begins with, "*contact pair".
std::string explain_foreign_keywords(std::span<const std::string> words);

}  // namespace contactsim
