// SPDX-License-Identifier: BSD-3-Clause
// Hexahedra with eight integration points.
#include "core/elements/element_batches.hpp"
#include "core/elements/elements.hpp"
#include "core/elements/solid/hex_geometry.hpp"
#include "core/elements/solid/hex_points.hpp"
#include "core/elements/solid/uniform_gradient.hpp"

namespace contactsim {

namespace {

/// Strains and stresses at all points as they are.
struct FullQuadrature {
  static constexpr std::string_view formulation = "fully_integrated";
  static constexpr bool has_mean_dilatation = false;
  static constexpr std::size_t n_own = 0;
};

/// The dilatation is the mean one at all points, so that elements of nearly incompressible material do not
/// lock. Of the deviation of a point's velocity gradient from the mean one counts the share that the
/// section's deviatoric parameter says; the rest is resisted by hourglass forces, as in mean quadrature,
/// which is what a parameter of 0 gives. Source: Hughes, Int. J. Numer. Meth. Eng. 15 (1980) 1413-1418;
/// Sierra/SM, SOLID SECTION, SELECTIVE_DEVIATORIC.
struct SelectiveDeviatoric {
  static constexpr std::string_view formulation = "selective_deviatoric";
  static constexpr bool has_mean_dilatation = true;
  static constexpr std::size_t n_own = 3 * HexGeometry::n_modes;
};

/// What the points of eight elements give together.
struct PointSums {
  Lanes work = Lanes::Zero();              ///< of the stresses [energy]
  Lanes lambda = Lanes::Zero();            ///< largest bound [force/length^2]
  Lanes shear = Lanes::Zero();             ///< largest bound [force/length^2]
  Lanes squared_gradient = Lanes::Zero();  ///< largest of volume x |J^-1|^2 [length]
  Lanes squared_stretch = Lanes::Zero();   ///< largest of volume x (greatest stretch of J^-1)^2 [length]
};

/// The velocity gradient [1/time] at a point.
TensorLanes gradient_at(const PointMap& map, const Lanes& per_volume, const TensorLanes& slopes) {
  TensorLanes gradient;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const auto& c = map.cofactors[j];
      gradient[i][j] = (slopes[i][0] * c[0] + slopes[i][1] * c[1] + slopes[i][2] * c[2]) * per_volume;
    }
  }
  return gradient;
}

/// mean + share x the deviator of (gradient - mean).
TensorLanes mixed(const TensorLanes& gradient, const TensorLanes& mean, double share) {
  TensorLanes mix;
  Lanes trace = Lanes::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) mix[i][j] = share * (gradient[i][j] - mean[i][j]);
    trace += mix[i][i];
  }
  trace *= 1.0 / 3.0;
  for (std::size_t i = 0; i < 3; ++i) {
    mix[i][i] -= trace;
    for (std::size_t j = 0; j < 3; ++j) mix[i][j] += mean[i][j];
  }
  return mix;
}

void add_bounds(const PointMap& map, const Lanes& per_volume, const LaneModuli& moduli, PointSums& sums) {
  const SymmetricLanes stretches = squares(map.cofactors);
  sums.squared_gradient = sums.squared_gradient.max(trace(stretches) * per_volume);
  sums.squared_stretch = sums.squared_stretch.max(bound_of_eigenvalues(stretches) * per_volume);
  sums.lambda = sums.lambda.max(moduli.lambda());
  sums.shear = sums.shear.max(moduli.shear);
}

/// Adds the forces of the stress at a point on the natural slopes of the motion.
void add_forces_on_slopes(const SymmetricLanes& stress, const PointMap& map, std::size_t point,
                          VectorSlopes& amounts) {
  const auto& c = map.cofactors;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& place = symmetric_place[i];
    const Lanes &x = stress[place[0]], &y = stress[place[1]], &z = stress[place[2]];
    for (std::size_t j = 0; j < 3; ++j)
      amounts[i][j][signs_at(point, j)] -= x * c[0][j] + y * c[1][j] + z * c[2][j];
  }
}

