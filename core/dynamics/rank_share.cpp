// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/rank_share.hpp"

#include <algorithm>
#include <cstring>

namespace contactsim {

namespace {

/// Bytes of the vector at a node that mean something.
constexpr std::size_t vector_size = 3 * sizeof(double);

std::span<std::byte> bytes_of_batches(std::vector<Lanes>& lanes) {
  return std::as_writable_bytes(std::span(lanes.data()->data(), n_lanes * lanes.size()));
}

}  // namespace

RankShare::RankShare(Ranks& ranks, const Model& model, std::span<const NodeIndex> everywhere)
    : ranks_(ranks),
      model_(model),
      chunks_(model.blocks, ranks.count()),
      nodes_(model, chunks_, everywhere),
      followed_(nodes_.followed(ranks.rank())),
      others_followed_(nodes_.followed_for_others(ranks.rank())) {
  find_places();
  first_sum_.push_back(0);
  for (int rank = 0; rank < ranks.count(); ++rank) {
    for (std::size_t i = 0; i < nodes_.n_sums(); ++i) {
      if (nodes_.rank_of_sum(i) == rank) sums_by_rank_.push_back(static_cast<std::uint32_t>(i));
    }
    first_sum_.push_back(sums_by_rank_.size());
  }
}

ChunkRange RankShare::own_values(std::size_t block) const {
  const ModelBlock& of = model_.blocks[block];
  const ChunkRange own = own_chunks(block);
  const auto begin_of = [&](std::size_t chunk) {
    const std::size_t batch = chunk < of.chunks.size() ? of.chunks[chunk].first_batch : of.n_batches();
    return batch * of.layout.size();
  };
  return {begin_of(own.begin), begin_of(own.end)};
}

std::optional<int> RankShare::rank_of(ElementIndex element) const {
  for (std::size_t b = 0; b < model_.blocks.size(); ++b) {
    const ModelBlock& block = model_.blocks[b];
    if (element < block.first_element || element.value >= block.first_element.value + block.n_elements)
      continue;
    const std::size_t batch = (element.value - block.first_element.value) / n_lanes;
    const auto after = std::ranges::upper_bound(block.chunks, batch, {}, &BatchChunk::first_batch);
    const auto chunk = static_cast<std::size_t>(after - block.chunks.begin()) - 1;
    for (int rank = 0; rank < chunks_.n_ranks(); ++rank) {
      if (chunks_.of(rank, b).contains(chunk)) return rank;
    }
  }
  return std::nullopt;
}

void RankShare::find_places() {
  const int n_ranks = ranks_.count(), self = ranks_.rank();
  out_.assign(static_cast<std::size_t>(n_ranks), Places(model_.blocks.size()));
  in_ = out_;
  sent_.resize(out_.size());
  got_.resize(out_.size());
  const auto add = [&](int from, int to, std::size_t b, Places& places) {
    const ModelBlock& block = model_.blocks[b];
    const ChunkRange chunks = chunks_.of(from, b);
    for (std::size_t c = chunks.begin; c < chunks.end; ++c) {
      const BatchChunk& chunk = block.chunks[c];
      if (chunk.is_subcycled) continue;  // every rank advances it
      for (std::size_t place = chunk.first_node; place < chunk.first_node + chunk.n_nodes; ++place) {
        if (nodes_.follows(to, block.chunk_nodes[place]))
          places[b].push_back(static_cast<std::uint32_t>(place));
      }
    }
  };
  for (int other = 0; other < n_ranks; ++other) {
    if (other == self) continue;
    const auto i = static_cast<std::size_t>(other);
    for (std::size_t b = 0; b < model_.blocks.size(); ++b) {
      if (model_.blocks[b].is_rigid) continue;
      add(self, other, b, out_[i]);
      add(other, self, b, in_[i]);
    }
    sent_[i].resize(message_size(out_[i]));
    got_[i].resize(message_size(in_[i]));
  }
}

std::size_t RankShare::message_size(const Places& places) const {
  std::size_t size = 0;
  for (std::size_t b = 0; b < model_.blocks.size(); ++b)
    size += places[b].size() * bytes_of_place(model_.blocks[b]);
  return size;
}

/// Calls item(address, size) for all that a message holds, in its order.
template <class Item>
void RankShare::visit(const Places& places, State& state, const Item& item) const {
  for (std::size_t b = 0; b < model_.blocks.size(); ++b) {
    ModelBlockState& block = state.blocks[b];
    for (const std::uint32_t place : places[b]) item(block.forces[place].data(), vector_size);
    if (block.moments.empty()) continue;
    for (const std::uint32_t place : places[b]) item(block.moments[place].data(), vector_size);
  }
}

void RankShare::exchange(std::span<ChunkStep> steps, State& state) {
  complete_chunks(steps);
  const auto n_ranks = static_cast<std::size_t>(ranks_.count());
  std::vector<std::span<const std::byte>> out(n_ranks);
  std::vector<std::span<std::byte>> in(n_ranks);
  for (std::size_t other = 0; other < n_ranks; ++other) {
    if (!sent_[other].empty()) {
      std::byte* next = sent_[other].data();
      visit(out_[other], state, [&](const void* from, std::size_t size) {
        std::memcpy(next, from, size);
        next += size;
      });
    }
    out[other] = sent_[other];
    in[other] = got_[other];
  }
  ranks_.exchange(out, in);
  for (std::size_t other = 0; other < n_ranks; ++other) {
    if (got_[other].empty()) continue;
    const std::byte* next = got_[other].data();
    visit(in_[other], state, [&](void* to, std::size_t size) {
      std::memcpy(to, next, size);
      next += size;
    });
  }
}

void RankShare::gather_nodes(Eigen::Matrix3Xd& values) {
  if (values.cols() == 0) return;
  at_nodes_.resize(static_cast<std::size_t>(values.size()));
  std::vector<std::size_t> begins{0};
  // Calls take(stretch gathered, stretch of the values, numbers) for the sums that a rank makes.
  const auto visit_rank = [&](int rank, std::size_t first, const auto& take) {
    const auto r = static_cast<std::size_t>(rank);
    for (std::size_t k = first_sum_[r]; k < first_sum_[r + 1]; ++k) {
      const NodeRange nodes = nodes_.nodes_of_sum(sums_by_rank_[k]);
      const auto n = static_cast<std::size_t>(3 * (nodes.end - nodes.begin));
      take(at_nodes_.data() + first, values.data() + 3 * nodes.begin, n);
      first += n;
    }
    return first;
  };
  for (int rank = 0; rank < ranks_.count(); ++rank)
    begins.push_back(visit_rank(rank, begins.back(), [&](double* gathered, const double* own, std::size_t n) {
      if (rank == ranks_.rank()) std::copy_n(own, n, gathered);
    }));
  ranks_.gather_items(std::span(at_nodes_), begins);
  for (int rank = 0; rank < ranks_.count(); ++rank) {
    if (rank == ranks_.rank()) continue;
    visit_rank(rank, begins[static_cast<std::size_t>(rank)],
               [](const double* gathered, double* there, std::size_t n) { std::copy_n(gathered, n, there); });
  }
}

void RankShare::complete_nodes(State& state) {
  NodalRotations& rotations = state.rotations;
  for (Eigen::Matrix3Xd* values :
       {&state.coordinates, &state.velocity, &state.acceleration, &state.forces.internal,
        &state.forces.external, &state.forces.contact, &rotations.angle, &rotations.velocity,
        &rotations.acceleration, &rotations.moments.internal, &rotations.moments.external,
        &rotations.moments.contact})
    gather_nodes(*values);
}

void RankShare::complete(State& state) {
  complete_nodes(state);
  complete_elements(state);
}

void RankShare::complete_elements(State& state) {
  const auto n_ranks = static_cast<std::size_t>(ranks_.count());
  std::vector<std::size_t> begins(n_ranks + 1);
  for (std::size_t b = 0; b < model_.blocks.size(); ++b) {
    const ModelBlock& block = model_.blocks[b];
    const auto gather = [&](std::vector<Lanes>& lanes) {
      if (lanes.empty()) return;
      const std::span<std::byte> bytes = bytes_of_batches(lanes);
      for (std::size_t r = 0; r < n_ranks; ++r) {
        const std::size_t end = chunks_.of(static_cast<int>(r), b).end;
        begins[r + 1] = end == block.chunks.size()
                            ? bytes.size()
                            : bytes.size() / block.n_batches() * block.chunks[end].first_batch;
      }
      ranks_.gather(bytes, begins);
    };
    gather(state.blocks[b].values);
    gather(state.blocks[b].life);
  }
}

}  // namespace contactsim
