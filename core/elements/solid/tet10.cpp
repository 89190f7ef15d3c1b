// SPDX-License-Identifier: BSD-3-Clause
// Ten-node tetrahedra.
#include "core/elements/element_batches.hpp"
#include "core/elements/elements.hpp"
#include "core/elements/solid/tet10_geometry.hpp"
#include "core/elements/solid/uniform_gradient.hpp"

namespace contactsim {

namespace {

using tet10::n_points;
using tet10::Projection;

/// What the points of eight elements give together.
struct TetSums {
  Lanes work = Lanes::Zero();            ///< of the stresses [energy]
  Lanes hourglass_work = Lanes::Zero();  ///< [energy]
  Lanes lambda = Lanes::Zero();          ///< largest bound [force/length^2]
  Lanes shear = Lanes::Zero();           ///< largest bound [force/length^2]
};

Lanes trace(const TensorLanes& tensor) { return tensor[0][0] + tensor[1][1] + tensor[2][2]; }

/// The composite tetrahedron: the velocity gradients of twelve linear tetrahedra, projected on a linear one
/// in the element. With the functions psi_i of the four points (see Projection) and their volumes V_i
///   L_i = (sum_s c_is V_s L_s) / V_i,   force_a = -sum_i sigma_i sum_s c_is g_sa,
/// so that every linear velocity field is met exactly in any shape, and a uniform stress is in balance. Of
/// straight elements with halved edges it is the least-squares projection. The dilatation is the mean one at
/// all points, so that nearly incompressible material does not lock; how it differs from point to point is
/// resisted by hourglass stiffness times the shear modulus. The stable step is that of uniform-gradient
/// elements with another bound of the frequencies,
///   omega^2 <= lambda / V sum_a |B_a|^2 / m_a + 2 mu e,
/// B the derivatives of the volume, m_a the masses of the nodes and e bound_of_gradients. Sources:
/// Thoutireddy, Molinari, Repetto and Ortiz, Int. J. Numer. Meth. Eng. 53 (2002) 1337-1351; Ostien, Foulk,
/// Mota and Veilleux, same 107 (2016) 1145-1170.
struct CompositeTet {
  static constexpr Shape shape = Shape::tet10;
  static constexpr std::string_view formulation = "composite_tet";
  static constexpr std::size_t n_nodes = tet10::n_nodes, n_points = tet10::n_points, n_own = n_points;
  static constexpr auto& mass_shares = tet10::mass_shares;

  static Lanes volume(const NodeVectors<n_nodes>& x) { return tet10::volume(x); }
  ///   state  [n_points x (6 + material) + n_own] own: pressures against uneven dilatation [force/length^2]
  static void advance(const ElementProperties& properties, const SolidMotion<n_nodes>& motion,
                      std::span<Lanes> state, SolidStep<n_nodes>& step) {
    const std::span<Lanes> points = state.first(state.size() - n_own), own = state.last(n_own);
    NodeVectors<n_nodes> x;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t a = 0; a < n_nodes; ++a) x[i][a] = motion.x[i][a] - 0.5 * motion.dt * motion.v[i][a];
    }
    const Projection midpoint(x);
    std::array<TensorLanes, n_points> gradient;
    const Lanes dilatation = find_gradients(midpoint, motion.v, gradient);
    const TetSums sums = update_points(properties, midpoint, motion.dt, dilatation, gradient, points, own);
    step.stress_work = sums.work;
    step.hourglass_work = sums.hourglass_work;
    const Lanes viscous_stress = damp(properties, motion, midpoint, dilatation, sums, step);
    set_forces(Projection(motion.x), points, own, viscous_stress, step);
  }

