// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "app/manual/manual_file.hpp"

namespace contactsim {

/// Text with what HTML would take for markup written out; also inside of attributes.
std::string html_text(std::string_view text);

/// A name for the anchor of a heading: letters and digits in lower case, the rest as single hyphens.
std::string html_anchor(std::string_view text);

/// A page of the manual: the head, links to the pages that the program writes, and a comment `<!-- pages -->`
/// where links to others belong; then what stands in <main>.
std::string html_page(std::string_view title, std::string_view main);

/// The style of all pages, style.css.
ManualFile html_style();

}  // namespace contactsim
