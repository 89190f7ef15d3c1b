// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/run/contact_debug.hpp"
#include "app/run/contact_energy_watch.hpp"
#include "app/run/run_input.hpp"
#include "contact/mesh/eroded_nodes.hpp"
#include "contact/output/contact_output.hpp"
#include "contact/overlap/interpenetration_watch.hpp"
#include "contact/overlap/untied_parts.hpp"
#include "contact/surfaces/surface_tracker.hpp"
#include "core/output/output_plan.hpp"

namespace contactsim {

/// What deaths change of the contact of a run.
struct RunContactCheckpoint {
  ContactSurfaces surfaces;
  SurfaceTracker living;
  ErodedNodes free_nodes;
  ContactCheckpoint force;
};

/// All that a run has because its region has a contact definition.
class RunContact {
 public:
  /// All must outlive this. Precondition: input.contact is there.
  RunContact(const RunInput& input, const Model& model, Ranks& ranks);

  ContactForce& force() { return force_; }
  const ContactForce& force() const { return force_; }
  const ContactModel& model() const { return contact_; }

  /// From now on surfaces follow deaths.
  ///   faces   must outlive this
  ///   erodes           [n_elements] 1 of elements whose nodes leave contact with them
  ///   makes_new_edges  whether edges that deaths expose become edges of contact
  void follow_deaths(const FaceGroups& faces, std::vector<std::uint8_t> erodes, bool makes_new_edges);
  /// Takes deaths over into the surfaces. Returns what has changed in each.
  ///   dead   elements that have just died, ascending
  ///   alive  [n_elements] 0 of all dead elements
  SurfaceChanges update_for_deaths(const State& state, std::span<const ElementIndex> dead,
                                   std::span<const std::uint8_t> alive);
  /// What that changes, as it is between two load steps. Precondition: surfaces follow deaths.
  RunContactCheckpoint checkpoint(const State& state);
  /// Goes back to it.
  ///   state  that of then
  void restore(const State& state, const RunContactCheckpoint& checkpoint);
  std::size_t n_eroded_nodes() const { return free_nodes_ ? free_nodes_->n_nodes() : 0; }

  /// What of each pair is too far apart to be held.
  IndexedSpan<PairIndex, const UntiedPart> untied() const { return untied_; }

  /// Adds the contact variables, a side set contact_<surface> per surface, of surfaces of nodes a node set,
  /// and the node set contact_untied of nodes that no tie reaches; a number follows where the mesh has a set
  /// of the name.
  void add_to(OutputSettings& settings);

  /// The files that BEGIN DEBUG asks for, and writing them with the last state. Throws FileError.
  std::vector<std::string> paths() const { return debug_.paths(); }
  void write_debug_files();

  /// Gives the names of these files an end.
  void add_suffix(const std::string& suffix);

  /// To be called after every step: looks from time to time whether bodies lie in each other.
  ///   complete_coordinates  called before it reads those of more than contact nodes
  void watch(const State& state, const std::function<void()>& complete_coordinates);
  IndexedSpan<PairIndex, const Interpenetration> interpenetrations() const { return watch_.all(); }
  /// Saves or restores what contact remembers.
  void archive(const State& state, StateArchive& saved);

  /// To be called once the first forces are known: warns of ties that tie nothing, of overlaps and of lines
  /// without effect.
  void warn_of_start(Diagnostics& warnings) const;
  /// To be called at the end: warns of energy that nothing had put into contact, and names the pair; of pairs
  /// whose contact ended though it was deep; of those that have penetrated by more than a tenth of their
  /// thickness; of bodies that lie in each other or have passed through; and of those that have slid off
  /// their faces of the start, or lost them to deaths.
  void warn_of_end(const State& state, Diagnostics& warnings);
  /// What pairs without springs gave out to come out of overlaps of the mesh, or of what the procedure before
  /// had pressed [energy].
  double given_out_by_overlaps() const { return contactsim::given_out_by_overlaps(force_, begins_pressed_); }
  /// To be called after every step: throws SolveError naming the pair when contact has for some steps given
  /// out more energy from nowhere than all that was put into the model; remembers the most.
  void stop_at_runaway(const State& state) {
    energy_.step(force_, given_out_by_overlaps(), contact_, model_, state);
  }

 private:
  ContactMoment moment_of(const State& state, const ContactKinematics& kinematics) const;

  const RunInput& input_;
  const Model& model_;
  const Mesh& mesh_;
  ContactModel contact_;                              // of the living elements
  UntiedParts untied_;                                // of the start
  IndexedVector<PairIndex, double> offset_overlaps_;  // made by offsets at the start [length]
  ContactForce force_;
  bool begins_pressed_;  // by contact of the procedure before
  ContactOutput output_;
  InterpenetrationWatch watch_;
  std::span<const std::uint8_t> alive_;  // [n_elements] empty while all live
  ContactDebugFiles debug_;
  std::optional<SurfaceTracker> living_;  // only when elements may die
  std::optional<ErodedNodes> free_nodes_;
  bool makes_new_edges_ = true;
  ContactEnergyWatch energy_;
};

}  // namespace contactsim
