// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "core/elements/elements.hpp"
#include "core/elements/line/fibre_point.hpp"
#include "core/elements/line/line_batches.hpp"

namespace contactsim {

namespace {

/// Axes across a beam: t as it turns with the material, s = axis x t.
struct Across {
  VectorLanes t, s;
};

/// Turns what is at right angles to one unit vector the shortest way to another. Source: Rodrigues' formula.
VectorLanes transferred(const VectorLanes& t, const VectorLanes& from, const VectorLanes& to) {
  const Lanes factor = dot(t, to) / (1.0 + dot(from, to));
  return {t[0] - factor * (from[0] + to[0]), t[1] - factor * (from[1] + to[1]),
          t[2] - factor * (from[2] + to[2])};
}

/// Turns about the axis by the angle whose half has the tangent.
Across turned(const VectorLanes& t, const VectorLanes& axis, const Lanes& tangent) {
  const VectorLanes s = cross(axis, t);
  const Lanes scale = 1.0 / (1.0 + tangent * tangent);
  const Lanes cosine = (1.0 - tangent * tangent) * scale, sine = 2.0 * tangent * scale;
  Across across;
  for (std::size_t i = 0; i < 3; ++i) across.t[i] = cosine * t[i] + sine * s[i];
  across.t = unit(across.t);
  across.s = cross(axis, across.t);
  return across;
}

/// The deck's t axis, made a unit vector across the beam; beams that lie along it, or have none, take one
/// across the global axis that they lie least along.
VectorLanes first_t(const Eigen::Vector3d& wish, const VectorLanes& axis) {
  VectorLanes t;
  for (Eigen::Index lane = 0; lane < n_lanes; ++lane) {
    const Eigen::Vector3d along(axis[0](lane), axis[1](lane), axis[2](lane));
    constexpr double tolerance = 1e-6;
    Eigen::Vector3d across = wish - wish.dot(along) * along;
    if (across.norm() <= tolerance * wish.norm()) {
      Eigen::Index smallest = 0;
      along.cwiseAbs().minCoeff(&smallest);
      across = Eigen::Vector3d::Unit(smallest) - along(smallest) * along;
    }
    across.normalize();
    for (std::size_t i = 0; i < 3; ++i) t[i](lane) = across(static_cast<Eigen::Index>(i));
  }
  return t;
}

/// How the two nodes turn.
struct Turning {
  VectorLanes mean, difference;

  explicit Turning(const NodeVectors<2>& w) {
    for (std::size_t i = 0; i < 3; ++i) {
      mean[i] = 0.5 * (w[i][0] + w[i][1]);
      difference[i] = w[i][1] - w[i][0];
    }
  }
};

/// How a beam deforms in a step: along the axis, t and s.
struct BeamStrain {
  VectorLanes stretching, bending;  ///< [1/time], [1/(length time)]
  double dt;                        ///< [time]
};

/// Forces and moments over a cross-section: along the axis, t and s.
struct SectionForces {
  VectorLanes force, moment;
  Lanes work;
  Lanes stiffening = Lanes::Ones();  ///< largest of the fibres
};

/// Factors of the angles that fibres see, and of what their stresses resist, so that the section has the
/// torsion and the shear of a real one; that of shear also makes bending by end forces exact with one point
/// along the beam. Source: MacNeal, Computers and Structures 8 (1978) 175-183, residual bending flexibility.
struct AngleFactors {
  Lanes along_t, along_s;
  double torsion;

  AngleFactors(const BeamShapeSettings& shape, const ElasticModuli& moduli, const Lanes& length) {
    const Lanes flexibility = moduli.shear * shape.area / (12.0 * moduli.youngs()) * length * length;
    along_t = (1.0 / (1.0 / shape.shear_t + flexibility / shape.second_t)).sqrt();
    along_s = (1.0 / (1.0 / shape.shear_s + flexibility / shape.second_s)).sqrt();
    torsion = std::sqrt(shape.torsion / (shape.second_t + shape.second_s));
  }
};

/// Co-rotational beams of two nodes with one point along the axis and fibres over their cross-section.
/// Source: Hughes and Liu, Comp. Meth. Appl. Mech. Eng. 27 (1981) 167-181; Belytschko and Schwer, same 12
/// (1977) 109-132.
struct Beam {
  static constexpr std::size_t n_own = 3;  ///< the t axis; zero until it is known
  static constexpr bool has_rotations = true;

  static void advance(const ModelBlock& block, std::size_t /*batch*/, const LineMotion& motion,
                      std::span<Lanes> state, LineStep& step);

