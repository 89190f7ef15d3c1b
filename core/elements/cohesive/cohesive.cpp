// SPDX-License-Identifier: BSD-3-Clause
// Cohesive elements of eight and six nodes: two faces, of nodes 1 to 4 (or 3) and of the others.
#include <algorithm>

#include "core/elements/cohesive/cohesive_elements.hpp"
#include "core/elements/cohesive/cohesive_pairs.hpp"
#include "core/elements/element_batches.hpp"

namespace contactsim {

namespace {

using Vector = std::array<Lanes, 3>;

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The face halfway between the two faces of an element.
template <std::size_t n>
struct MidFace {
  Vector p, q;    ///< diagonals, or edges of a triangle: twice the area is p x q [length]
  Vector normal;  ///< unit
  Lanes area;     ///< [length^2]

  explicit MidFace(const NodeVectors<2 * n>& x) {
    const auto at = [&x](std::size_t i, std::size_t a) -> Lanes { return 0.5 * (x[i][a] + x[i][a + n]); };
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] = n == 4 ? at(i, 2) - at(i, 0) : at(i, 1) - at(i, 0);
      q[i] = n == 4 ? at(i, n - 1) - at(i, 1) : at(i, 2) - at(i, 0);
    }
    normal = cross(p, q);
    const Lanes size = dot(normal, normal).sqrt();
    for (Lanes& component : normal) component /= size;
    area = 0.5 * size;
  }

  /// The derivatives of the normal times w by the coordinates of the corners. Precondition: w lies in the
  /// face.
  std::array<Vector, n> turn(const Vector& w) const {
    Vector by_p = cross(q, w), by_q = cross(w, p);
    for (std::size_t i = 0; i < 3; ++i) {
      by_p[i] *= 0.5 / area;
      by_q[i] *= 0.5 / area;
    }
    std::array<Vector, n> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      corners[0][i] = n == 4 ? Lanes(-by_p[i]) : Lanes(-by_p[i] - by_q[i]);
      corners[1][i] = n == 4 ? Lanes(-by_q[i]) : by_p[i];
      corners[2][i] = n == 4 ? by_p[i] : by_q[i];
      if constexpr (n == 4) corners[3][i] = by_q[i];
    }
    return corners;
  }
};

/// Tractions at pairs of opposite nodes, each over its share A_a of the area in the mesh. With the vector d
/// from node to node and the unit normal n of the face halfway, opening is n . d less the thickness, sliding
/// the length of what of d lies in the face. The forces are the derivatives of the law's potential by all
/// coordinates, also through n: they have no resultant and no moment. When all pairs have failed nothing is
/// left, not even in compression: contact takes over.
template <Shape its_shape, std::size_t n>
struct Cohesive {
  static constexpr Shape shape = its_shape;
  static constexpr std::string_view formulation = "cohesive";
  static constexpr std::size_t n_pairs = n, n_nodes = 2 * n, n_points = 1, n_own = n * cohesive::n_numbers;

  static Lanes volume(const NodeVectors<n_nodes>& x) {
    const MidFace<n> face(x);
    Lanes height = Lanes::Zero();
    for (std::size_t a = 0; a < n; ++a) height += dot(face.normal, way(x, a));
    return face.area * height * (1.0 / n);
  }

