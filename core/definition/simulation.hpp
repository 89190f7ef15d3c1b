// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/definition/finite_element_model.hpp"
#include "core/definition/function.hpp"
#include "core/definition/geometry.hpp"
#include "core/definition/material.hpp"
#include "core/definition/output_schedule.hpp"
#include "core/definition/procedure.hpp"
#include "core/definition/rigid_body.hpp"
#include "core/definition/section.hpp"

namespace contactsim {

/// What a deck file holds.
enum class DeckForm {
  full,                ///< one BEGIN SIERRA block
  contact_definition,  ///< one BEGIN CONTACT DEFINITION block, perhaps beside Sierra-scope definitions
  contact_commands     ///< the commands of a contact definition without its BEGIN and END
};

/// How the run starts from an earlier one: RESTART and RESTART TIME at Sierra scope.
struct RestartRequest {
  bool is_automatic = false;   ///< RESTART = AUTOMATIC: from the latest state there is
  std::optional<double> time;  ///< RESTART TIME: from the state at this time [time]
};

/// A whole deck: the definition tree. In a deck of contact alone everything stands in one procedure and one
/// region, both without a name.
struct SimulationDefinition {
  DeckForm form = DeckForm::full;
  std::string deck_base;  ///< the deck's file name without folder and extension
  std::string text;       ///< the deck after Aprepro
  DeckName name;          ///< the words after BEGIN SIERRA
  std::string title;
  RestartRequest restart;
  std::vector<PointDefinition> points;
  std::vector<DirectionDefinition> directions;
  std::vector<AxisDefinition> axes;
  std::vector<CoordinateSystemDefinition> coordinate_systems;
  std::vector<FunctionDefinition> functions;
  std::vector<MaterialDefinition> materials;
  std::vector<SectionDefinition> sections;
  std::vector<RigidBodyDefinition> rigid_bodies;
  std::vector<FiniteElementModel> finite_element_models;
  std::vector<OutputScheduler> output_schedulers;
  std::vector<Procedure> procedures;
};

/// The definition with the name in a list whose elements have a member `DeckName name`, compared without
/// case; null when there is none.
template <class T>
const T* find_by_name(const std::vector<T>& list, std::string_view name) {
  const std::string wanted = fold(name);
  for (const T& item : list) {
    if (fold(item.name.text) == wanted) return &item;
  }
  return nullptr;
}

/// The regions that have a contact definition, in deck order.
std::vector<const Region*> regions_with_contact(const SimulationDefinition& simulation);

/// The model that the region works on: the one it names, else the only one there is; null when there is none.
const FiniteElementModel* find_finite_element_model(const SimulationDefinition& simulation,
                                                    const Region& region);

/// The parameters of a block of the mesh; null when the model has none for it. A PARAMETERS FOR BLOCK that
/// names the block goes before one that includes all blocks; the first in the deck wins.
///   names  what the block may be called: its name, its aliases, the assemblies that it is part of
const BlockParameters* find_block_parameters(const FiniteElementModel& model,
                                             std::span<const std::string> names);
/// The same for a block with one name.
const BlockParameters* find_block_parameters(const FiniteElementModel& model, const std::string& name);

/// The section that the block parameters name; null when they name none: the default solid section.
const SectionDefinition* find_section(const SimulationDefinition& simulation,
                                      const BlockParameters& parameters);

/// A file name of the deck with %B replaced by the deck's base name.
std::string expand_file_name(const SimulationDefinition& simulation, std::string_view name);

/// The mesh file of a region: DATABASE NAME of its model, by default <deck base>.g.
/// Source: Aria 5.22, DATABASE NAME.
std::string mesh_path(const SimulationDefinition& simulation, const Region& region);

}  // namespace contactsim