 private:
  /// The velocity gradients at the points; returns the mean dilatation [1/time].
  static Lanes find_gradients(const Projection& midpoint, const NodeVectors<n_nodes>& v,
                              std::array<TensorLanes, n_points>& gradient) {
    Lanes growth = Lanes::Zero();
    for (std::size_t p = 0; p < n_points; ++p) {
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) gradient[p][i][j] = dot(v[i], midpoint.gradient[p][j]);
      }
      growth += trace(gradient[p]);
      const Lanes per_volume = 1.0 / midpoint.volume[p];
      for (auto& row : gradient[p]) {
        for (Lanes& entry : row) entry *= per_volume;
      }
    }
    return growth / midpoint.whole_volume;
  }

  static TetSums update_points(const ElementProperties& properties, const Projection& midpoint, double dt,
                               const Lanes& dilatation, std::array<TensorLanes, n_points>& gradient,
                               std::span<Lanes> points, std::span<Lanes> own) {
    const std::size_t size = points.size() / n_points;
    const double modulus = properties.hourglass_stiffness * properties.law.moduli().shear;
    TetSums sums;
    for (std::size_t p = 0; p < n_points; ++p) {
      const Lanes uneven = trace(gradient[p]) - dilatation, before = own[p];
      for (std::size_t i = 0; i < 3; ++i) gradient[p][i][i] -= uneven * (1.0 / 3.0);
      const PointStep at_point =
          update_point(properties.law, split_motion(gradient[p], dt), points.subspan(p * size, size));
      own[p] += modulus * dt * uneven;
      sums.work += at_point.work * midpoint.volume[p];
      sums.hourglass_work += 0.5 * dt * (before + own[p]) * uneven * midpoint.volume[p];
      sums.lambda = sums.lambda.max(at_point.moduli.lambda());
      sums.shear = sums.shear.max(at_point.moduli.shear);
    }
    return sums;
  }

  /// Sets stable step and work of bulk viscosity; returns its stress [force/length^2].
  static Lanes damp(const ElementProperties& properties, const SolidMotion<n_nodes>& motion,
                    const Projection& midpoint, const Lanes& dilatation, const TetSums& sums,
                    SolidStep<n_nodes>& step) {
    const Lanes per_mass = 1.0 / motion.mass, per_volume = 1.0 / midpoint.whole_volume;
    Lanes squares = Lanes::Zero();  // of the volume's derivatives over the shares of mass
    for (std::size_t a = 0; a < n_nodes; ++a) {
      Lanes at_node = Lanes::Zero();
      for (std::size_t i = 0; i < 3; ++i) {
        Lanes sum = midpoint.gradient[0][i][a];
        for (std::size_t p = 1; p < n_points; ++p) sum += midpoint.gradient[p][i][a];
        at_node += sum * sum;
      }
      squares += at_node * (1.0 / mass_shares[a]);
    }
    // Stiffness against uneven dilatation beyond 2/3 mu is more than the bound of the shear takes in.
    const double modulus = properties.hourglass_stiffness * properties.law.moduli().shear;
    const Lanes beyond = (modulus - 2.0 / 3.0 * sums.shear).max(0.0);
    const Lanes frequency_squared =
        sums.lambda * squares * per_mass * per_volume +
        (2.0 * sums.shear + 3.0 * beyond) * tet10::bound_of_gradients(midpoint, motion.mass);
    const Lanes wave_speed = ((sums.lambda + 2.0 * sums.shear) * midpoint.whole_volume * per_mass).sqrt();
    const BulkViscosity viscosity(properties, 2.0 / frequency_squared.sqrt(), dilatation,
                                  motion.mass * per_volume, wave_speed);
    step.stable_step = viscosity.stable_step;
    step.viscous_work = viscosity.stress * dilatation * midpoint.whole_volume * motion.dt;
    return viscosity.stress;
  }

  /// Deviators act where they are, pressures through the mean dilatation.
  static void set_forces(const Projection& end, std::span<const Lanes> points, std::span<const Lanes> own,
                         const Lanes& viscous_stress, SolidStep<n_nodes>& step) {
    const std::size_t size = points.size() / n_points;
    const Lanes per_volume = 1.0 / end.whole_volume;
    Lanes mean = Lanes::Zero(), mean_own = Lanes::Zero();
    std::array<SymmetricLanes, n_points> stress;
    for (std::size_t p = 0; p < n_points; ++p) {
      for (std::size_t i = 0; i < 6; ++i) stress[p][i] = points[p * size + i];
      const Lanes share = end.volume[p] * per_volume;
      mean += share * (contactsim::trace(stress[p]) / 3.0);
      mean_own += share * own[p];
      stress[p] = deviator(stress[p]);
    }
    for (auto& component : step.force) component.fill(Lanes::Zero());
    for (std::size_t p = 0; p < n_points; ++p) {
      const Lanes even = mean + viscous_stress + own[p] - mean_own;
      for (std::size_t i = 0; i < 3; ++i) stress[p][i] += even;
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t a = 0; a < n_nodes; ++a)
          step.force[i][a] -= stress[p][symmetric_place[i][0]] * end.gradient[p][0][a] +
                              stress[p][symmetric_place[i][1]] * end.gradient[p][1][a] +
                              stress[p][symmetric_place[i][2]] * end.gradient[p][2][a];
      }
    }
    step.volume = end.volume_or_worst();
  }
};

}  // namespace

const ElementFormulation tet10_composite = solid_element<CompositeTet>();

}  // namespace contactsim
