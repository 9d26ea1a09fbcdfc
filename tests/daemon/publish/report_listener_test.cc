// The daemon adds what programs measure and print to the reports in the folder of its logs.
#include "daemon/publish/report_listener.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "tests/support/temporary_directory.h"

namespace stanok::daemon {
namespace {

TEST(ReportListener, AddsMeasurementsToTheReportOfTheMachine) {
  const testing::TemporaryDirectory folder;
  channels::Event event;
  event.cycle = 4711;
  event.channel = 1;
  for (int run = 0; run < 2; ++run) {
    ReportListener listener(folder.path() / "log", "mill");
    event.text = FixedText<240>("program started");
    listener.on_event(event);
    event.text = FixedText<240>("measured bore size=12.5");
    listener.on_event(event);
  }
  std::ifstream file(folder.path() / "log" / "mill-measurements.jsonl");
  std::string line;
  int lines = 0;
  while (std::getline(file, line)) {
    ++lines;
    EXPECT_NE(line.find("\"cycle\":4711,\"channel\":1,\"feature\":\"bore\",\"size\":12.5}"),
              std::string::npos)
        << line;
  }
  EXPECT_EQ(lines, 2);
}

TEST(ReportListener, AddsWhatProgramsPrintToTheFileOfTheMachine) {
  const testing::TemporaryDirectory folder;
  channels::Event event;
  for (int run = 0; run < 2; ++run) {
    ReportListener listener(folder.path() / "log", "mill");
    event.text = FixedText<240>("printed X12.346 T7");
    listener.on_event(event);
  }
  std::ifstream file(folder.path() / "log" / "mill-printed.txt");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(text, "X12.346 T7\nX12.346 T7\n");
}

}  // namespace
}  // namespace stanok::daemon