  ///   area, thickness  [n] of the pairs, as CohesiveParts
  ///   own              [n x n_numbers] of the pairs
  static void advance(const TractionLaw& law, const Lanes* area, const Lanes* thickness,
                      const NodeVectors<n_nodes>& x, std::span<Lanes> own, SolidStep<n_nodes>& step) {
    const MidFace<n> face(x);
    LaneMask is_gone(true);
    for (std::size_t a = 0; a < n; ++a) {
      const Vector d = way(x, a);
      const Lanes along = dot(face.normal, d);
      cohesive::stretch(law, along - thickness[a], norm(in_face(d, along, face)), pair(own, a));
      is_gone = is_gone && cohesive::damage(law, pair(own, a)) >= 1.0;
    }
    step.stress_work.setZero();
    Vector turning{Lanes::Zero(), Lanes::Zero(), Lanes::Zero()};
    for (std::size_t a = 0; a < n; ++a) {
      const Vector d = way(x, a);
      const Lanes along = dot(face.normal, d);
      const Vector across = in_face(d, along, face);
      step.stress_work += area[a] * cohesive::pull(law, is_gone, pair(own, a));
      const Lanes& traction = pair(own, a)[cohesive::normal];
      const Lanes slope = cohesive::tangential_slope(law, pair(own, a));
      for (std::size_t i = 0; i < 3; ++i) {
        step.force[i][a] = area[a] * (traction * face.normal[i] + slope * across[i]);
        step.force[i][a + n] = -step.force[i][a];
        turning[i] += area[a] * (traction - slope * along) * across[i];
      }
    }
    const std::array<Vector, n> by_corner = face.turn(turning);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t a = 0; a < n_nodes; ++a) step.force[i][a] -= 0.5 * by_corner[a % n][i];
    }
  }

 private:
  static Vector way(const NodeVectors<n_nodes>& x, std::size_t a) {
    return {x[0][a + n] - x[0][a], x[1][a + n] - x[1][a], x[2][a + n] - x[2][a]};
  }
  static Vector in_face(const Vector& d, const Lanes& along, const MidFace<n>& face) {
    return {d[0] - along * face.normal[0], d[1] - along * face.normal[1], d[2] - along * face.normal[2]};
  }
  static Lanes norm(const Vector& v) { return dot(v, v).sqrt(); }
  static std::span<Lanes> pair(std::span<Lanes> own, std::size_t a) {
    return own.subspan(a * cohesive::n_numbers, cohesive::n_numbers);
  }
};

template <class Element>
ChunkStep advance_cohesive(const ModelBlock& block, const BatchChunk& chunk, const Motion& motion,
                           ModelBlockState& state) {
  constexpr std::size_t n = Element::n_nodes;
  const batches::ChunkVectors vectors(block.nodes_of(chunk), motion.coordinates);
  NodeVector* forces = state.forces.data() + chunk.first_node;
  std::fill_n(forces, chunk.n_nodes, NodeVector::Zero());
  ChunkStep sums = batches::no_step();
  ElementDeathMask mask(block, state);
  for (std::size_t i = chunk.first_batch; i < chunk.first_batch + chunk.n_batches; ++i) {
    if (!mask.begin(i)) continue;
    const ChunkNode* nodes = block.nodes.data() + i * n * n_lanes;
    NodeVectors<n> at;
    vectors.gather(nodes, at);
    mask.place(at);
    const std::span<Lanes> values = state.batch(block.layout, i);
    mask.keep(values);
    SolidStep<n> step;
    const CohesiveParts& parts = block.cohesive;
    Element::advance(parts.law, &parts.area[i * Element::n_pairs], &parts.thickness[i * Element::n_pairs], at,
                     values.first(block.layout.energy()).last(Element::n_own), step);
    step.volume.setConstant(1.0);  // those without are no worse
    step.stable_step = parts.stable_step[i];
    step.hourglass_work = step.viscous_work = Lanes::Zero();
    batches::apply_mask(mask, values, step);
    values.back() += step.stress_work;
    const auto n_used = std::min<std::size_t>(n_lanes, block.n_elements - i * n_lanes);
    batches::scatter_add(step.force, nodes, n_used, forces);
    batches::add_lanes(step, i * n_lanes, n_used, sums);
  }
  return sums;
}

template <class Element>
constexpr ElementFormulation cohesive_element() {
  ElementFormulation row{
      Element::shape, Element::formulation,       Element::n_nodes,          Element::n_points,
      Element::n_own, &batches::volumes<Element>, &advance_cohesive<Element>};
  row.step_rule = StepRule::stiffness;
  return row;
}

}  // namespace

const ElementFormulation cohesive8_pairs = cohesive_element<Cohesive<Shape::cohesive8, 4>>();
const ElementFormulation cohesive6_pairs = cohesive_element<Cohesive<Shape::cohesive6, 3>>();

}  // namespace contactsim
