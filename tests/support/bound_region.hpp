// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "parser/commands/contact_checks.hpp"
#include "parser/commands/region_commands.hpp"
#include "parser/text/syntax.hpp"
#include "support/deck_dump.hpp"

namespace contactsim {

/// The lines of a region as the tables bind them, and what they said about it. Names are not resolved.
struct BoundRegion {
  Region region;
  std::string messages;
};

/// Binds lines that stand in a region; the first is line 1 of "a.i".
inline BoundRegion bound_region(const std::string& lines, bool is_lenient = false) {
  Diagnostics diagnostics;
  const Block block = parse_syntax(make_source("a.i", lines), diagnostics, read_no_file);
  BoundRegion bound;
  Binding binding{diagnostics, is_lenient};
  region_table().bind(block, bound.region, binding);
  bound.messages = messages(diagnostics);
  return bound;
}

/// A contact definition and what the tables said about it.
struct BoundContact {
  ContactDefinition contact;
  std::string messages;
};

/// Binds the lines of a contact definition; the first is line 2 of "a.i".
inline BoundContact bound_contact(const std::string& lines, bool is_lenient = false) {
  BoundRegion bound = bound_region("begin contact definition\n" + lines + "end\n", is_lenient);
  return {bound.region.contact.value_or(ContactDefinition{}), bound.messages};
}

/// What the tables and name resolution say about the lines of a region. Outside it the functions f and g, the
/// time stepping blocks p1 and p2, the direction up, the axis spin, the rigid body rb, the material steel and
/// the output scheduler often are defined.
inline std::string name_messages(const std::string& lines) {
  using K = NameKind;
  DeckNames names;
  const std::pair<K, const char*> defined[] = {{K::function, "f"},
                                               {K::function, "g"},
                                               {K::time_stepping_block, "p1"},
                                               {K::time_stepping_block, "p2"},
                                               {K::direction, "up"},
                                               {K::axis, "spin"},
                                               {K::rigid_body, "rb"},
                                               {K::material, "steel"},
                                               {K::output_scheduler, "often"}};
  for (const auto& [kind, name] : defined) names.note("", {{{kind, {name, {}}}}, {}, {}});
  Diagnostics diagnostics;
  const Block block = parse_syntax(make_source("a.i", lines), diagnostics, read_no_file);
  Binding binding{diagnostics, false, &names};
  Region region;
  region_table().bind(block, region, binding);
  names.resolve(diagnostics);
  if (region.contact) check_contact(*region.contact, names, diagnostics);
  return messages(diagnostics);
}

/// The same of the lines of a contact definition; the first is line 2 of "a.i".
inline std::string contact_name_messages(const std::string& lines) {
  return name_messages("begin contact definition\n" + lines + "end\n");
}

/// Names with blanks between them.
inline std::string joined_names(const std::vector<DeckName>& names) {
  std::string text;
  for (const DeckName& name : names) text += (text.empty() ? "" : " ") + name.text;
  return text;
}

}  // namespace contactsim
