// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/contact_detection.hpp"
#include "core/definition/contact.hpp"

namespace contactsim {

namespace {

template <class F>
void watch_close_of(const F& formulation, IndexedVector<FaceIndex, std::uint8_t>& is_watched) {
  if constexpr (requires { formulation.watch_close(is_watched); }) return formulation.watch_close(is_watched);
  formulation.watch(is_watched);
}

}  // namespace

ContactDetection::ContactDetection(const ContactSetup& setup, const ContactMesh& contact_mesh,
                                   const PairRules& rules)
    : setup_(setup),
      contact_mesh_(contact_mesh),
      rules_(rules),
      search_(contact_mesh, *setup.model.mesh, rules, setup.definition.search, setup.definition.dash,
              setup.model.rigid.nodes.body_of, setup.ranks),
      formulations_({contact_mesh, setup.contact, rules}) {
  for_each_of_points(formulations_, [&](const auto&) { narrow_phases_.emplace_back(setup.ranks); });
}

void ContactDetection::find_candidates(const Motion& motion, ContactKinematics& kinematics) {
  kinematics.bound_all();
  for_each_of_points(formulations_,
                     [&](auto& formulation) { formulation.find_candidates(search_, kinematics, motion); });
  search_.finish(kinematics);
  kinematics.watch(faces_with_candidates());
  forget_close();
  has_new_surfaces_ = false;
}

void ContactDetection::begin_narrow_phase(ContactStepContext& context, ContactKinematics& kinematics) {
  if (has_new_close_) take_close(kinematics);
  close_window_.choose(context);
  has_new_close_ = context.candidates == CandidateUse::renew_close;
  if (context.candidates == CandidateUse::close) {
    kinematics.bound_close();
  } else {
    kinematics.bound_watched();
  }
}

void ContactDetection::find_start_candidates(const Motion& motion, ContactKinematics& kinematics) {
  search_.reach_for_start(true);
  find_candidates(motion, kinematics);
}

void ContactDetection::end_start(const Motion& motion, ContactKinematics& kinematics) {
  search_.reach_for_start(false);
  if (search_.has_start_reach()) find_candidates(motion, kinematics);
}

/// Has bounds of faces follow close candidates, or forgets these where they are most.
void ContactDetection::take_close(ContactKinematics& kinematics) {
  std::size_t n_close = 0, n = 0;  // of formulations that leave candidates out
  for_each_of_points(formulations_, [&](const auto& formulation) {
    if constexpr (requires { formulation.n_close(); }) {
      n_close += formulation.n_close();
      n += formulation.n_candidates();
    }
  });
  if (close_window_.note(n_close, n)) {
    kinematics.watch_close(faces_that(
        [](const auto& formulation, auto& is_watched) { watch_close_of(formulation, is_watched); }));
    return;
  }
  for_each_of_points(formulations_, [](auto& formulation) {
    if constexpr (requires { formulation.forget_close(); }) formulation.forget_close();
  });
}

/// The faces that mark(formulation, is_watched) marks of any formulation that finds contact points.
template <class Mark>
std::vector<FaceIndex> ContactDetection::faces_that(const Mark& mark) const {
  IndexedVector<FaceIndex, std::uint8_t> is_watched(contact_mesh_.faces.size(), 0);
  for_each_of_points(formulations_, [&](const auto& formulation) { mark(formulation, is_watched); });
  std::vector<FaceIndex> watched;
  watched.reserve(static_cast<std::size_t>(std::count(is_watched.begin(), is_watched.end(), 1)));
  for (const FaceIndex face : indices(is_watched)) {
    if (is_watched[face] != 0) watched.push_back(face);
  }
  return watched;
}

std::vector<FaceIndex> ContactDetection::faces_with_candidates() const {
  return faces_that([](const auto& formulation, auto& is_watched) { formulation.watch(is_watched); });
}

void ContactDetection::begin_step() {
  for_each_of_points(formulations_, [](auto& formulation) { formulation.begin_step(); });
}

void ContactDetection::undo_begin_step() {
  for_each_of_points(formulations_, [](auto& formulation) { formulation.undo_begin_step(); });
}

void ContactDetection::weigh_gaps(const ContactStepContext& context, WeightedGaps& gaps) const {
  const auto& faces = formulations_.get<FaceFaceContacts>();
  const std::size_t n_rows = faces.n_rows();
  std::vector<std::vector<WeightedOverlap>> chunks((n_rows + rows_per_chunk - 1) / rows_per_chunk);
  parallel_for(chunks.size(), threads_for(n_rows * 10), [&](std::size_t i) {
    faces.weigh(context, {i * rows_per_chunk, std::min((i + 1) * rows_per_chunk, n_rows)}, chunks[i]);
  });
  gaps.clear();
  for (const auto& chunk : chunks) {
    for (const WeightedOverlap& overlap : chunk) gaps.add(contact_mesh_, overlap);
  }
  gaps.find_tractions(context);
}

void ContactDetection::find_lost(std::vector<LostContact>& lost) const {
  for_each_of_points(formulations_, [&](const auto& formulation) { formulation.find_lost(rules_, lost); });
}

void ContactDetection::mark_close(const ContactStepContext& context, PairRules& rules) const {
  const double size_share = setup_.definition.dash.search_length_scaling;
  for_each_of_points(formulations_, [&](const auto& formulation) {
    if constexpr (requires { formulation.mark_close(context, size_share, rules); })
      formulation.mark_close(context, size_share, rules);
  });
}

FoundStartGaps ContactDetection::find_start_gaps(const ContactStepContext& context) const {
  FoundStartGaps found;
  for_each_of_points(formulations_, [&](const auto& formulation) {
    if constexpr (requires { formulation.add_start_gaps(context, found); })
      formulation.add_start_gaps(context, found);
  });
  return found;
}

std::size_t ContactDetection::n_candidates() const {
  std::size_t n = 0;
  for_each_of_points(formulations_, [&](const auto& formulation) { n += formulation.n_candidates(); });
  return n;
}

void ContactDetection::begin_with_ties(std::span<const Tie> ties) {
  for_each_of_constraints(formulations_, [&](auto& formulation) {
    if constexpr (requires { formulation.begin_with(ties); }) formulation.begin_with(ties);
  });
}

void ContactDetection::find_constraints(const ContactStepContext& context, bool only_changed,
                                        ConstrainedPairs& constrained) {
  const NearCandidates near{formulations_.get<FaceFaceContacts>().candidates(),
                            formulations_.get<NodeFaceContacts>().candidates(),
                            setup_.definition.dash.search_length_scaling};
  if (only_changed) decaying_.end_changed(rules_);
  for_each_of_constraints(formulations_, [&](auto& formulation) {
    formulation.find_candidates(context, near, only_changed, constrained);
  });
}

void ContactDetection::detect_constraints(const ContactStepContext& context, ConstrainedPairs& constrained,
                                          std::vector<ConstraintForces>& found) {
  if (!context.is_static && !context.is_trial) decaying_.step(context, found);
  for_each_of_constraints(formulations_, [&](auto& formulation) {
    const std::size_t n_before = found.size();
    formulation.detect(context, found);
    if (context.is_trial) return;
    formulation.update(context, std::span<const ConstraintForces>(found).subspan(n_before), constrained,
                       decaying_);
  });
}

void ContactDetection::glue(const ContactStepContext& context, std::span<const ContactPoint> points,
                            ConstrainedPairs& constrained) {
  for (const ContactPoint& point : points) {
    for_each_of_constraints(formulations_, [&](auto& formulation) {
      if constexpr (requires { formulation.glue(context, point, constrained); })
        formulation.glue(context, point, constrained);
    });
  }
}

void ContactDetection::remap(const ContactRemap& remap) {
  search_.remap(remap);
  formulations_.for_each([&](auto& formulation) { formulation.remap(remap); });
  decaying_.remap(remap);
  for (const auto& face : released_faces()) search_.release_face(face.entity);
  for (const auto& node : released_nodes()) search_.release_row(node.entity);
  forget_close();
  has_new_surfaces_ = true;
}

void ContactDetection::archive(StateArchive& saved) {
  search_.archive(saved);
  formulations_.for_each([&](auto& formulation) { formulation.archive(saved); });
  decaying_.archive(saved);
  forget_close();
}

}  // namespace contactsim
