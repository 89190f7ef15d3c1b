// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/contact_force.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/enforcement/penalty_limits.hpp"
#include "contact/enforcement/returned_energy.hpp"
#include "contact/formulations/start_depths.hpp"
#include "contact/interface_laws/make_interface_laws.hpp"
#include "contact/mesh/feature_edges.hpp"
#include "core/errors.hpp"
#include "core/minimum_nodal_mass.hpp"
#include "core/threads.hpp"

namespace contactsim {

namespace {

std::vector<ActiveTimes> active_times(const ContactSetup& setup) {
  std::vector<ActiveTimes> times;
  for (const SurfacePair& pair : setup.contact.pairs)
    times.push_back(make_active_times(pair.periods, setup.time_stepping_blocks));
  return times;
}

/// The pairs with their friction models. That these are right has been checked before.
PairRules make_rules(const ContactSetup& setup) {
  PairRules rules(setup.contact.pairs, active_times(setup), setup.contact.surfaces.surfaces.size());
  Diagnostics told;
  auto laws =
      make_pair_laws(setup.contact.pairs,
                     {setup.definition.friction_models, setup.functions, setup.time_stepping_blocks}, told);
  if (told.has_errors()) throw DeckError(told);
  rules.set_laws(std::move(laws));
  return rules;
}

}  // namespace

ContactForce::ContactForce(const ContactSetup& setup)
    : setup_(setup),
      contact_mesh_(make_faces({})),
      times_(make_active_times(setup.definition.periods, setup.time_stepping_blocks)),
      rules_(make_rules(setup)),
      kinematics_(contact_mesh_),
      mobility_(setup.model),
      search_(contact_mesh_, *setup.model.mesh, rules_, setup.definition.search, setup.definition.dash,
              setup.model.rigid.nodes.body_of),
      face_face_(contact_mesh_, rules_.has_friction()),
      node_face_(contact_mesh_),
      edges_(contact_mesh_),
      planes_(contact_mesh_, setup.contact.surfaces, setup.contact.planes, rules_),
      assembler_(
          contact_mesh_.n_nodes(), setup.contact.pairs.size(), rules_.has_friction(),
          std::ranges::any_of(contact_mesh_.edges, [](const ContactEdge& edge) { return !edge.is_sharp(); })),
      histories_(setup.contact.pairs.size()),
      least_energy_(setup.contact.pairs.size(), 0.0),
      stored_(setup.contact.pairs.size(), 0.0) {
  kinematics_.turn_by(make_spins());
  balances_ = std::ranges::any_of(rules_.rules(), &PairRule::is_balanced);
  has_penalty_ = !std::ranges::all_of(rules_.rules(), &PairRule::is_balanced);
}

void ContactForce::find_candidates(const Motion& motion) {
  kinematics_.bound_all();
  const std::vector<float> node_depths = node_face_.depths();
  search_.find(kinematics_, motion,
               {face_face_.next_candidates(), node_face_.candidates(), face_face_.depths(), node_depths});
  face_face_.take_candidates();
  if (!contact_mesh_.edges.empty()) {
    search_.find_edges(kinematics_, motion, edges_.next_candidates(), edges_.depths());
    edges_.take_candidates();
  }
  kinematics_.watch(faces_with_candidates());
  has_new_surfaces_ = false;
}

/// Faces of which something has to be known until the next search. A node looks at its own faces, too.
std::vector<std::uint32_t> ContactForce::faces_with_candidates() const {
  std::vector<std::uint8_t> is_watched(contact_mesh_.faces.size(), 0);
  const PairLists &of_faces = face_face_.candidates(), &of_nodes = node_face_.candidates();
  for (std::size_t row = 0; row < of_faces.n_rows(); ++row) {
    if (!of_faces.of(row).empty()) is_watched[row] = 1;
    for (const std::uint32_t partner : of_faces.of(row)) is_watched[partner] = 1;
  }
  for (std::size_t row = 0; row < of_nodes.n_rows(); ++row) {
    if (of_nodes.of(row).empty()) continue;
    for (const std::uint32_t own : contact_mesh_.faces_of_node.of(contact_mesh_.surface_nodes[row].node))
      is_watched[own] = 1;
    for (const std::uint32_t face : of_nodes.of(row)) {
      is_watched[face] = 1;
      for (const std::uint32_t corner : contact_mesh_.faces[face].corners) {
        for (const std::uint32_t neighbour : contact_mesh_.faces_of_node.of(corner))
          is_watched[neighbour] = 1;
      }
    }
  }
  std::vector<std::uint32_t> watched;
  watched.reserve(static_cast<std::size_t>(std::count(is_watched.begin(), is_watched.end(), 1)));
  for (std::uint32_t face = 0; face < is_watched.size(); ++face) {
    if (is_watched[face] != 0) watched.push_back(face);
  }
  return watched;
}

/// The mid surfaces of lofted shells, which turn the points of lofts.
LoftSpins ContactForce::make_spins() const {
  return {contact_mesh_.loft, static_cast<std::size_t>(setup_.model.mesh->coordinates().cols()),
          setup_.model.rigid.nodes};
}

/// The first time that forces are asked for: only now the elements' stable step is known.
void ContactForce::begin(const Motion& motion) {
  has_begun_ = true;
  start_step_ = motion.stable_step;
  limit_stiffness(kinematics_);
  forget_start_depths(contact_mesh_);
  find_candidates(motion);
  const ContactStepContext context{kinematics_, rules_, constrained_, motion.dt};
  mark_close_pairs(context, near_candidates(), rules_);
  edges_.mark_close(context, setup_.definition.dash.search_length_scaling, rules_);
  interface_constraints_.begin(context, near_candidates(), constrained_);
}

NearCandidates ContactForce::near_candidates() const {
  return {face_face_.candidates(), node_face_.candidates(), setup_.definition.dash.search_length_scaling};
}

/// Finds contact points chunk by chunk on all threads. They are taken in order while other threads work on
/// later chunks.
template <class Contacts, class Take>
void ContactForce::visit_contact_points(Contacts& contacts, const ContactStepContext& context,
                                        const Take& take) {
  const std::size_t n_rows = contacts.n_rows();
  const std::size_t n_chunks = (n_rows + rows_per_chunk - 1) / rows_per_chunk;
  const int n_threads = threads_for(n_rows * 10);
  chunks_.resize(std::max(chunks_.size(), static_cast<std::size_t>(n_threads)));
#pragma omp parallel for ordered schedule(dynamic, 1) num_threads(n_threads)
  for (std::size_t i = 0; i < n_chunks; ++i) {
    std::vector<ContactPoint>& contact_points = chunks_[static_cast<std::size_t>(omp_get_thread_num())];
    contact_points.clear();
    contacts.find(context, i * rows_per_chunk, std::min((i + 1) * rows_per_chunk, n_rows), contact_points);
#pragma omp ordered
    for (const ContactPoint& contact_point : contact_points) take(contact_point);
  }
}

/// Whether a contact point that touches is glued then.
bool ContactForce::glues(const ContactPoint& contact_point) const {
  if (contact_point.is_of_edges) return false;
  const PairRule& rule =
      contact_point.first.is_node()
          ? rules_.of_node(contact_point.pair, contact_point.first_entity)
          : rules_.of_faces(contact_point.pair, contact_point.first_entity, contact_point.second_entity);
  return rule.law == ContactLaw::glued;
}

/// Adds a contact point whose forces are known to all sums.
void ContactForce::add_to_sums(const ContactPoint& contact_point) {
  assembler_.add(contact_point);
  if (contact_point.gap < 0.0) assembler_.note_penetration(contact_point, thinner_side(contact_point));
  depths_.note(kinematics_, contact_point);
}

std::span<const ContactPoint> ContactForce::find_node_points(const ContactStepContext& context) {
  node_points_.clear();
  visit_contact_points(node_face_, context,
                       [&](const ContactPoint& contact_point) { node_points_.push_back(contact_point); });
  node_areas_.share_out(context, node_points_);
  return node_points_;
}

/// Takes all contact points of the pairs that the context enforces, in their order. Returns those that are to
/// be glued.
template <class Take>
std::vector<ContactPoint> ContactForce::visit_points(const ContactStepContext& context, const Take& take) {
  std::vector<ContactPoint> to_glue;
  const auto take_one = [&](const ContactPoint& contact_point) {
    take(contact_point);
    if (contact_point.is_met() && glues(contact_point)) to_glue.push_back(contact_point);
  };
  visit_contact_points(face_face_, context, [&](const ContactPoint& contact_point) {
    take_one(contact_point);
    face_face_.note(contact_point);
  });
  for (const ContactPoint& contact_point : find_node_points(context)) take_one(contact_point);
  visit_contact_points(edges_, context, [&](const ContactPoint& contact_point) {
    take_one(contact_point);
    edges_.note(contact_point);
  });
  visit_contact_points(planes_, context, take_one);
  return to_glue;
}

/// What each pair had at the start and has taken, without what it has lost. Laws that pull, ties and what
/// decays keep books of their own.
std::span<const double> ContactForce::available_energy() {
  available_.assign(histories_.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < available_.size(); ++i) {
    const PairRule& rule = rules_.rules()[i];
    const bool is_simple = rule.law == ContactLaw::sliding && rule.interface_law == nullptr &&
                           rule.far == PairRule::not_hybrid && !rule.model.is_variant();
    if (!is_simple || rule.is_balanced) continue;
    const double lost = histories_[i].work - stored_[i];
    available_[i] = histories_[i].stored_at_start + assembler_.taken()[i] - lost;
    least_energy_[i] = std::min(least_energy_[i], available_[i]);
  }
  return available_;
}

void ContactForce::add_places(const ContactStepContext& context) {
  std::vector<ContactPoint> to_glue;
  if (has_penalty_) {
    to_glue =
        visit_points(context, [&](const ContactPoint& contact_point) { points_.push_back(contact_point); });
    if (context.dt > 0.0)
      limit_returned_energy(kinematics_, assembler_.work(), available_energy(), least_energy_, points_);
    for (const ContactPoint& point : points_) add_to_sums(point);
  }
  interface_constraints_.step(context, constrained_, assembler_);
  for (const ContactPoint& contact_point : to_glue)
    interface_constraints_.glue(context, contact_point, constrained_);
}

/// Bounds the eigenvalues of contact's stiffness over mass. Each contact point is a spring of stiffness k
/// with the share w of it at each of its nodes; with s the sum of k w at a node, a contact point may have the
/// share k w / s of the node's mass, which bounds all eigenvalues by the largest one of a single contact
/// point: the mean of s / m over its first side and that over its second. The largest s / m of two surfaces
/// take the place of the means. Points of lofts that hang on one node add up there, as do the nodes of a
/// rigid body.
double ContactForce::largest_eigenvalue() {
  if (points_.empty() && interface_constraints_.forces().empty()) return 0.0;
  slips_.assign(rules_.rules().size(), 0);
  for (std::size_t i = 0; i < slips_.size(); ++i) {
    const PairRule& rule = rules_.rules()[i];
    slips_[i] =
        rule.friction > 0.0 || rule.interface_law != nullptr || rule.far != PairRule::not_hybrid ? 1 : 0;
  }
  const auto node_rates = mobility_.find_rates(kinematics_, points_, interface_constraints_.forces(), slips_);
  std::vector<double>& of_surface = surface_rates_;
  of_surface.assign(setup_.contact.surfaces.surfaces.size(), 0.0);
  for (const SurfaceNode& node : contact_mesh_.surface_nodes) {
    double& rate = of_surface[node.surface];
    rate = std::max(rate, node_rates[node.node]);
  }
  double largest = 0.0;
  for (std::size_t i = 0; i < setup_.contact.pairs.size(); ++i) {
    const SurfacePair& pair = setup_.contact.pairs[i];
    if (assembler_.pairs()[i].is_near)
      largest = std::max(largest, of_surface[pair.first] + of_surface[pair.second]);
  }
  return largest;
}

void ContactForce::write_forces(Eigen::Matrix3Xd& forces) {
  const auto nodes = assembler_.nodes();
  const std::size_t n_mesh_points = contact_mesh_.n_mesh_points();
  // Several points of lofts may hang on one node of the mesh.
  for (std::size_t i = n_mesh_points; i < nodes.size(); ++i)
    forces.col(contact_mesh_.mesh_nodes[i]).setZero();
#pragma omp parallel for schedule(static) num_threads(threads_for(n_mesh_points))
  for (std::size_t i = 0; i < n_mesh_points; ++i)
    forces.col(contact_mesh_.mesh_nodes[i]) = nodes[i].head<3>();
  for (std::size_t i = n_mesh_points; i < nodes.size(); ++i)
    forces.col(contact_mesh_.mesh_nodes[i]) += nodes[i].head<3>();
  spread_moments(forces);
}

/// Calls visit(node, moment) for the moments of forces on points that stand off their nodes.
template <class Visit>
void ContactForce::visit_moments(const Visit& visit) const {
  const std::size_t n_mesh_points = contact_mesh_.n_mesh_points();
  const auto on_points = assembler_.nodes().subspan(n_mesh_points);
  for (std::size_t i = 0; i < on_points.size(); ++i) {
    const Eigen::Vector3d arm = kinematics_.offsets().col(static_cast<Eigen::Index>(i));
    visit(contact_mesh_.loft.node(i), Eigen::Vector3d(arm.cross(on_points[i].head<3>())));
  }
  const auto of_balls = assembler_.moments();
  for (std::size_t i = 0; i < of_balls.size(); ++i) visit(contact_mesh_.mesh_nodes[i], of_balls[i]);
}

/// Gives the moments on lofted shells to the nodes around.
void ContactForce::spread_moments(Eigen::Matrix3Xd& forces) {
  const LoftSpins& spins = kinematics_.spins();
  spin_moments_.assign(spins.size(), Eigen::Vector3d::Zero());
  visit_moments([&](std::uint32_t node, const Eigen::Vector3d& moment) {
    if (const std::uint32_t spin = spins.find(node); spin != LoftSpins::none) spin_moments_[spin] += moment;
  });
  for (std::size_t i = 0; i < spins.size(); ++i) {
    if (spin_moments_[i].isZero(0.0)) continue;
    const auto around = spins.neighbours(i);
    forces.col(spins.node(i)) +=
        spins.spread(i, spin_moments_[i],
                     [&](std::size_t k, const Eigen::Vector3d& force) { forces.col(around[k]) += force; });
  }
}

void ContactForce::set_moments(const Motion& /*motion*/, Eigen::Matrix3Xd& moments) {
  moments.setZero();
  const LoftSpins& spins = kinematics_.spins();
  visit_moments([&](std::uint32_t node, const Eigen::Vector3d& moment) {
    const std::uint32_t spin = spins.find(node);
    // Particles and the nodes of trusses do not turn: the moment of friction on them is lost.
    if (!(setup_.model.inertia(0, node) > minimum_nodal_mass)) return;
    moments.col(node) += spin == LoftSpins::none ? moment : spins.own_share(spin, moment);
  });
}

ForceReport ContactForce::set_forces(const Motion& motion, Eigen::Matrix3Xd& forces) {
  const bool is_first = !has_begun_;
  if (is_first) forces.setZero();  // later on only contact nodes ever have another value
  for (const std::uint32_t node : std::exchange(left_, {})) forces.col(node).setZero();
  const bool have_conditions_changed = mobility_.update(motion.time);
  if (have_conditions_changed) {
    kinematics_.hold(mobility_.free_directions());
    balance_.forget_mobility();
  }
  kinematics_.step(motion);
  rules_.activate(motion.time, times_.is_active(motion.time));
  if (have_conditions_changed && !is_first)
    limit_stiffness(kinematics_of_mesh(contact_mesh_, *setup_.model.mesh));
  if (is_first) {
    begin(motion);
  } else if (rules_.have_changed()) {
    find_candidates(motion);
    interface_constraints_.renew({kinematics_, rules_, constrained_, motion.dt}, near_candidates(),
                                 constrained_);
  } else if (has_new_surfaces_ || search_.is_due(kinematics_)) {
    find_candidates(motion);
  } else if (has_penalty_) {
    kinematics_.bound_watched();
  }
  assembler_.begin_step();
  points_.clear();
  interface_constraints_.begin_step();
  assembler_.begin_work(kinematics_, motion.dt);
  depths_.begin_step(contact_mesh_.faces.size());
  face_face_.begin_step();
  node_face_.begin_step();
  edges_.begin_step();
  add_places({kinematics_, rules_, constrained_, motion.dt, motion.stable_step, &depths_});
  write_forces(forces);
  if (is_first) {
    set_start_depths(points_, contact_mesh_);
    stored_at_start_ = stored();
    for (std::size_t i = 0; i < histories_.size(); ++i)
      histories_[i].stored_at_start = assembler_.pairs()[i].stored;
  }
  if (!balances_) end_step(motion.time, motion.dt);
  ForceReport report;
  report.friction_work = assembler_.dissipated();
  report.contact_damping_work = assembler_.damped();
  // Eigenvalues of stiffness over mass add up at most: that of the elements, 4 / dt^2, and contact's.
  const double eigenvalue = largest_eigenvalue();
  if (eigenvalue > 0.0) {
    const double of_elements = 4.0 / (motion.stable_step * motion.stable_step);
    // A bounce off a penalty must last three steps at least, or it gains energy by where its first step
    // falls.
    report.stable_step = std::min(2.0 / std::sqrt(of_elements + eigenvalue), 1.0 / std::sqrt(eigenvalue));
    step_share_.share = std::max(step_share_.share, 1.0 - report.stable_step / motion.stable_step);
  }
  return report;
}

void ContactForce::end_step(double time, double dt) {
  assembler_.end_step();
  note_histories(dt);
  note_lost(time);
}

/// The velocities of the contact nodes in the coming step, as the forces so far give them.
void ContactForce::foresee(const State& state) {
  const double half_steps = 0.5 * (state.dt + state.next_dt);
  const bool turns = state.rotations.exist();
  free_velocity_.resize(3, state.velocity.cols());
  if (turns) free_turning_.resize(3, state.velocity.cols());
  const auto n_nodes = static_cast<std::int64_t>(contact_mesh_.n_nodes());
#pragma omp parallel for schedule(static) num_threads(threads_for(contact_mesh_.n_mesh_points()))
  for (std::int64_t i = 0; i < n_nodes; ++i) {
    const auto node = static_cast<Eigen::Index>(contact_mesh_.mesh_nodes[static_cast<std::size_t>(i)]);
    free_velocity_.col(node) = state.velocity.col(node) + half_steps * state.acceleration.col(node);
    if (!turns) continue;
    free_turning_.col(node) =
        state.rotations.velocity.col(node) + half_steps * state.rotations.acceleration.col(node);
  }
  Motion coming{state.time, state.dt, state.coordinates, free_velocity_};
  if (turns) coming.angular_velocity = &free_turning_;
  kinematics_.foresee(coming);
  kinematics_.bound_watched();
}

double ContactForce::thinner_side(const ContactPoint& contact_point) const {
  if (contact_point.is_of_edges) {
    return std::min(contact_mesh_.edges[contact_point.first_entity].penalty_properties.thickness,
                    contact_mesh_.edges[contact_point.second_entity].penalty_properties.thickness);
  }
  const double first =
      contact_point.first.is_node()
          ? contact_mesh_.surface_nodes[contact_point.first_entity].penalty_properties.thickness
          : contact_mesh_.faces[contact_point.first_entity].penalty_properties.thickness;
  if (contact_point.second.weights.isZero(0.0)) return first;
  return std::min(first, contact_mesh_.faces[contact_point.second_entity].penalty_properties.thickness);
}

std::optional<ForceReport> ContactForce::balance(const State& state, Eigen::Matrix3Xd& forces) {
  if (!balances_) return std::nullopt;
  foresee(state);
  ContactStepContext context{kinematics_, rules_, constrained_, state.dt};
  context.depths = &depths_;
  context.balances = true;
  context.coming_dt = state.next_dt;
  balance_.begin(setup_.model, mobility_.free_directions(), kinematics_, state);
  const auto to_glue = visit_points(context, [&](const ContactPoint& contact_point) {
    balance_.add(contact_point, rules_[contact_point.pair], thinner_side(contact_point));
  });
  interface_constraints_.add_balanced(context, balance_);
  balance_report_ = balance_.solve(static_cast<int>(setup_.definition.enforcement.balance_iterations));
  for (const ContactPoint& point : balance_.points()) add_to_sums(point);
  interface_constraints_.take_balanced(context, balance_, constrained_, assembler_);
  for (const ContactPoint& contact_point : to_glue)
    interface_constraints_.glue(context, contact_point, constrained_);
  if (points_.empty()) {
    balance_.swap_points(points_);
  } else {
    points_.insert(points_.end(), balance_.points().begin(), balance_.points().end());
  }
  write_forces(forces);
  end_step(state.time, state.dt);
  ForceReport report;
  report.balanced_nodes = balance_.mesh_nodes();
  const ContactLoss& loss = balance_.loss();
  report.friction_work = last_loss_.friction_after + loss.friction_before;
  report.impact_work = last_loss_.impact_after + loss.impact_before;
  last_loss_ = loss;
  return report;
}

double ContactForce::stored() const {
  double sum = 0.0;
  for (const PairStep& pair : assembler_.pairs()) sum += pair.stored;
  return sum;
}

void ContactForce::note_histories(double dt) {
  const auto steps = assembler_.pairs();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const PairStep& step = steps[i];
    PairHistory& history = histories_[i];
    history.work += step.stored - stored_[i] + step.dissipated + step.damped;
    history.impact += step.impact;
    stored_[i] = step.stored;
    history.taken = assembler_.taken()[i];
    if (step.penetration > history.deepest) {
      history.deepest = step.penetration;
      history.deepest_share = step.penetration_share;
    }
    if (!step.touches) continue;
    history.contact_time += dt;
    history.peak_force = std::max(history.peak_force, step.force.norm());
    history.impulse -= dt * step.force;
    history.friction_work += step.dissipated;
  }
}

}  // namespace contactsim
