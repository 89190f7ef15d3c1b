// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "parser/commands/region_commands.hpp"
#include "parser/commands/region_names.hpp"
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

/// What name resolution says about the lines of a region. Outside it the functions f and g, the time stepping
/// blocks p1 and p2, the direction up, the axis spin, the rigid body rb, the material steel and the output
/// scheduler often are defined.
inline std::string name_messages(const std::string& lines) {
  Diagnostics diagnostics;
  OutsideNames outside;
  for (const char* name : {"f", "g"}) outside.functions.define({name, {}}, diagnostics);
  for (const char* name : {"p1", "p2"}) outside.periods.define({name, {}}, diagnostics);
  outside.directions.define({"up", {}}, diagnostics);
  outside.axes.define({"spin", {}}, diagnostics);
  outside.rigid_bodies.define({"rb", {}}, diagnostics);
  outside.materials.define({"steel", {}}, diagnostics);
  outside.output_schedulers.define({"often", {}}, diagnostics);
  const BoundRegion bound = bound_region(lines);
  resolve_region_names(bound.region, outside, diagnostics);
  return bound.messages + messages(diagnostics);
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
