// SPDX-License-Identifier: BSD-3-Clause
#include "io/pieces/joined_pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <type_traits>

#include "io/pieces/joined_sets.hpp"

namespace contactsim {

namespace {

// Values of the types that files are read as.
void read_values(const NetcdfFile& file, const NetcdfVariable& variable, Rows rows, std::span<char> values) {
  file.read_text(variable, rows, values);
}
void read_values(const NetcdfFile& file, const NetcdfVariable& variable, Rows rows,
                 std::span<std::int64_t> values) {
  file.read_int64(variable, rows, values);
}
void read_values(const NetcdfFile& file, const NetcdfVariable& variable, Rows rows,
                 std::span<std::int32_t> values) {
  if (!file.read_int32(variable, rows, values))
    file.fail("variable " + variable.name + " holds numbers beyond 32 bits");
}
void read_values(const NetcdfFile& file, const NetcdfVariable& variable, Rows rows,
                 std::span<double> values) {
  file.read_double(variable, rows, values);
}

std::string name_in_pieces(const std::string& variable) {
  return std::string(variable == order_map ? whole_order_map : variable);
}

}  // namespace

struct JoinedPieces::Divided {
  std::size_t dimension = 0;  // position among those of the variable
  const DividedAxis* axis = nullptr;
};

JoinedPieces::JoinedPieces(const PieceFiles& files) : pieces_(open_pieces(files)) {
  PieceNumbering numbering = number_pieces(pieces_, division_);
  join_sets(pieces_, division_);
  joined_ = join_layouts(pieces_, division_, std::move(numbering));
  for (std::size_t i = 0; i < joined_.layout.variables.size(); ++i)
    variables_.emplace(joined_.layout.variables[i].name, i);
}

std::optional<NetcdfVariable> JoinedPieces::find_variable(const std::string& name) const {
  const auto found = variables_.find(name);
  if (found == variables_.end()) return std::nullopt;
  const NetcdfDefinition& definition = joined_.layout.variables[found->second];
  NetcdfVariable variable;
  variable.id = static_cast<int>(found->second);
  variable.name = name;
  variable.shape = joined_.layout.shape(definition);
  variable.is_text = definition.type == NetcdfType::text;
  variable.is_64_bit_integer = definition.type == NetcdfType::int64;
  // A part of it is in all pieces.
  variable.is_chunked = true;
  return variable;
}

const NetcdfDefinition& JoinedPieces::definition(const NetcdfVariable& variable) const {
  return joined_.layout.variables.at(static_cast<std::size_t>(variable.id));
}

std::optional<JoinedPieces::Divided> JoinedPieces::find_divided_dimension(
    const NetcdfVariable& variable) const {
  const std::vector<std::string>& dimensions = definition(variable).dimensions;
  for (std::size_t d = 0; d < dimensions.size(); ++d) {
    if (const auto axis = division_.find(dimensions[d]); axis != division_.end())
      return Divided{d, &axis->second};
  }
  return std::nullopt;
}

template <class T>
void JoinedPieces::read(const NetcdfVariable& variable, Rows rows, std::span<T> values) const {
  if (values.empty()) return;
  if (const auto made = joined_.made.find(variable.name); made != joined_.made.end())
    return read_made(made->second, variable, rows, values);
  if (const auto divided = find_divided_dimension(variable))
    return read_divided(variable, *divided, rows, values);
  read_first(variable, rows, values);
}

template <class T>
void JoinedPieces::read_made(const std::vector<std::int64_t>& made, const NetcdfVariable& variable, Rows rows,
                             std::span<T> values) const {
  const std::size_t per_row = made.size() / variable.shape[0];
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<T>(made[rows.first * per_row + i]);
}

template <class T>
void JoinedPieces::read_first(const NetcdfVariable& variable, Rows rows, std::span<T> values) const {
  for (const OpenPiece& piece : pieces_) {
    const auto found = piece.file->find_variable(variable.name);
    if (!found) continue;
    // A list of further maps may be longer in pieces.
    const bool is_long_enough = found->shape.size() == variable.shape.size() &&
                                (found->shape.empty() || found->shape[0] >= rows.first + rows.count);
    if (!is_long_enough || found->is_text != variable.is_text)
      piece.file->fail("variable " + variable.name + " has another shape than in other pieces");
    return read_values(*piece.file, *found, rows, values);
  }
}

template <class T>
std::vector<T> JoinedPieces::read_part(std::size_t piece, const NetcdfVariable& variable,
                                       const Divided& divided, Rows rows) const {
  const std::size_t n_items = divided.axis->positions[piece].size();
  if (n_items == 0) return {};
  const NetcdfFile& file = *pieces_[piece].file;
  const auto part = file.find_variable(name_in_pieces(variable.name));
  if (!part) file.fail(fmt::format("has no variable {}, which other pieces have", variable.name));
  std::vector<std::size_t> shape = variable.shape;
  shape[divided.dimension] = n_items;
  std::vector<std::size_t> of_part = part->shape;
  if (definition(variable).dimensions.front() == time_dimension && !of_part.empty())
    of_part.front() = std::min(of_part.front(), shape.front());  // a piece may have more times than the whole
  if (of_part != shape || part->is_text != variable.is_text)
    file.fail("variable " + variable.name + " has another shape than in other pieces");
  if (divided.dimension == 0) rows = {0, n_items};
  std::size_t n = rows.count;
  for (std::size_t d = 1; d < shape.size(); ++d) n *= shape[d];
  std::vector<T> values(n);
  read_values(file, *part, rows, std::span<T>(values));
  const std::string_view numbered = dimension_of_numbers(variable.name);
  if (numbered.empty()) return values;
  if constexpr (!std::is_same_v<T, char>) {
    const std::vector<std::uint32_t>& in_whole = division_.find(numbered)->second.positions[piece];
    for (T& value : values) {
      const auto number = static_cast<std::int64_t>(value);
      if (number < 1 || static_cast<std::uint64_t>(number) > in_whole.size())
        file.fail(fmt::format("variable {} holds {}, which is not in 1 to {}", variable.name, number,
                              in_whole.size()));
      value = static_cast<T>(in_whole[static_cast<std::size_t>(number) - 1] + std::uint64_t{1});
    }
  }
  return values;
}

void JoinedPieces::check_agreement(const NetcdfVariable& variable, const Divided& divided, Rows rows,
                                   const AxisPlace& place, std::span<const double> whole) const {
  for (std::size_t p = 1; p < pieces_.size(); ++p) {
    const std::vector<std::uint32_t>& positions = divided.axis->positions[p];
    const std::vector<double> part = read_part<double>(p, variable, divided, rows);
    const std::vector<double> of_whole =
        gather<double>(whole, part.empty() ? std::span<const std::uint32_t>() : positions, place);
    for (std::size_t i = 0; i < part.size(); ++i) {
      if (part[i] == of_whole[i] || std::isnan(part[i])) continue;
      pieces_[p].file->fail(fmt::format("node {} of the whole mesh: its {} is {}, in another piece {}",
                                        positions[i % positions.size()] + 1, variable.name, part[i],
                                        of_whole[i]));
    }
  }
}

template <class T>
void JoinedPieces::read_divided(const NetcdfVariable& variable, const Divided& divided, Rows rows,
                                std::span<T> values) const {
  AxisPlace place{1, divided.axis->length, 1};
  for (std::size_t d = 0; d < variable.shape.size(); ++d) {
    const std::size_t length = d == 0 && divided.dimension != 0 ? rows.count : variable.shape[d];
    if (d < divided.dimension) place.outer *= length;
    if (d > divided.dimension) place.inner *= length;
  }
  // All of the pieces where the rows are of the divided dimension itself.
  const bool is_part = divided.dimension == 0 && rows.count < divided.axis->length;
  std::vector<T> all(is_part ? place.along * place.inner : 0);
  const std::span<T> whole = is_part ? std::span<T>(all) : values;
  assert(whole.size() == place.outer * place.along * place.inner);
  for (std::size_t p = pieces_.size(); p-- > 0;) {
    const std::vector<T> part = read_part<T>(p, variable, divided, rows);
    if (!part.empty()) scatter<T>(part, divided.axis->positions[p], place, whole);
  }
  if constexpr (std::is_same_v<T, double>) {
    if (variable.name.starts_with("coord")) check_agreement(variable, divided, rows, place, whole);
  }
  if (is_part)
    std::copy_n(whole.begin() + static_cast<std::ptrdiff_t>(rows.first * place.inner), values.size(),
                values.begin());
}

template void JoinedPieces::read(const NetcdfVariable&, Rows, std::span<char>) const;
template void JoinedPieces::read(const NetcdfVariable&, Rows, std::span<std::int32_t>) const;
template void JoinedPieces::read(const NetcdfVariable&, Rows, std::span<std::int64_t>) const;
template void JoinedPieces::read(const NetcdfVariable&, Rows, std::span<double>) const;

}  // namespace contactsim
