// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/names.hpp"

namespace contactsim {

/// ALIAS <name on the file> AS <further name>.
struct MeshAlias {
  DeckName mesh_name;
  DeckName alias;
};

enum class EffectiveModuliModel : std::uint8_t { elastic, pronto, presto, current };

/// BEGIN PARAMETERS FOR BLOCK <names>.
struct BlockParameters {
  DeckLocation location;        ///< of BEGIN
  std::vector<DeckName> names;  ///< blocks or assemblies of blocks
  bool includes_all_blocks = false;
  std::vector<DeckName> removed_blocks;
  std::optional<DeckName> material;
  std::optional<DeckName> model;          ///< a model of the material
  std::optional<DeckName> section;        ///< absent: the default solid section
  double linear_bulk_viscosity = 0.06;    ///< >= 0 [1]
  double quadratic_bulk_viscosity = 1.2;  ///< >= 0 [1]
  double hourglass_stiffness = 0.05;      ///< >= 0 [1]
  double hourglass_viscosity = 0.0;       ///< >= 0 [1]
  EffectiveModuliModel effective_moduli_model = EffectiveModuliModel::elastic;
};

/// BEGIN FINITE ELEMENT MODEL <name>.
struct FiniteElementModel {
  DeckName name;
  std::optional<DeckName> database;  ///< file name as in the deck, %B replaced; absent: <deck base>.g
  std::vector<MeshAlias> aliases;
  std::vector<BlockParameters> block_parameters;  ///< in deck order
  std::vector<DeckName> omitted;  ///< OMIT BLOCK, OMIT ASSEMBLY: blocks, or assemblies of them
};

}  // namespace contactsim
