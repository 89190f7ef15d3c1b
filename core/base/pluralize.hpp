// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace contactsim {

/// A number and what is counted: "1 node", "2 nodes".
///   plural  in place of the singular with an s
std::string pluralize(std::size_t n, std::string_view singular, std::string_view plural = "");

}  // namespace contactsim
