// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/gathered_results.hpp"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "core/base/errors.hpp"
#include "core/mesh/mesh_piece.hpp"
#include "core/parallel/on_root.hpp"

namespace contactsim {

namespace {

/// Brings the values of all ranks to rank 0, a field after the other.
class FieldGatherer {
 public:
  FieldGatherer(const ResultsPieces& pieces, const Mesh& mesh, std::span<const OutputField> fields)
      : ranks_(pieces.ranks), fields_(fields.begin(), fields.end()), n_nodes_(mesh.n_nodes()) {
    for (const ElementBlock& block : mesh.blocks()) n_elements_.push_back(block.n_elements);
    const std::vector<std::uint32_t> piece_of = pieces.pieces_of(mesh);
    for (int rank = 0; rank < ranks_.count(); ++rank) {
      const bool is_needed = ranks_.is_root() || rank == ranks_.rank();
      pieces_.push_back(std::make_shared<const MeshPiece>(
          is_needed ? find_piece(mesh, piece_of, static_cast<std::uint32_t>(rank)) : MeshPiece()));
    }
    received_.resize(pieces_.size());
  }

  std::shared_ptr<const MeshPiece> own_piece() const {
    return pieces_[static_cast<std::size_t>(ranks_.rank())];
  }

  /// Appends a state on rank 0; the others send their part of it. Throws FileError on all ranks.
  ///   values  of the own piece
  void append(double time, const OutputWriters::FieldValues& values, const OutputWriters::AppendStep& write) {
    std::size_t n_gathered = 0;
    const auto gather_to = [&](std::size_t end) {
      for (; n_gathered < end; ++n_gathered) gather(fields_[n_gathered], values(n_gathered));
    };
    on_each(ranks_, [&] {
      // Also what cannot be written is received.
      try {
        if (ranks_.is_root()) {
          write(time, [&](std::size_t field) {
            gather_to(field + 1);
            return std::span<const double>(whole_);
          });
        }
      } catch (const FileError&) {
        gather_to(fields_.size());
        throw;
      }
      gather_to(fields_.size());
    });
  }

 private:
  void gather(const OutputField& field, std::span<const double> own) {
    if (field.location == FieldLocation::global) {
      whole_.assign(own.begin(), own.end());
      return;
    }
    const auto n_components = static_cast<std::size_t>(field.n_components);
    const auto n_ranks = static_cast<std::size_t>(ranks_.count());
    std::vector<std::span<const std::byte>> out(n_ranks);
    std::vector<std::span<std::byte>> in(n_ranks);
    if (ranks_.is_root()) {
      for (std::size_t rank = 1; rank < n_ranks; ++rank) {
        received_[rank].resize(pieces_[rank]->entities(field).size() * n_components);
        in[rank] = std::as_writable_bytes(std::span(received_[rank]));
      }
    } else {
      out[0] = std::as_bytes(own);
    }
    ranks_.exchange(out, in);
    if (!ranks_.is_root()) return;
    whole_.resize(n_components *
                  (field.location == FieldLocation::node ? n_nodes_ : n_elements_[field.block]));
    for (std::size_t rank = 0; rank < n_ranks; ++rank) {
      const double* next = rank == 0 ? own.data() : received_[rank].data();
      for (const std::uint32_t entity : pieces_[rank]->entities(field)) {
        std::copy_n(next, n_components, &whole_[entity * n_components]);
        next += n_components;
      }
    }
  }

  Ranks& ranks_;
  std::vector<OutputField> fields_;
  std::size_t n_nodes_;
  std::vector<std::size_t> n_elements_;                   // [n_blocks]
  std::vector<std::shared_ptr<const MeshPiece>> pieces_;  // [n_ranks] of others on rank 0 alone
  std::vector<std::vector<double>> received_;             // [n_ranks] of the last field
  std::vector<double> whole_;                             // the last field, on rank 0
};

}  // namespace

OutputWriters::OpenResults open_gathered_results(const ResultsPieces& pieces, const Mesh& mesh,
                                                 std::span<const OutputField> fields,
                                                 const std::function<OutputWriters::OpenResults()>& open) {
  OutputWriters::OpenResults opened;
  on_root(pieces.ranks, [&] { opened = open(); });
  const auto gatherer = std::make_shared<FieldGatherer>(pieces, mesh, fields);
  return {
      [gatherer, write = std::move(opened.append)](double time, const OutputWriters::FieldValues& values) {
        gatherer->append(time, values, write);
      },
      gatherer->own_piece()};
}

}  // namespace contactsim