 private:
  static SectionForces update_fibres(const ModelBlock& block, const BeamStrain& strain,
                                     const AngleFactors& factors, std::span<Lanes> fibres);
  static Lanes stable_step(const ModelBlock& block, const LineMotion& motion, const AngleFactors& factors,
                           const Lanes& length);
};

SectionForces Beam::update_fibres(const ModelBlock& block, const BeamStrain& strain,
                                  const AngleFactors& factors, std::span<Lanes> fibres) {
  const MaterialLaw& law = block.properties.law;
  SectionForces sums;
  for (Lanes& sum : sums.force) sum.setZero();
  for (Lanes& sum : sums.moment) sum.setZero();
  sums.work.setZero();
  const auto& [stretching, bending, dt] = strain;
  const std::size_t size = block.layout.point_size;
  for (std::size_t i = 0; i < block.beam.fibres.size(); ++i) {
    const BeamFibre& fibre = block.beam.fibres[i];
    const std::span<Lanes> point = fibres.subspan(i * size, size);
    FibreStep step{{}, dt};
    step.strain[0] = dt * (stretching[0] - fibre.t * bending[2] + fibre.s * bending[1]);
    step.strain[1] = dt * (factors.along_t * stretching[1] - factors.torsion * fibre.s * bending[0]);
    step.strain[2] = dt * (factors.along_s * stretching[2] + factors.torsion * fibre.t * bending[0]);
    const FibreLanes before = fibre_stress(law, point);
    const FibreLanes after = update_fibre(law, step, point, sums.stiffening);
    for (std::size_t k = 0; k < 3; ++k)
      sums.work += 0.5 * fibre.area * (before[k] + after[k]) * step.strain[k];
    sums.force[0] += fibre.area * after[0];
    sums.force[1] += fibre.area * factors.along_t * after[1];
    sums.force[2] += fibre.area * factors.along_s * after[2];
    sums.moment[0] += fibre.area * factors.torsion * (fibre.t * after[2] - fibre.s * after[1]);
    sums.moment[1] += fibre.area * fibre.s * after[0];
    sums.moment[2] -= fibre.area * fibre.t * after[0];
  }
  return sums;
}

/// 2 / omega with a bound for the squared frequencies of stretching, of bending (nodes that turn against each
/// other) and shear (nodes that turn alike, and move across) in either plane, and of torsion; when the centre
/// lies beside the nodes these mix, and their sum bounds them.
Lanes Beam::stable_step(const ModelBlock& block, const LineMotion& motion, const AngleFactors& factors,
                        const Lanes& length) {
  const ElasticModuli moduli = block.properties.law.moduli();
  const double youngs = moduli.youngs();
  double area = 0.0, second_t = 0.0, second_s = 0.0;  // about the nodes
  for (const BeamFibre& fibre : block.beam.fibres) {
    area += fibre.area;
    second_t += fibre.area * fibre.t * fibre.t;
    second_s += fibre.area * fibre.s * fibre.s;
  }
  const Lanes moving = 2.0 / motion.mass * 2.0 / length, turning = 2.0 / motion.inertia * 2.0 / length;
  const Lanes shear = moduli.shear * area * (moving + 0.25 * length * length * turning);
  const Lanes stretch = youngs * area * moving;
  const Lanes bend_t = youngs * second_t * turning, bend_s = youngs * second_s * turning;
  const Lanes shear_t = factors.along_t * factors.along_t * shear;
  const Lanes shear_s = factors.along_s * factors.along_s * shear;
  const Lanes torsion = moduli.shear * factors.torsion * factors.torsion * (second_t + second_s) * turning;
  const Lanes squared = block.beam.is_offset
                            ? Lanes(stretch + bend_t + bend_s + shear_t + shear_s + torsion)
                            : stretch.max(bend_t).max(bend_s).max(shear_t).max(shear_s).max(torsion);
  return 2.0 / squared.sqrt();
}

void Beam::advance(const ModelBlock& block, std::size_t, const LineMotion& motion, std::span<Lanes> state,
                   LineStep& step) {
  const LineGeometry start(motion.x, motion.v, motion.dt), middle(motion.x, motion.v, 0.5 * motion.dt),
      end(motion.x);
  const std::span<Lanes> own = state.last(n_own);
  const bool is_new = own[0](0) == 0.0 && own[1](0) == 0.0 && own[2](0) == 0.0;
  const VectorLanes t = is_new ? first_t(block.beam.t_axis, start.axis) : VectorLanes{own[0], own[1], own[2]};
  const Turning turning(motion.w);
  // Along a chord the turn about the axis is this, whatever the axis does meanwhile.
  const Lanes warp = 0.25 * motion.dt * (dot(turning.mean, start.axis) + dot(turning.mean, end.axis));
  const Across amid = turned(transferred(t, start.axis, middle.axis), middle.axis, 0.5 * warp);
  const Across at_end = turned(transferred(t, start.axis, end.axis), end.axis, warp);
  for (std::size_t i = 0; i < 3; ++i) own[i] = at_end.t[i];

  const VectorLanes v = motion.velocity_difference();
  const Lanes per_length = 1.0 / middle.length;
  const BeamStrain strain{
      {per_length * dot(v, middle.axis), per_length * dot(v, amid.t) - dot(turning.mean, amid.s),
       per_length * dot(v, amid.s) + dot(turning.mean, amid.t)},
      {per_length * dot(turning.difference, middle.axis), per_length * dot(turning.difference, amid.t),
       per_length * dot(turning.difference, amid.s)},
      motion.dt};
  // By the end's length, which a turn of any size leaves alone.
  const AngleFactors factors(block.beam, block.properties.law.moduli(), end.length);
  const SectionForces sums = update_fibres(block, strain, factors, state.first(state.size() - n_own));
  step.stress_work = sums.work * middle.length;
  step.stable_step = stable_step(block, motion, factors, middle.length) / sums.stiffening.sqrt();
  step.volume = block.beam.area * end.length;
  for (std::size_t i = 0; i < 3; ++i) {
    step.pull[i] = sums.force[0] * end.axis[i] + sums.force[1] * at_end.t[i] + sums.force[2] * at_end.s[i];
    step.bend[i] = sums.moment[0] * end.axis[i] + sums.moment[1] * at_end.t[i] + sums.moment[2] * at_end.s[i];
    step.mean_moment[i] = end.length * (sums.force[2] * at_end.t[i] - sums.force[1] * at_end.s[i]);
  }
}

}  // namespace

const ElementFormulation beam2_beam = line_element<Beam>(Shape::beam2, "beam");
const ElementFormulation bar2_beam = line_element<Beam>(Shape::bar2, "beam");

}  // namespace contactsim
