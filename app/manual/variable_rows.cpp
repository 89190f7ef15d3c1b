// SPDX-License-Identifier: BSD-3-Clause
#include "app/manual/variable_rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

#include "contact/output/contact_output.hpp"
#include "core/materials/material_table.hpp"
#include "core/output/output_table.hpp"

namespace contactsim {

namespace {

struct Listing {
  std::vector<VariableText> rows;

  void add(std::string_view location, std::string_view name, int n_components, std::string_view help) {
    rows.push_back({std::string(location), std::string(name), n_components, std::string(help)});
  }

  void add(std::span<const OutputRow> added) {
    for (const OutputRow& row : added) add(to_string(row.location), row.name, row.n_components(), row.help);
  }

  void add(std::span<const OutputGroup> groups) {
    for (const OutputGroup& group : groups) {
      add(to_string(group.location), group.name, 0,
          fmt::format("{}: all of {}", group.help, fmt::join(group.members, ", ")));
    }
  }

  /// What materials keep; laws that mean the same by a variable share its line.
  void add(std::span<const LawKind* const> laws) {
    std::set<std::pair<std::string_view, std::string_view>> known;
    for (const LawKind* law : laws) {
      for (const StateVariable& variable : law->variables) {
        if (known.emplace(variable.name, variable.help).second)
          add("element", variable.name, static_cast<int>(variable.n_components), variable.help);
      }
    }
  }
};

}  // namespace

std::vector<VariableText> output_variables() {
  Listing listing;
  listing.add(global_output_rows());
  for (const ContactTotalRow& row : contact_total_rows()) {
    const char* of_sides = row.is_of_pairs ? "_<surface>" : "_<surface or side set>";
    for (const char* of : {of_sides, "_<first>_<second>"})
      listing.add("global", std::string(row.name) + of, component_count(row.shape), row.help);
  }
  listing.add(nodal_output_rows());
  for (const ContactNodeRow& row : contact_node_rows())
    listing.add("nodal", row.name, row.n_components(), row.help);
  listing.add(contact_output_names().groups);
  listing.add(element_output_rows());
  listing.add(material_laws());
  return listing.rows;
}

}  // namespace contactsim
