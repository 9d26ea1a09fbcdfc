// What people see: tables, objects, watch view, completion, explanations.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/catalogue.h"
#include "client/command_line/completion.h"
#include "client/command_line/explain_command.h"
#include "client/operator/operator_commands.h"
#include "client/operator/result_text.h"
#include "client/operator/run_progress.h"
#include "client/operator/watch_view.h"
#include "client/terminal/diagnostic_output.h"
#include "client/terminal/text_table.h"
#include "tests/client/fake_screen.h"

namespace stanok::client {
namespace {

using nlohmann::json;

const Terminal pipe_end(Screen::none);
const Terminal colour_terminal(Screen::coloured);

TEST(TextTable, AlignsNumbersRightAndTextsLeft) {
  TextTable table({"id", "name"});
  table.add_row({"1", "Fräse"});
  table.add_row({"12", "b"});
  EXPECT_EQ(table.text(pipe_end), "id  name\n 1  Fräse\n12  b\n");
}

TEST(ResultText, ShowsAListAsATable) {
  const json result = {{"channels",
                        {{{"id", 1},
                          {"name", "work"},
                          {"kind", "mill"},
                          {"axes", {"X", "Y"}},
                          {"scheme", 1},
                          {"state", "Reset"},
                          {"program_status", "Stopped"}}}}};
  EXPECT_EQ(result_text("channel.list", result, pipe_end),
            "id  name  kind  axes  scheme  state  program_status\n"
            " 1  work  mill  X, Y       1  Reset  Stopped\n");
}

TEST(ResultText, ShowsAnObjectLineByLineAndColoursTheState) {
  const json result = {
      {"state", "Active"}, {"id", 1}, {"alarm", nullptr}, {"position", {{"X", 1.25}, {"Y", -3.0}}}};
  EXPECT_EQ(result_text("process.status", result, pipe_end),
            "id        1\nstate     Active\nalarm     -\nposition  X 1.2500  Y -3\n");
  EXPECT_NE(result_text("process.status", result, colour_terminal).find("\033[32mActive\033[0m"),
            std::string::npos);
}

TEST(TextTable, ColoursStatesWhereTheTerminalShowsIt) {
  TextTable table({"id", "state"});
  table.add_row({"1", "Active"});
  EXPECT_EQ(table.text(colour_terminal), "\033[1mid  state\033[0m\n 1  \033[32mActive\033[0m\n");
  EXPECT_EQ(table.text(pipe_end), "id  state\n 1  Active\n");
}

TEST(DiagnosticOutput, ColoursSeverityAndCode) {
  Diagnostic diagnostic;
  diagnostic.code = "E4003";
  diagnostic.message = "nothing uses Q";
  EXPECT_EQ(coloured_text(diagnostic, colour_terminal),
            "\033[31merror[E4003]\033[0m: nothing uses Q\n");
  EXPECT_EQ(coloured_text(diagnostic, pipe_end), "error[E4003]: nothing uses Q\n");
  diagnostic.severity = Severity::warning;
  EXPECT_EQ(coloured_text(diagnostic, colour_terminal).find("\033[33mwarning[E4003]\033[0m"), 0U);
}

TEST(ResultText, ShowsErrorsOfAProgramAsStanokCheckDoes) {
  const json error = {{"code", "E4031"},
                      {"severity", "error"},
                      {"file", "part.nc"},
                      {"line", 3},
                      {"column", 7},
                      {"message", "two G codes of one group"},
                      {"help", {"drop G1"}},
                      {"notes", {{{"text", "the first one"}, {"line", 2}, {"file", "part.nc"}}}}};
  const json absent = {{"code", "E7001"},
                       {"severity", "error"},
                       {"file", "absent.nc"},
                       {"line", 0},
                       {"message", "cannot be read"}};
  EXPECT_EQ(
      result_text("program.check", {{"ok", false}, {"diagnostics", {error, absent}}}, pipe_end),
      "error[E4031]: two G codes of one group\n"
      "  --> part.nc:3:7\n"
      " note: the first one (part.nc:2)\n"
      " help: drop G1\n"
      "error[E7001]: cannot be read\n"
      "  --> absent.nc\n");
  EXPECT_EQ(result_text("program.check", {{"ok", true}, {"diagnostics", json::array()}}, pipe_end),
            "no errors\n");
}

TEST(ResultText, KeepsWhatADaemonSaysOnItsLine) {
  const json error = {{"code", "E4031"},
                      {"file", "a\nb"},
                      {"line", 1},
                      {"message", "red\033[31m\nline"},
                      {"help", {3, "x\ny"}}};
  const std::string text =
      result_text("program.check", {{"diagnostics", {error, 7, nullptr}}}, pipe_end);
  EXPECT_EQ(text.find('\033'), std::string::npos);
  EXPECT_EQ(text.find("a\nb"), std::string::npos);
  EXPECT_EQ(text.find("x\ny"), std::string::npos);
}

TEST(ResultExitCode, IsThatOfTheFirstError) {
  const json error = {{"code", "E4031"}, {"severity", "error"}};
  const json warning = {{"code", "E4090"}, {"severity", "warning"}};
  EXPECT_EQ(result_exit_code({{"ok", false}, {"diagnostics", {warning, error}}}), 6);
  EXPECT_EQ(result_exit_code({{"ok", true}, {"diagnostics", {warning}}}), 0);
  EXPECT_EQ(result_exit_code({{"ok", false}, {"alarm", {{"code", "E5101"}}}}), 6);
  EXPECT_EQ(result_exit_code({{"ok", false}, {"alarm", {{"code", "A3001"}}}}), 7);
  EXPECT_EQ(
      result_exit_code({{"ok", false}, {"alarm", {{"code", "W801"}, {"severity", "warning"}}}}), 1);
  EXPECT_EQ(result_exit_code({{"ok", false}, {"findings", json::array()}}), 1);
  EXPECT_EQ(result_exit_code({{"accepted", true}}), 0);
  EXPECT_EQ(result_exit_code(json::array()), 0);
}

TEST(ResultText, IsSilentWhenThereIsNothingToTell) {
  EXPECT_EQ(result_text("program.hold", {{"accepted", true}}, pipe_end), "");
}

TEST(WatchView, PrintsOneLinePerChangeIntoAPipe) {
  WatchView view(OutputForm::people, pipe_end);
  const json channel = {{"id", 1},   {"program_status", "Running"}, {"program", "a.nc"},
                        {"line", 3}, {"position", {{"X", 1.0}}},    {"speed_mm_s", 25.0}};
  const std::string first =
      view.shown("status", {{"full", true}, {"state", {{"channels", {{"1", channel}}}}}});
  EXPECT_EQ(first, "channel 1  Running  a.nc:3  X 1  1500 mm/min\n");
  const std::string second =
      view.shown("status", {{"full", false}, {"state", {{"channels", {{"1", {{"line", 4}}}}}}}});
  EXPECT_EQ(second, "channel 1  Running  a.nc:4  X 1  1500 mm/min\n");
}

TEST(WatchView, ShowsAllChannelsInAnOverview) {
  WatchView view(OutputForm::people, Terminal(Screen::monochrome, {100, 24}),
                 OperatorView::overview);
  FakeScreen screen(100, 24);
  const json work = {{"id", 1},
                     {"name", "work"},
                     {"state", "Active"},
                     {"line", 12},
                     {"program", "a.nc"},
                     {"program_status", "Running"},
                     {"speed_mm_s", 25.0},
                     {"override", {{"feed", 80.0}}},
                     {"remaining_s", 249.4},
                     {"position", {{"X", 1.5}, {"Y", -2.0}}},
                     {"alarm", nullptr}};
  const json master = {
      {"id", 2},
      {"name", "master"},
      {"state", "Interrupted"},
      {"program", nullptr},
      {"program_status", "Canceled"},
      {"remaining_s", 3849.0},
      {"alarm", {{"code", "E5101"}, {"text", "X is too far"}, {"file", "b.nc"}, {"line", 7}}}};
  screen.write(view.shown("status", {{"state", {{"channels", {{"1", work}, {"2", master}}}}}}));
  EXPECT_THAT(
      screen.lines(),
      ::testing::ElementsAre(
          "channel  name    state        status    program  mm/min  feed %  left     position",
          "      1  work    Active       Running   a.nc:12    1500      80  4:09     X 1.5000  Y "
          "-2",
          "      2  master  Interrupted  Canceled  -        -       -       1:04:09  -",
          "channel 2  b.nc:7: E5101 X is too far"));
}

TEST(WatchView, PassesNotificationsOnAsJson) {
  WatchView view(OutputForm::json, pipe_end);
  const json line = json::parse(view.shown("event", {{"seq", 4}}));
  EXPECT_EQ(line["method"], "event");
  EXPECT_EQ(line["params"]["seq"], 4);
}

TEST(BashCompletion, KnowsEveryNounVerbAndOption) {
  CLI::App app;
  add_operator_commands(app, [](const OperatorCall&) {});
  const std::string script = completion_script(app, "bash");
  for (const auto& method : protocol::methods()) {
    std::string path(method.name);
    std::replace(path.begin(), path.end(), '.', ' ');
    EXPECT_NE(script.find("\"" + path + "\") offered=\""), std::string::npos) << path;
  }
  EXPECT_NE(script.find("--channel"), std::string::npos);
}

TEST(Explanation, TellsEveryCode) {
  for (const CatalogueRow& row : catalogue()) {
    const std::string text = explanation(std::string(row.code));
    EXPECT_NE(text.find(row.title), std::string::npos);
    EXPECT_NE(text.find(row.remedy), std::string::npos);
  }
  EXPECT_EQ(explanation("e7001"), explanation("E7001"));
  EXPECT_EQ(explanation("E0000"), "");
}

TEST(ResultText, ShowsQueuesAsTheyWillRun) {
  const json queue{
      {"channel", 1},
      {"started", true},
      {"started_by", "uid 1000"},
      {"stopped_by", nullptr},
      {"under_way", 7},
      {"programs", {{{"id", 7}, {"program", "a.nc"}}, {{"id", 12}, {"program", "b.nc"}}}}};
  const json empty{{"channel", 2},          {"started", false},     {"started_by", nullptr},
                   {"stopped_by", "reset"}, {"under_way", nullptr}, {"programs", json::array()}};
  EXPECT_EQ(result_text("queue.start", {{"queues", {queue, empty}}}, pipe_end),
            "channel 1: started by uid 1000\n"
            "position  id  program\n"
            "       1   7  a.nc     in progress\n"
            "       2  12  b.nc\n"
            "channel 2: stopped: reset\n"
            "no program waiting\n");
}

}  // namespace
}  // namespace stanok::client
