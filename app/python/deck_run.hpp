// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/run/simulation.hpp"
#include "contact/mesh/contact_model.hpp"
#include "contact/output/surface_summary.hpp"
#include "core/base/diagnostics.hpp"
#include "core/definition/simulation.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// What a run from Python is made from.
struct DeckRunRequest {
  std::string deck;
  std::optional<std::string> mesh;       ///< in place of the deck's
  std::vector<std::string> definitions;  ///< "name=value" for Aprepro
  bool is_lenient = false;               ///< refused and unknown commands are warnings
  std::optional<std::string> results;    ///< in place of the deck's results file
};

/// A deck with its mesh and contact surfaces, and the run that begins when it is asked to move. Prints
/// nothing.
class DeckRun {
 public:
  /// Reads deck and mesh and resolves the contact surfaces. Throws DeckError with all problems, FileError.
  explicit DeckRun(const DeckRunRequest& request);

  const Mesh& mesh() const { return mesh_; }
  const ContactModel* contact() const { return contact_ ? &*contact_ : nullptr; }  ///< null without contact
  /// Everything that was found so far.
  const Diagnostics& diagnostics() const { return diagnostics_; }

  /// Removes overlaps where the deck wants it, prepares the run and completes the state of the start. Nothing
  /// if it has begun. Throws DeckError, FileError, SolveError.
  void begin();
  /// Moves the run by a step; the first one begins it. Throws SolveError when the motion cannot go on, after
  /// which the last state is written and the run is over; FileError.
  void step();
  /// Whether it has begun and its end has come; what it wrote is complete then.
  bool is_over() const { return is_finished_; }
  /// Ends the run where it is and completes its files. Nothing if it has not begun or is over. Throws
  /// FileError.
  void finish();
  /// The run, once it has begun. Throws DeckError else.
  const Simulation& simulation() const;

 private:
  void end_if_due();

  Diagnostics diagnostics_;
  std::optional<std::string> results_;
  SimulationDefinition definition_;
  Procedure procedure_;
  Region region_;
  Mesh mesh_;
  std::optional<ContactModel> contact_;
  std::vector<StartOverlap> overlaps_;
  std::unique_ptr<Simulation> simulation_;
  bool is_finished_ = false;
};

}  // namespace contactsim
