// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/contact_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>

#include "parser/commands/friction_names.hpp"

namespace contactsim {

namespace {

/// The contact surfaces that the commands of a definition make, and which of them hold nodes only.
class SurfaceNames {
 public:
  SurfaceNames(const std::vector<SurfaceCommand>& commands, const NameUses& uses) : uses_(uses) {
    for (const SurfaceCommand& command : commands) std::visit(*this, command);
  }

  void use(const std::vector<DeckName>& references) {
    for (const DeckName& reference : references) names_.use(reference, uses_.diagnostics());
  }
  bool is_node_set(const DeckName& name) const { return node_sets_.count(fold(name.text)) > 0; }
  bool are_node_sets(const std::vector<DeckName>& names) const {
    return std::all_of(names.begin(), names.end(), [&](const DeckName& name) { return is_node_set(name); });
  }

  void operator()(const ContactSurfaceLine& line) { define(line.name); }
  void operator()(const ContactNodeSetLine& line) {
    define(line.name);
    node_sets_.insert(fold(line.name.text));
  }
  void operator()(const ContactSurfaceBlock& block) {
    define(block.name);
    const bool names_something = block.includes_all_blocks || !block.blocks.empty() ||
                                 !block.side_sets.empty() || !block.assemblies.empty() ||
                                 !block.elements.empty();
    if (!names_something) {
      uses_.add_error(block.name, fmt::format("the contact surface '{}' names nothing", block.name.text),
                      "give it a BLOCK, SURFACE, ASSEMBLY or ELEMENT line, or INCLUDE ALL BLOCKS");
    }
    for (const SurfaceSubset& subset : block.subsets) {
      define({block.name.text + "_" + subset.name.text, subset.name.location});
    }
  }
  /// The surfaces that it makes are named as the blocks of the mesh.
  void operator()(const SkinAllBlocks&) { names_.allow_unknown(); }

 private:
  void define(const DeckName& name) { names_.define(name, uses_.diagnostics()); }

  const NameUses& uses_;
  KnownNames names_{"contact surface"};
  std::unordered_set<std::string> node_sets_;  ///< folded
};

void check_sides(const Interaction& interaction, const NameUses& uses) {
  const bool has_sides = !interaction.side_a.empty() || !interaction.side_b.empty();
  const bool has_both = !interaction.side_a.empty() && !interaction.side_b.empty();
  if (has_sides && !interaction.surfaces.empty()) {
    uses.add_error(interaction.name, "an interaction takes either SURFACES or SIDE A and SIDE B, found both");
  } else if (has_sides && !has_both) {
    uses.add_error(interaction.name, fmt::format("the interaction has SIDE {} and lacks SIDE {}",
                                                 interaction.side_a.empty() ? 'B' : 'A',
                                                 interaction.side_a.empty() ? 'A' : 'B'));
  } else if (!has_sides && interaction.surfaces.empty()) {
    uses.add_error(interaction.name, "the interaction names no contact surfaces",
                   "give it a SURFACES line, or SIDE A and SIDE B");
  }
}

/// A node set meets faces only.
void check_node_sets(const Interaction& interaction, const SurfaceNames& surfaces, const NameUses& uses) {
  for (const DeckName& name : interaction.side_a) {
    if (!surfaces.is_node_set(name)) continue;
    uses.add_error(
        name, fmt::format("the contact node set '{}' cannot be SIDE A, which gives the faces", name.text),
        "put it in SIDE B");
  }
  if (!interaction.surfaces.empty() && surfaces.are_node_sets(interaction.surfaces)) {
    uses.add_error(interaction.surfaces.front(), "an interaction of contact node sets alone",
                   "a node set meets faces only");
  }
}

void check_interaction(const Interaction& interaction, SurfaceNames& surfaces, FrictionNames& frictions,
                       const NameUses& uses) {
  for (const auto* list : {&interaction.surfaces, &interaction.side_a, &interaction.side_b})
    surfaces.use(*list);
  check_sides(interaction, uses);
  check_node_sets(interaction, surfaces, uses);
  uses.use(interaction.periods);
  if (!interaction.pair.friction_model) return;
  frictions.use(*interaction.pair.friction_model);
  if (interaction.friction_coefficient) {
    uses.add_error(*interaction.pair.friction_model,
                   "an interaction takes either FRICTION MODEL or FRICTION COEFFICIENT, found both");
  }
}

}  // namespace

void resolve_contact_names(const ContactDefinition& contact, const NameUses& uses) {
  SurfaceNames surfaces(contact.surface_commands, uses);
  FrictionNames frictions(contact.friction_models, uses);
  KnownNames interactions("interaction");
  for (const Interaction& interaction : contact.interactions) {
    interactions.define(interaction.name, uses.diagnostics());
    check_interaction(interaction, surfaces, frictions, uses);
  }
  if (contact.interaction_defaults) {
    surfaces.use(contact.interaction_defaults->surfaces);
    const auto& friction_model = contact.interaction_defaults->pair.friction_model;
    if (friction_model) frictions.use(*friction_model);
  }
  frictions.check_used();
  for (const SurfaceOptions& options : contact.surface_options) {
    surfaces.use(options.surfaces);
    surfaces.use(options.removed_surfaces);
  }
  uses.use(contact.periods);
}

}  // namespace contactsim
