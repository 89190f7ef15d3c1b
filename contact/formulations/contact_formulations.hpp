// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tuple>
#include <type_traits>

#include "contact/formulations/bonded/bonded_contacts.hpp"
#include "contact/formulations/edge_edge/edge_edge_contacts.hpp"
#include "contact/formulations/face_face/face_face_contacts.hpp"
#include "contact/formulations/node_face/node_face_contacts.hpp"
#include "contact/formulations/node_plane/node_plane_contacts.hpp"
#include "contact/formulations/tied/tied_contacts.hpp"

namespace contactsim {

/// Some formulations, one object each.
template <ContactFormulation... F>
class FormulationList {
 public:
  explicit FormulationList(const FormulationSetup& setup) : all_{make<F>(setup)...} {}

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
  template <class One>
  static One make(const FormulationSetup& setup) {
    if constexpr (std::constructible_from<One, const FormulationSetup&>) {
      return One(setup);
    } else {
      return {};
    }
  }

  std::tuple<F...> all_;
};

/// Calls do_one(formulation) for those of a list that find contact points, or constraints, in order.
template <class List, class Do>
void for_each_of_points(List& formulations, const Do& do_one) {
  formulations.for_each([&](auto& formulation) {
    if constexpr (PointFormulation<std::remove_cvref_t<decltype(formulation)>>) do_one(formulation);
  });
}
template <class List, class Do>
void for_each_of_constraints(List& formulations, const Do& do_one) {
  formulations.for_each([&](auto& formulation) {
    if constexpr (InterfaceFormulation<std::remove_cvref_t<decltype(formulation)>>) do_one(formulation);
  });
}

/// All ways in which sides meet or are held, in the order in which their contact points and forces are taken.
/// Faces come first: their search puts the boxes that nodes meet where they are. A new formulation is an
/// entry here.
using ContactFormulations = FormulationList<FaceFaceContacts, NodeFaceContacts, EdgeEdgeContacts,
                                            NodePlaneContacts, TiedContacts, BondedContacts>;

}  // namespace contactsim
