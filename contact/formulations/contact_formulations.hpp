// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tuple>

#include "contact/formulations/edge_edge/edge_edge_contacts.hpp"
#include "contact/formulations/face_face/face_face_contacts.hpp"
#include "contact/formulations/node_face/node_face_contacts.hpp"
#include "contact/formulations/node_plane/node_plane_contacts.hpp"

namespace contactsim {

/// Some formulations, one object each.
template <ContactFormulation... F>
class FormulationList {
 public:
  explicit FormulationList(const FormulationSetup& setup) : all_{same<F>(setup)...} {}

  /// Calls do_one(formulation) for each, in order.
  template <class Do>
  void for_each(const Do& do_one) {
    std::apply([&](auto&... each) { (do_one(each), ...); }, all_);
  }
  template <class Do>
  void for_each(const Do& do_one) const {
    std::apply([&](const auto&... each) { (do_one(each), ...); }, all_);
  }
  template <class Formulation>
  const Formulation& get() const {
    return std::get<Formulation>(all_);
  }

 private:
  template <class>
  static const FormulationSetup& same(const FormulationSetup& setup) {
    return setup;
  }

  std::tuple<F...> all_;
};

/// All ways in which sides meet, in the order in which their contact points are taken. Faces come first:
/// their search puts the boxes that nodes meet where they are. A new formulation is an entry here.
using ContactFormulations =
    FormulationList<FaceFaceContacts, NodeFaceContacts, EdgeEdgeContacts, NodePlaneContacts>;

}  // namespace contactsim
