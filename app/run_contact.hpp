// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "app/contact_debug.hpp"
#include "app/transient.hpp"
#include "contact/contact_output.hpp"
#include "io/outputs.hpp"

namespace contactsim {

/// All that a run has because its region has a contact definition.
class RunContact {
 public:
  /// Both must outlive this. Precondition: input.contact is there.
  RunContact(const RunInput& input, const Model& model);

  ContactForce& force() { return force_; }

  /// Adds the contact variables and a side set contact_<surface> per surface.
  void add_to(OutputSettings& settings);

  /// The files that BEGIN DEBUG asks for, and writing them with the last state. Throws FileError.
  std::vector<std::string> paths() const { return debug_.paths(); }
  void write_debug_files(const State& state);

  /// Gives the names of these files an end.
  void add_suffix(const std::string& suffix);

  /// What the log says once the first forces are known. Ties that tie nothing are a warning.
  std::string start_report(Diagnostics& warnings) const;
  /// Warns when contact has given out energy that nothing had put into it.
  void warn_of_energy(const Energies& energies, Diagnostics& warnings) const;
  /// What the pairs did and the search took, for the log.
  std::string report() const;

 private:
  const ContactModel& contact_;
  const Mesh& mesh_;
  ContactForce force_;
  ContactOutput output_;
  ContactDebugFiles debug_;
};

}  // namespace contactsim