/// The stresses at the points of eight elements in two parts.
struct PointForces {
  VectorSlopes amounts;                             ///< of what acts at the points, on the natural slopes
  SymmetricLanes uniform = SymmetricLanes::zero();  ///< what acts on the mean gradient [force/length^2]
  Lanes volume;                                     ///< as volume_of_points [length^3]

  PointForces() {
    for (NaturalSlopes& component : amounts) {
      for (auto& along : component) along.fill(Lanes::Zero());
    }
  }
};

/// An element of eight points; what Quadrature is, see above. The stable step is that of uniform-gradient
/// elements with another bound of the frequencies,
///   omega^2 <= n_nodes / m (lambda B:B / V + 2 mu max(V_p s_p^2)),
/// s_p^2 the greatest eigenvalue of (J^T J)^-1 at a point, B the mean gradient. For the nodal velocities v,
/// the sum of V_p |L_p|^2 is at most max(V_p s_p^2) times the sum of the squared natural slopes at the
/// points, and that is at most |v|^2. Mean dilatation takes V (tr L)^2 / 3 off the sum, as much as lambda has
/// less than the bulk modulus. With full quadrature max(V_p |J^-1|^2) stands for B:B / V.
template <class Quadrature>
struct PointHex {
  static constexpr Shape shape = Shape::hex8;
  static constexpr std::string_view formulation = Quadrature::formulation;
  static constexpr std::size_t n_nodes = 8, n_points = n_hex_points, n_own = Quadrature::n_own;

  static Lanes volume(const NodeVectors<8>& x) {
    return volume_of_points(vector_slopes(base_sums<HexGeometry>(x)));
  }
  ///   state  [n_points x (6 + material) + n_own]
  [[gnu::flatten]] static void advance(const ElementProperties& properties,
                                       const SolidMotion<8>& nodal_motion, std::span<Lanes> state,
                                       SolidStep<8>& step) {
    const SolidMotion<7> motion = base_motion<HexGeometry>(nodal_motion);
    const MidpointKinematics<HexGeometry> midpoint(motion);
    const std::span<Lanes> points = state.first(state.size() - n_own), own = state.subspan(points.size());
    const PointSums sums = update_points(properties, motion, midpoint, points);
    step.stress_work = sums.work;
    const Lanes viscous_stress = damp(properties, motion, midpoint, sums, step);
    const auto hourglass = resist_hourglass(properties, motion, midpoint, own);
    step.hourglass_work = hourglass.work;
    PointForces at_points = split_stresses(properties, motion.x, points);
    for (std::size_t i = 0; i < 3; ++i) at_points.uniform[i] += viscous_stress;
    NodeVectors<7> forces =
        base_forces<HexGeometry>(at_points.uniform, hourglass.force, motion.x, step.volume);
    for (std::size_t i = 0; i < 3; ++i) add_from_slopes(at_points.amounts[i], forces[i]);
    set_nodal_forces<HexGeometry>(forces, step);
    step.volume = at_points.volume;
  }

 private:
  /// How much of a point's deviation from the mean counts.
  static double share_of(const ElementProperties& properties) {
    return Quadrature::has_mean_dilatation ? properties.deviatoric_parameter : 1.0;
  }

  static PointSums update_points(const ElementProperties& properties, const SolidMotion<7>& motion,
                                 const MidpointKinematics<HexGeometry>& midpoint, std::span<Lanes> points) {
    const VectorSlopes x = vector_slopes(midpoint.x), v = vector_slopes(motion.v);
    const std::size_t size = points.size() / n_points;
    PointSums sums;
    for (std::size_t p = 0; p < n_points; ++p) {
      const PointMap map = point_map(x, p);
      const Lanes per_volume = 1.0 / map.volume;
      TensorLanes gradient = gradient_at(map, per_volume, slopes_at(v, p));
      if constexpr (Quadrature::has_mean_dilatation)
        gradient = mixed(gradient, midpoint.velocity_gradient, properties.deviatoric_parameter);
      const PointStep at_point =
          update_point(properties.law, split_motion(gradient, motion.dt), points.subspan(p * size, size));
      sums.work += at_point.work * map.volume;
      add_bounds(map, per_volume, at_point.moduli, sums);
    }
    return sums;
  }

