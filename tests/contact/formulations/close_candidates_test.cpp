// SPDX-License-Identifier: BSD-3-Clause
// Narrow phases that look at close candidates alone find what they find when they look at all.
#include "contact/formulations/close_candidates.hpp"

#include <array>
#include <optional>
#include <set>

#include "contact/formulations/edge_edge/edge_edge_contacts.hpp"
#include "contact/formulations/face_face/face_face_contacts.hpp"
#include "contact/formulations/node_face/node_face_contacts.hpp"
#include "contact/mesh/feature_edges.hpp"
#include "support/catch.hpp"
#include "support/contact_bodies.hpp"
#include "support/random_faces.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

/// Three bodies that are thrown against each other at random: of some elements each, or bricks of one
/// element, whose edges meet more often.
struct ThrownBodies : ContactParts {
  ThrownBodies(double of_size, bool are_bricks, const std::string& lines)
      : ContactParts(made(of_size, are_bricks), general_contact(lines)),
        size(of_size),
        spread(are_bricks ? 0.6 : 1.0),
        start(x) {
    choose_feature_edges(definition.surface_options, model.surfaces.surfaces, kinematics, contact_mesh);
    measure_sharpness(kinematics, contact_mesh);
    // As thick as elements of that size.
    const auto set_thickness = [&](auto& items) {
      for (auto& item : items) item.penalty_properties.thickness = size;
    };
    set_thickness(contact_mesh.faces);
    set_thickness(contact_mesh.surface_nodes);
    set_thickness(contact_mesh.edges);
    search.emplace(contact_mesh, mesh, rules, SearchOptions{}, DashOptions{});
    for (const auto& block : mesh.blocks()) {
      bodies.emplace_back();
      Vector3d middle = Vector3d::Zero();
      for (const NodeIndex node : block.nodes) bodies.back().insert(node.value);
      for (const std::uint32_t node : bodies.back()) middle += start.col(node);
      middle /= static_cast<double>(bodies.back().size());
      for (const std::uint32_t node : bodies.back()) start.col(node) -= middle;
    }
  }
  static MeshBuilder made(double size, bool are_bricks) {
    MeshBuilder b;
    if (are_bricks) {
      b.add_hexes({.id = 1, .size = Vector3d(2, 2, 1) * size});
      b.add_hexes({.id = 2, .size = Vector3d(1, 2, 2) * size, .share_nodes = false});
      return b.add_hexes({.id = 3, .size = Vector3d(1, 1, 2) * size, .share_nodes = false});
    }
    b.add_hexes({.id = 1, .cells = {3, 3, 2}, .size = Vector3d(3, 3, 2) * size});
    b.add_tets({.id = 2, .cells = {2, 2, 2}, .size = Vector3d(2, 2, 2) * size, .share_nodes = false});
    return b.add_hexes(
        {.id = 3, .cells = {4, 2, 2}, .size = Vector3d(0.8, 2, 2) * size, .share_nodes = false});
  }
  /// The second and third body at two sides of the first one, so that they just touch or overlap a little.
  void throw_at_random(Random& random, double warp) {
    const Vector3d way = random_vector(random, 1.0).normalized();
    const std::array<Vector3d, 3> middles{Vector3d::Zero(), spread * uniform(random, 2.2, 3.2) * way,
                                          -spread * uniform(random, 1.8, 2.8) * way};
    for (std::size_t body = 0; body < 3; ++body) {
      const Eigen::Matrix3d turn = random_rotation(random);
      for (const std::uint32_t i : bodies[body])
        x.col(i) = turn * (start.col(i) + size * random_vector(random, warp)) + size * middles[body];
    }
    v.setZero();
    move();
  }
  /// Moves every node as far as it may, and gives it a speed.
  void jump(Random& random, double way, double speed) {
    for (Eigen::Index i = 0; i < x.cols(); ++i) {
      x.col(i) += way * random_vector(random, 1.0).normalized();
      v.col(i) = speed * random_vector(random, 1.0).normalized();
    }
    move();
  }

  double size, spread;  // of elements [length]; of the bodies [1]
  std::optional<ContactSearch> search;
  std::vector<std::set<std::uint32_t>> bodies;  // the nodes of each
  Eigen::Matrix3Xd start;
};

template <class Contacts>
std::vector<ContactPoint> find(Contacts& contacts, ContactStepContext context, CandidateUse candidates) {
  context.candidates = candidates;
  contacts.begin_detection(context);
  std::vector<ContactPoint> points;
  for (std::size_t begin = 0; begin < contacts.n_rows(); begin += rows_per_chunk)
    contacts.detect(context, {begin, std::min(begin + rows_per_chunk, contacts.n_rows())}, points);
  return points;
}

