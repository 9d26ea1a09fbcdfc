// Where the words of a channel come from, as clients get it.
#include "daemon/report/position_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/daemon/daemon_bench.h"

namespace stanok::daemon {
namespace {

using nlohmann::json;

json answer(DaemonBench& bench, const std::string& method, json parameters = json::object()) {
  const auto slot = bench.ask(0, method, std::move(parameters));
  return slot->has_value() && **slot ? ***slot : json();
}

std::vector<std::string> names_of(const json& axis) {
  std::vector<std::string> names;
  for (const json& term : axis["terms"]) names.push_back(term["name"]);
  return names;
}

// With all offsets 0 X reads 300 beside machine 0: the zero of the scheme is in no table.
TEST(PositionReport, NamesTheTermsOfEachWord) {
  DaemonBench bench;
  const json plain = answer(bench, "channel.position");
  EXPECT_FALSE(plain["axes"][0].contains("terms"));
  const json told = answer(bench, "channel.position", {{"why", 1}});
  const json& x = told["axes"][0];
  EXPECT_EQ(names_of(x),
            (std::vector<std::string>{"machine position of X", "zero of scheme 1 (cartesian)"}));
  EXPECT_EQ(x["terms"][1]["amount"], 300.0);
  EXPECT_EQ(x["terms"][1]["fixed"], true);
  EXPECT_EQ(x["shown"], told["position"]["X"]);
  EXPECT_EQ(plain["position"], told["position"]);
}

TEST(PositionReport, ShowsWhatTheStatusShows) {
  DaemonBench bench;
  const json told = answer(bench, "channel.position", {{"why", 1}});
  const json status = answer(bench, "channel.status");
  for (const char* member : {"situation", "scheme", "units", "diameter", "position", "point_W"})
    EXPECT_EQ(told[member], status[member]) << member;
}

}  // namespace
}  // namespace stanok::daemon
