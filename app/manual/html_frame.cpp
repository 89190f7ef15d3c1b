// SPDX-License-Identifier: BSD-3-Clause
#include "app/manual/html_frame.hpp"

#include <fmt/format.h>

#include "core/base/version.hpp"

namespace contactsim {

std::string html_text(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '&':
        escaped += "&amp;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string html_anchor(std::string_view text) {
  std::string anchor;
  for (const char c : text) {
    const bool is_upper = c >= 'A' && c <= 'Z';
    if (is_upper || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) {
      anchor += is_upper ? static_cast<char>(c - 'A' + 'a') : c;
    } else if (!anchor.empty() && anchor.back() != '-') {
      anchor += '-';
    }
  }
  while (!anchor.empty() && anchor.back() == '-') anchor.pop_back();
  return anchor;
}

std::string html_page(std::string_view title, std::string_view main) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n<title>{} - contactsim {}</title>\n"
      "<link rel=\"stylesheet\" href=\"style.css\">\n</head>\n<body>\n<nav>\n<strong>contactsim {}</strong>\n"
      "<!-- pages -->\n"
      "<a href=\"command_line.html\">Command line</a>\n<a href=\"reference.html\">Commands of a deck</a>\n"
      "<a href=\"variables.html\">Output variables</a>\n"
      "<a href=\"coming_from.html\">If you come from another program</a>\n</nav>\n"
      "<main>\n{}</main>\n</body>\n</html>\n",
      html_text(title), version, version, main);
}

ManualFile html_style() {
  return {"style.css", R"(:root { color-scheme: light dark; }
body { margin: 0; display: flex; font: 16px/1.5 system-ui, sans-serif; }
nav { position: sticky; top: 0; box-sizing: border-box; width: 15rem; height: 100vh; overflow: auto; padding: 1rem;
  flex: none; border-right: 1px solid #8886; font-size: 90%; }
nav a { display: block; margin: .3rem 0; text-decoration: none; }
nav a.within { margin-left: 1rem; font-size: 92%; }
main { padding: 1rem 2rem; min-width: 0; max-width: 60rem; }
h2, h3 { margin-top: 2rem; }
table { border-collapse: collapse; width: 100%; margin: 1rem 0; }
th, td { text-align: left; vertical-align: top; padding: .3rem .6rem; border-bottom: 1px solid #8884; }
pre { background: #8882; padding: .7rem; overflow: auto; font-size: 85%; line-height: 1.35; }
code { font-size: 92%; }
img { max-width: 100%; }
input[type=search] { font: inherit; width: 100%; padding: .4rem; margin: .5rem 0; box-sizing: border-box; }
.row { margin: .9rem 0; }
.row dl { display: grid; grid-template-columns: 7rem 1fr; margin: .2rem 0 0 1.5rem; font-size: 92%; }
.row dd { margin: 0; }
.row p { margin: .1rem 0 .1rem 1.5rem; }
.refused > code { color: #c33; }
.ignored > code { color: #888; }
[hidden] { display: none; }
@media (max-width: 50rem) { body { display: block; } nav { position: static; width: auto; height: auto; } }
)"};
}

}  // namespace contactsim
