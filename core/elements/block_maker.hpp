// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "core/definition/declarations.hpp"
#include "core/definition/section.hpp"
#include "core/elements/model_block.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

struct MaterialModel;

/// Builds the blocks of a model, one after another, and collects what is wrong with them: blocks without
/// material, with one that is not supported, with elements or formulations that are not, with elements of no
/// volume.
class BlockMaker {
 public:
  /// All must outlive the maker.
  BlockMaker(const SimulationDefinition& definition, const FiniteElementModel& model, const Mesh& mesh,
             Diagnostics& diagnostics)
      : definition_(definition), model_(model), mesh_(mesh), diagnostics_(diagnostics) {}

  /// Adds a block of the mesh, unless an error was added.
  ///   index  position in the mesh
  ///   names  that the deck may call it by
  void add(std::uint32_t index, std::span<const std::string> names, std::vector<ModelBlock>& blocks);

 private:
  using Made = std::optional<ModelBlock>;

  /// What a block names; the model is null where there is none, which errors of the deck tell.
  struct BlockMaterial {
    const MaterialDefinition* material = nullptr;
    const MaterialModel* model = nullptr;
  };
  BlockMaterial find_material(const BlockParameters& parameters);
  Made make(Family family, std::uint32_t index, const BlockParameters& parameters);
  Made make_lines(std::uint32_t index, const BlockParameters& parameters);
  Made make_solids(std::uint32_t index, const BlockParameters& parameters);
  Made make_shells(std::uint32_t index, const BlockParameters& parameters);
  Made make_cohesive(std::uint32_t index, const BlockParameters& parameters);
  Made make_shells(std::uint32_t index, const BlockParameters& parameters, const ShellSection& section,
                   const ElementFormulation* element);
  const ShellSection* find_shell_section(std::uint32_t index, const SectionDefinition* section);
  const SolidSection* find_solid_section(std::uint32_t index, const BlockParameters& parameters);
  const SolidSection* take_lagrange_section(const Topology& shape, const SectionDefinition& section);
  const ElementFormulation* find_formulation(std::uint32_t index, const ShellSection& section,
                                             const BlockParameters& parameters);
  const ElementFormulation* find_formulation(std::uint32_t index, const MembraneSection& section,
                                             const BlockParameters& parameters);
  const ElementFormulation* find_formulation(const Topology& shape, const SolidSection& solid,
                                             const BlockParameters& parameters);
  std::optional<ElementProperties> make_properties(const BlockParameters& parameters,
                                                   const SolidSection* section);
  void refuse_shape(const Topology& shape, const BlockParameters& parameters, const char* known);
  void check_options(const SolidSection& solid);
  bool give_directions(const BlockParameters& parameters, const SectionDefinition* section,
                       ModelBlock& block);
  void add_error(const DeckLocation& location, std::string text, std::string hint);

  const SimulationDefinition& definition_;
  const FiniteElementModel& model_;
  const Mesh& mesh_;
  Diagnostics& diagnostics_;
  SolidSection default_section_, lagrange_section_;
  ShellSection default_shell_section_;
  DeckLocation section_location_;  ///< of the block at hand, of its parameters when it has none
  std::string block_name_;
  std::int64_t block_id_ = 0;
};

}  // namespace contactsim
