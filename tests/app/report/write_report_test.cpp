// SPDX-License-Identifier: BSD-3-Clause
#include "app/report/write_report.hpp"

#include <nlohmann/json.hpp>

#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

namespace {

std::vector<ReportRun> make_runs(const std::string& deck) {
  std::vector<ReportRun> runs(1);
  runs[0].name = "a<b & c.e";
  runs[0].deck.push_back({"d.i", deck});
  runs[0].found.add_warning("odd", {}, "what is <this>?");
  return runs;
}

}  // namespace

TEST_CASE("a page holds its libraries, its scripts and its data, and nothing that ends them early",
          "[app][report]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("r.html");
  write_report(path, make_runs("begin </script><!-- \xff\n"), {"THREE TEXT", "ORBIT TEXT", "CHART TEXT"});
  const std::string page = read_bytes(path);
  CHECK_THAT(page, Contains("THREE TEXT\nORBIT TEXT\nCHART TEXT"));
  CHECK_THAT(page, Contains("<title>a&lt;b &amp; c.e"));
  CHECK(page.find("<!--") == std::string::npos);
  const std::string head = "id=\"report-data\">";
  const std::size_t begin = page.find(head) + head.size(), end = page.find("</script>", begin);
  const auto data = nlohmann::json::parse(page.substr(begin, end - begin));
  CHECK(data["schema"] == "contactsim-report/1");
  const auto& run = data["runs"][0];
  CHECK(run["name"] == "a<b & c.e");
  CHECK(run["problems"][0]["text"] == "what is <this>?");
  CHECK(run["deck"]["files"][0]["text"] == "begin </script><!-- \xef\xbf\xbd\n");
  CHECK(run["mesh"].is_null());
}

TEST_CASE("a page replaces a page and nothing else", "[app][report]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("r.html");
  for (int i = 0; i < 2; ++i) CHECK_NOTHROW(write_report(path, make_runs("x"), {"a", "b", "c"}));
  write_bytes(directory.file("mesh.g"), "CDF\x01");
  CHECK_THROWS_WITH(write_report(directory.file("mesh.g"), make_runs("x"), {"a", "b", "c"}),
                    Contains("no HTML"));
}