bool are_same(const ContactPoint& a, const ContactPoint& b) {
  return a.first_entity == b.first_entity && a.second_entity == b.second_entity && a.part == b.part &&
         a.gap == b.gap && a.area == b.area && a.force == b.force && a.normal == b.normal &&
         a.first.weights == b.first.weights && a.closing == b.closing;
}

struct Case {
  double size = 1.0, range = 0.0;  ///< of elements [length]; of motion over that [1]
  bool balances = false;
};

/// Throws bodies, finds what is close for a range of motion, moves nodes to its end and compares.
template <class Contacts>
void check_formulation(const Case& of, bool are_bricks, const std::string& lines = "") {
  Random random(17);
  ThrownBodies parts(of.size, are_bricks, (of.balances ? "enforcement = momentum_balance\n" : "") + lines);
  std::size_t n_points = 0, n_close = 0, n_candidates = 0;
  for (int i = 0; i < 60; ++i) {
    parts.throw_at_random(random, i % 2 == 0 ? 0.0 : 0.1);
    Contacts contacts(parts.setup());
    FacePairLists unused;
    parts.search->find_face_pairs(parts.kinematics, parts.motion(1.0), {}, unused);
    contacts.find_candidates(*parts.search, parts.kinematics, parts.motion(1.0));
    contacts.begin_step();
    ContactStepContext context = parts.context();
    context.balances = of.balances;
    context.coming_dt = 1e-3;
    // What touches at the start is known then, however deep.
    contacts.update(context, {0, rows_per_chunk}, find(contacts, context, CandidateUse::all));
    contacts.begin_step();
    context.dt = 1e-3;
    const double motion = of.range * of.size, speed = 0.1 * motion / context.ahead();
    context.close_range = {motion, 2.0 * speed * context.ahead(), parts.rules.largest_reach()};
    find(contacts, context, CandidateUse::renew_close);
    parts.jump(random, motion, speed);
    const auto all = find(contacts, context, CandidateUse::all);
    const auto close = find(contacts, context, CandidateUse::close);
    REQUIRE(all.size() == close.size());
    for (std::size_t k = 0; k < all.size(); ++k) REQUIRE(are_same(all[k], close[k]));
    n_points += all.size();
    n_close += contacts.n_close();
    n_candidates += contacts.n_candidates();
  }
  CHECK(n_points > 10);
  if (of.range <= 0.01) CHECK(20 * n_close < 19 * n_candidates);
}

Case any_case() { return {GENERATE(1.0, 1e-5, 1e4), GENERATE(0.0, 0.01, 0.05, 0.2), GENERATE(true, false)}; }

}  // namespace

TEST_CASE("faces meet no others than close ones within a range of motion", "[contact][close_candidates]") {
  check_formulation<FaceFaceContacts>(any_case(), false);
}

TEST_CASE("nodes meet no other faces than close ones within a range of motion",
          "[contact][close_candidates]") {
  check_formulation<NodeFaceContacts>(any_case(), false, "constraint formulation = node_face\n");
}

TEST_CASE("edges meet no others than close ones within a range of motion", "[contact][close_candidates]") {
  check_formulation<EdgeEdgeContacts>(any_case(), true);
}

TEST_CASE("close candidates are visited in their order, chunk by chunk", "[contact][close_candidates]") {
  const auto lists = list_by_row<FaceIndex, FaceIndex>(600, [](const auto& take) {
    for (std::uint32_t row = 0; row < 500; row += 3) {
      for (std::uint32_t partner = row + 1; partner < row + 6; ++partner)
        take(FaceIndex{row}, FaceIndex{partner});
    }
  });
  CloseCandidates<FaceIndex, FaceIndex> close;
  close.renew_pairs<FacePairBounds::Pairs>(lists, [](const FacePairBounds::Pairs& pairs) {
    std::uint32_t even = 0;
    for (std::size_t lane = 0; lane < pairs.n; ++lane)
      even |= (pairs.second[lane].value % 2 == 0 ? 1U : 0U) << lane;
    return even;
  });
  std::vector<std::size_t> expected, visited;
  for (const FaceIndex row : lists.rows()) {
    for (std::size_t k = lists.first_pair(row); k < lists.end_pair(row); ++k) {
      if (lists.partner(k).value % 2 == 0) expected.push_back(k);
    }
  }
  for (std::size_t begin = 0; begin < 600; begin += rows_per_chunk) {
    close.visit(
        lists, {begin, std::min<std::size_t>(begin + rows_per_chunk, 600)}, CandidateUse::close,
        [](FaceIndex) {},
        [&](FaceIndex row, std::size_t k) {
          CHECK((lists.first_pair(row) <= k && k < lists.end_pair(row)));
          visited.push_back(k);
        });
  }
  CHECK(visited == expected);
  CHECK(close.size() == expected.size());
}
