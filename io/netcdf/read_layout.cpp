// SPDX-License-Identifier: BSD-3-Clause
#include "io/netcdf/read_layout.hpp"

#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>

#include "io/netcdf/library_guard.hpp"

namespace contactsim {

namespace {

std::optional<NetcdfType> find_type(nc_type type) {
  switch (type) {
    case NC_CHAR:
      return NetcdfType::text;
    case NC_BYTE:
    case NC_UBYTE:
    case NC_SHORT:
    case NC_USHORT:
    case NC_INT:
      return NetcdfType::int32;
    case NC_UINT:
    case NC_INT64:
    case NC_UINT64:
      return NetcdfType::int64;
    case NC_FLOAT:
      return NetcdfType::float32;
    case NC_DOUBLE:
      return NetcdfType::float64;
    default:
      return std::nullopt;
  }
}

NetcdfAttribute of_text(const char* name, std::string_view text) {
  return {name, NetcdfType::text, std::vector<char>(text.begin(), text.end())};
}

/// Reads what the definitions of one open file say.
class LayoutReader {
 public:
  LayoutReader(const NetcdfFile& file, int id) : file_(file), id_(id) {}

  NetcdfLayout read() const {
    int n_dimensions = 0, n_variables = 0, n_attributes = 0;
    check(nc_inq(id_, &n_dimensions, &n_variables, &n_attributes, nullptr));
    NetcdfLayout layout;
    layout.dimensions = read_dimensions(n_dimensions);
    for (int variable = 0; variable < n_variables; ++variable)
      layout.variables.push_back(read_variable(variable, layout));
    layout.attributes = read_attributes(NC_GLOBAL, n_attributes);
    return layout;
  }

 private:
  void check(int status) const {
    if (status != NC_NOERR) file_.fail(fmt::format("its header cannot be read ({})", nc_strerror(status)));
  }

  std::vector<NetcdfDimension> read_dimensions(int n) const {
    int n_unlimited = 0;
    check(nc_inq_unlimdims(id_, &n_unlimited, nullptr));
    std::vector<int> unlimited(static_cast<std::size_t>(n_unlimited));
    check(nc_inq_unlimdims(id_, &n_unlimited, unlimited.data()));
    std::vector<NetcdfDimension> dimensions;
    for (int dimension = 0; dimension < n; ++dimension) {
      char name[NC_MAX_NAME + 1] = {};
      std::size_t length = 0;
      check(nc_inq_dim(id_, dimension, name, &length));
      dimensions.push_back({name, length, std::ranges::find(unlimited, dimension) != unlimited.end()});
    }
    return dimensions;
  }

  NetcdfDefinition read_variable(int variable, const NetcdfLayout& layout) const {
    char name[NC_MAX_NAME + 1] = {};
    nc_type type = NC_NAT;
    int rank = 0, n_attributes = 0;
    check(nc_inq_var(id_, variable, name, &type, &rank, nullptr, &n_attributes));
    std::vector<int> dimensions(static_cast<std::size_t>(rank));
    check(nc_inq_vardimid(id_, variable, dimensions.data()));
    const auto known = find_type(type);
    if (!known) file_.fail(fmt::format("variable {} holds neither texts nor numbers", name));
    NetcdfDefinition read{name, *known, {}, read_attributes(variable, n_attributes)};
    for (const int dimension : dimensions)
      read.dimensions.push_back(layout.dimensions.at(static_cast<std::size_t>(dimension)).name);
    return read;
  }

  std::vector<NetcdfAttribute> read_attributes(int variable, int n) const {
    std::vector<NetcdfAttribute> attributes;
    for (int i = 0; i < n; ++i) {
      char name[NC_MAX_NAME + 1] = {};
      check(nc_inq_attname(id_, variable, i, name));
      if (auto attribute = read_attribute(variable, name)) attributes.push_back(std::move(*attribute));
    }
    return attributes;
  }

  std::optional<NetcdfAttribute> read_attribute(int variable, const char* name) const {
    nc_type type = NC_NAT;
    std::size_t length = 0;
    check(nc_inq_att(id_, variable, name, &type, &length));
    if (type == NC_STRING && length == 1) {
      char* text = nullptr;
      check(nc_get_att_string(id_, variable, name, &text));
      NetcdfAttribute attribute = of_text(name, text == nullptr ? "" : text);
      nc_free_string(1, &text);
      return attribute;
    }
    const auto known = find_type(type);
    if (!known) return std::nullopt;
    NetcdfAttribute attribute{name, *known, {}};
    if (type == NC_CHAR) {
      std::vector<char> text(length);
      check(nc_get_att_text(id_, variable, name, text.data()));
      attribute.values = std::move(text);
    } else if (*known == NetcdfType::float32 || *known == NetcdfType::float64) {
      std::vector<double> reals(length);
      check(nc_get_att_double(id_, variable, name, reals.data()));
      attribute.values = std::move(reals);
    } else {
      std::vector<std::int64_t> integers(length);
      check(nc_get_att_longlong(id_, variable, name, reinterpret_cast<long long*>(integers.data())));
      attribute.values = std::move(integers);
    }
    return attribute;
  }

  const NetcdfFile& file_;
  int id_;
};

}  // namespace

NetcdfLayout read_layout(const NetcdfFile& file) {
  const LibraryGuard guard(file.path());
  return LayoutReader(file, file.id_).read();
}

}  // namespace contactsim
