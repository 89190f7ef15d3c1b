// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace contactsim {

/// A program that had its hand in a file. At most 32 characters of each are kept.
struct QaRecord {
  std::string code, version, date, time;
  bool operator==(const QaRecord&) const = default;
};

/// The QA records of an Exodus file, none when it has none or in a form of its own. Throws FileError when the
/// file cannot be read.
std::vector<QaRecord> read_qa_records(const std::string& path);

}  // namespace contactsim
