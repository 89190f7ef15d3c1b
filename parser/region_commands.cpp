// SPDX-License-Identifier: BSD-3-Clause
#include "parser/region_commands.hpp"

#include "parser/contact_commands.hpp"
#include "parser/contact_surface_commands.hpp"

namespace contactsim {

namespace {

void read_finite_element_model(Arguments& arguments, Region& region) {
  region.finite_element_model = arguments.name();
}

/// Two definitions would each own faces of one mesh, which no rule orders.
void add_contact(Region& region, ContactDefinition contact) {
  if (!region.contact) {
    region.contact = std::move(contact);
    return;
  }
  const std::string first = to_string(region.contact->name.location);
  throw ArgumentError{{Severity::error, "", contact.name.location, 1,
                       "a second CONTACT DEFINITION in one region is not supported",
                       "the first stands at " + first}};
}

}  // namespace

const Table<Region>& region_table() {
  using R = Region;
  static const Table<R> table({
      row<R>("use finite element model", "<name>", read_finite_element_model,
             "The finite element model that the region works on", "required"),
      block<R, ContactDefinition>("contact definition", Naming::optional, contact_definition_table,
                                  add_contact, "Contact surfaces and how they meet"),
      block<R, AnalyticPlane>("analytic object", Naming::required, analytic_object_table, &R::analytic_planes,
                              "A plane that contact surfaces may contain"),
  });
  return table;
}

}  // namespace contactsim
