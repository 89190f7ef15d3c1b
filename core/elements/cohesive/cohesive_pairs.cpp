// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/cohesive/cohesive_pairs.hpp"

namespace contactsim::cohesive {

Lanes damage(const TractionLaw& law, std::span<const Lanes> pair) {
  const Lanes reached = pair[largest].max(law.lambda_1);  // the slope is the first one until lambda_1
  const Lanes share = ((1.0 - reached) * (1.0 / (1.0 - law.lambda_2))).max(0.0).min(1.0);  // of the peak
  return 1.0 - share * law.lambda_1 / reached;
}

void stretch(const TractionLaw& law, const Lanes& open, const Lanes& slide, std::span<Lanes> pair) {
  const Lanes n = open.max(0.0) * (1.0 / law.normal_length), t = slide * (1.0 / law.tangential_length);
  pair[largest] = pair[largest].max((n * n + t * t).sqrt());
  pair[open_step] = open - pair[opening];
  pair[slide_step] = slide - pair[sliding];
  pair[opening] = open;
  pair[sliding] = slide;
}

Lanes pull(const TractionLaw& law, const LaneMask& is_gone, std::span<Lanes> pair) {
  const Lanes before_n = pair[normal], before_t = pair[tangential];
  const Lanes tensile = (1.0 - damage(law, pair)) * law.normal_stiffness() * pair[opening].max(0.0);
  const Lanes compressive = law.penetration_factor * law.normal_stiffness() * pair[opening].min(0.0);
  pair[normal] = is_gone.select(0.0, tensile + compressive);
  pair[tangential] = tangential_slope(law, pair) * pair[sliding];
  return 0.5 * (before_n + pair[normal]) * pair[open_step] +
         0.5 * (before_t + pair[tangential]) * pair[slide_step];
}

}  // namespace contactsim::cohesive
