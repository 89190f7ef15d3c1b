// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace contactsim {

/// What a name of the deck may stand for.
enum class NameKind : std::uint8_t {
  point,
  direction,
  axis,
  coordinate_system,
  function,
  material,
  model,
  section,
  rigid_body,
  finite_element_model,
  output_scheduler,
  procedure,
  region,
  time_stepping_block,
  analytic_object,
  user_variable,
  contact_definition,
  contact_surface,
  friction_model,
  interaction,
  surface_smoothing,
  // parts of the mesh, which the deck does not define
  block,
  node_set,
  side_set,
  assembly
};

/// When what a definition says counts: an unused one is not judged as if it were used.
enum class Counts : std::uint8_t {
  always,
  when_used,              ///< what is missing in it and the names in it
  even_reading_when_used  ///< its lines that cannot be read too: a warning when nothing uses it
};

/// What is so of all names of a kind.
struct NameKindText {
  NameKind kind;
  std::string_view word;              ///< as messages and `explain` say it: "coordinate system"
  std::optional<NameKind> home = {};  ///< the definition inside which the names are known; absent: the deck
  std::string_view owner = {};        ///< what messages call the home, {} its name; "": they do not say it
  Counts counts = Counts::always;
  std::vector<std::string_view> built_in = {};  ///< names that need no definition
  bool redefines_built_in = false;              ///< whether the deck may define the built-in ones itself
  bool is_in_mesh = false;                      ///< known when the mesh is read
  /// A kind that is taken for this one by mistake, and what to say then.
  struct Mistake {
    NameKind kind;
    std::string_view hint;
  };
  std::optional<Mistake> mistake = {};
  std::string_view made_by = {};  ///< the line that makes one, for decks that have none
};

const NameKindText& text_of(NameKind kind);

}  // namespace contactsim
