// SPDX-License-Identifier: BSD-3-Clause
#include <memory>

#include "contact/search/broad_phase.hpp"
#include "contact_scenes.hpp"
#include "core/mesh/skin.hpp"
#include "kernel.hpp"
#include "search_scene.hpp"

namespace contactsim::bench {

namespace {

/// All that contact keeps is counted as gone through once a step: it reads and writes some of it and leaves
/// some of it alone.
template <ConstraintFormulation formulation, Enforcement enforcement, bool touches>
Kernel spheres(std::size_t n_faces) {
  const auto scene = std::make_shared<SphereScene>(static_cast<std::int64_t>(n_faces), touches,
                                                   PairSettings{formulation, enforcement});
  return {scene->n_nodes(), scene->memory(), [scene] { scene->move(); }, [scene] { scene->step(); }};
}

/// Nodes of a tree over n boxes [bytes].
double tree_bytes(std::size_t n) { return static_cast<double>((2 * n - 1) * sizeof(BoxNode)); }

/// Boxes read, leaves and parents read and written.
double refit_bytes(std::size_t n) { return static_cast<double>(n * sizeof(Box)) + 2.0 * tree_bytes(n); }

struct Search {
  SearchScene scene;
  BroadPhase nodes, faces;
  PairTable lists;

  void refit() {
    [[maybe_unused]] const bool bad = nodes.update(scene.nodes()) || faces.update(scene.faces());
    assert(!bad);
  }
  void find() {
    refit();
    nodes.find_pairs(
        faces, [](std::uint32_t, std::uint32_t) { return true; }, lists);
  }
};

/// Both refits, all nodes of both trees read, pairs written, read and put into their rows.
Kernel broad_phase(std::size_t n_faces) {
  const auto search = std::make_shared<Search>(SearchScene(static_cast<std::int64_t>(n_faces)));
  search->find();
  const std::size_t n_nodes = search->scene.nodes().size(), n = search->scene.faces().size();
  const double n_bytes = refit_bytes(n_nodes) + refit_bytes(n) + tree_bytes(n_nodes) + tree_bytes(n) +
                         20.0 * static_cast<double>(search->lists.partners.size());
  return {static_cast<double>(n), n_bytes, [search] { search->scene.move(); }, [search] { search->find(); }};
}

Kernel broad_phase_refit(std::size_t n_faces) {
  const auto search = std::make_shared<Search>(SearchScene(static_cast<std::int64_t>(n_faces)));
  search->refit();
  const std::size_t n_nodes = search->scene.nodes().size(), n = search->scene.faces().size();
  return {static_cast<double>(n), refit_bytes(n_nodes) + refit_bytes(n), {}, [search] { search->refit(); }};
}

/// The nodes of the elements read once.
Kernel skin(std::size_t n) {
  const auto mesh = std::make_shared<Mesh>(make_hex_cube(static_cast<std::uint32_t>(n)));
  const auto n_elements = static_cast<double>(mesh->n_elements());
  const auto present = std::make_shared<std::vector<std::uint8_t>>(mesh->n_elements(), 1);
  return {n_elements, 8.0 * sizeof(NodeIndex) * n_elements, {}, [=] {
            [[maybe_unused]] const Skin found = make_skin(*mesh, *present);
            assert(found.exterior.size() == 6 * n * n);
          }};
}

constexpr auto face_face = ConstraintFormulation::face_face, node_face = ConstraintFormulation::node_face;
constexpr auto balance = Enforcement::momentum_balance, penalty = Enforcement::penalty;

constexpr KernelRow rows[] = {
    {"spheres_apart", "node", Reference::flops, 10000, 600, spheres<face_face, balance, false>},
    {"spheres_apart_node_face", "node", Reference::flops, 10000, 600, spheres<node_face, balance, false>},
    {"spheres_touch", "node", Reference::flops, 10000, 54, spheres<face_face, balance, true>},
    {"spheres_touch_node_face", "node", Reference::flops, 10000, 54, spheres<node_face, balance, true>},
    {"spheres_touch_penalty", "node", Reference::flops, 10000, 150, spheres<face_face, penalty, true>},
    {"spheres_touch_node_face_penalty", "node", Reference::flops, 10000, 150,
     spheres<node_face, penalty, true>},
    {"broad_phase", "face", Reference::flops, 100000, 0, broad_phase},
    {"broad_phase_refit", "face", Reference::memory, 1000000, 600, broad_phase_refit},
    {"skin", "element", Reference::memory, 100, 0, skin},
};

}  // namespace

std::span<const KernelRow> contact_kernels() { return rows; }

}  // namespace contactsim::bench
