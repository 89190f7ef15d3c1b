// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/material_commands.hpp"

#include "parser/commands/row_lists.hpp"

namespace contactsim {

namespace {

using M = MaterialDefinition;

constexpr const char* no_heat = "temperature has no effect on materials";

std::vector<Row<M>> property_rows() {
  return {
      row("density", read::positive, &M::density, "Mass per volume [mass/length^3]"),
      ignored<M>("biots coefficient", "= <real>", "there is no pore pressure"),
      ignored<M>("thermal strain function", "= <function>", no_heat),
      ignored<M>("thermal strain x function", "= <function>", no_heat),
      ignored<M>("thermal strain y function", "= <function>", no_heat),
      ignored<M>("thermal strain z function", "= <function>", no_heat),
      ignored<M>("thermal engineering strain function", "= <function>", no_heat),
      ignored<M>("thermal log strain function", "= <function>", no_heat),
      ignored<M>("thermal conductivity", "= <words>", no_heat),
      ignored<M>("specific heat", "= <words>", no_heat),
  };
}

}  // namespace

const Table<MaterialDefinition>& material_table() {
  static const Table<M> table(joined({property_rows(), material_model_rows()}));
  return table;
}

}  // namespace contactsim
