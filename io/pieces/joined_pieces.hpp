// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "io/pieces/joined_layout.hpp"

namespace contactsim {

/// The pieces of a decomposed Exodus file, read as the whole file that they are of: nodes and elements in its
/// order, numbers of nodes and elements those of the whole. Everything is read from the pieces when it is
/// asked for; only the places of nodes, elements and entries of sets are kept. Every member throws FileError
/// with the path of the piece that is damaged or does not go with the others.
class JoinedPieces {
 public:
  explicit JoinedPieces(const PieceFiles& files);
  JoinedPieces(const JoinedPieces&) = delete;
  JoinedPieces& operator=(const JoinedPieces&) = delete;

  /// Of the first piece.
  const std::string& path() const { return pieces_.front().file->path(); }
  std::size_t n_pieces() const { return pieces_.size(); }
  const NetcdfLayout& layout() const { return joined_.layout; }

  std::optional<NetcdfVariable> find_variable(const std::string& name) const;
  const NetcdfDefinition& definition(const NetcdfVariable& variable) const;

  /// Reads some rows of a variable into a span of their size. Nodes that several pieces have are those of the
  /// first; their coordinates must agree.
  template <class T>
  void read(const NetcdfVariable& variable, Rows rows, std::span<T> values) const;

 private:
  struct Divided;  // a dimension of a variable that is divided

  template <class T>
  void read_made(const std::vector<std::int64_t>& made, const NetcdfVariable& variable, Rows rows,
                 std::span<T> values) const;
  template <class T>
  void read_first(const NetcdfVariable& variable, Rows rows, std::span<T> values) const;
  template <class T>
  void read_divided(const NetcdfVariable& variable, const Divided& divided, Rows rows,
                    std::span<T> values) const;
  /// Throws when pieces have a node at different places.
  void check_agreement(const NetcdfVariable& variable, const Divided& divided, Rows rows,
                       const AxisPlace& place, std::span<const double> whole) const;
  /// Values of one piece, numbers of nodes and elements those of the whole.
  template <class T>
  std::vector<T> read_part(std::size_t piece, const NetcdfVariable& variable, const Divided& divided,
                           Rows rows) const;
  std::optional<Divided> find_divided_dimension(const NetcdfVariable& variable) const;

  std::vector<OpenPiece> pieces_;
  Division division_;
  JoinedLayout joined_;
  std::map<std::string, std::size_t, std::less<>> variables_;  // positions in the layout
};

extern template void JoinedPieces::read(const NetcdfVariable&, Rows, std::span<char>) const;
extern template void JoinedPieces::read(const NetcdfVariable&, Rows, std::span<std::int32_t>) const;
extern template void JoinedPieces::read(const NetcdfVariable&, Rows, std::span<std::int64_t>) const;
extern template void JoinedPieces::read(const NetcdfVariable&, Rows, std::span<double>) const;

}  // namespace contactsim
