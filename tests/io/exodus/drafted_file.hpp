// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "io/exodus/exodus_draft.hpp"
#include "io/netcdf/netcdf_file.hpp"
#include "support/temporary_directory.hpp"

namespace contactsim::test {

/// A file that a function has drafted, with names of 32 characters, open for reading.
class DraftedFile {
 public:
  explicit DraftedFile(const std::function<void(ExodusDraft&)>& fill, const ExodusFormat& format = {}) {
    NetcdfOutput output(path(), format.is_large);
    ExodusDraft draft(output, format);
    draft.add_dimension("len_name", 33);
    fill(draft);
    draft.write();
    output.commit();
  }

  std::string path() const { return directory_.file("a.e"); }
  NetcdfFile open() const { return NetcdfFile(path()); }

  /// All numbers of a variable.
  static std::vector<double> numbers(const NetcdfFile& file, const std::string& variable) {
    const NetcdfVariable found = file.find_variable(variable).value();
    std::vector<double> values(found.size());
    file.read_double(found, values);
    return values;
  }

 private:
  TemporaryDirectory directory_;
};

}  // namespace contactsim::test