  static double hourglass_modulus(const ElementProperties& properties) {
    return (1.0 - share_of(properties)) * properties.hourglass_stiffness * properties.law.moduli().shear;
  }

  /// Sets stable step and work of bulk viscosity; returns its stress [force/length^2].
  static Lanes damp(const ElementProperties& properties, const SolidMotion<7>& motion,
                    const MidpointKinematics<HexGeometry>& midpoint, const PointSums& sums,
                    SolidStep<8>& step) {
    const Lanes per_mass = 1.0 / motion.mass, mean_norm = midpoint.gradient_norm * midpoint.per_volume;
    const Lanes& dilatation_norm = Quadrature::has_mean_dilatation ? mean_norm : sums.squared_gradient;
    const Lanes hourglass_term = hourglass_modulus(properties) * midpoint.mode_bound * mean_norm;
    const Lanes frequency_squared =
        8.0 * per_mass *
        (sums.lambda * dilatation_norm + hourglass_term + 2.0 * sums.shear * sums.squared_stretch);
    const Lanes wave_speed = ((sums.lambda + 2.0 * sums.shear) * midpoint.volume * per_mass).sqrt();
    const BulkViscosity viscosity(properties, 2.0 / frequency_squared.sqrt(), midpoint.dilatation(),
                                  motion.mass * midpoint.per_volume, wave_speed);
    step.stable_step = viscosity.stable_step;
    step.viscous_work = viscosity.stress * midpoint.dilatation() * midpoint.volume * motion.dt;
    return viscosity.stress;
  }

  static HourglassStep<HexGeometry> resist_hourglass(const ElementProperties& properties,
                                                     const SolidMotion<7>& motion,
                                                     const MidpointKinematics<HexGeometry>& midpoint,
                                                     std::span<Lanes> own) {
    const double modulus = hourglass_modulus(properties);
    if (n_own == 0 || modulus == 0.0) {
      HourglassStep<HexGeometry> none;
      for (auto& component : none.force) {
        for (Lanes& force : component) force.setZero();
      }
      return none;
    }
    const Lanes stiffness = modulus * midpoint.gradient_norm * midpoint.per_volume;
    const TensorLanes rotation = split_motion(midpoint.velocity_gradient, motion.dt).rotation;
    return update_hourglass<HexGeometry>(
        motion, midpoint, stiffness, hourglass_viscosity(properties, motion.mass, stiffness), rotation, own);
  }

  static PointForces split_stresses(const ElementProperties& properties, const NodeVectors<7>& x,
                                    std::span<const Lanes> points) {
    const VectorSlopes slopes = vector_slopes(x);
    const std::size_t size = points.size() / n_points;
    PointForces forces;
    Lanes volume = Lanes::Zero(), min_volume = Lanes::Constant(std::numeric_limits<double>::infinity());
    for (std::size_t p = 0; p < n_points; ++p) {
      const PointMap map = point_map(slopes, p);
      SymmetricLanes stress;
      for (std::size_t i = 0; i < 6; ++i) stress[i] = points[p * size + i];
      if constexpr (Quadrature::has_mean_dilatation) {
        const SymmetricLanes whole = stress;
        stress = deviator(stress);
        for (std::size_t i = 0; i < 6; ++i) {
          stress[i] *= properties.deviatoric_parameter;
          forces.uniform[i] += map.volume * (whole[i] - stress[i]);
        }
      }
      add_forces_on_slopes(stress, map, p, forces.amounts);
      volume += map.volume;
      min_volume = min_volume.min(map.volume);
    }
    for (Lanes& component : forces.uniform.components) component /= volume;
    forces.volume = (min_volume > 0.0).select(volume, min_volume);
    return forces;
  }
};

}  // namespace

const ElementFormulation hex8_selective_deviatoric = solid_element<PointHex<SelectiveDeviatoric>>();
const ElementFormulation hex8_fully_integrated = solid_element<PointHex<FullQuadrature>>();

}  // namespace contactsim
