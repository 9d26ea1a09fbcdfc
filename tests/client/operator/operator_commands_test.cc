// Command line to method: every row of the table is reachable, values arrive checked.
#include "client/operator/operator_commands.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <optional>

#include "client/command_line/command_fault.h"
#include "client/command_line/offline.h"
#include "client/terminal/noun_command.h"
#include "tests/support/project_folders.h"

namespace stanok::client {
namespace {

using nlohmann::json;
using protocol::Method;
using ::testing::HasSubstr;
using ::testing::StartsWith;

// The call that a command line leads to; nothing when it is not understood.
std::optional<OperatorCall> call_for(const std::string& line) {
  CLI::App app;
  std::optional<OperatorCall> call;
  add_operator_commands(app, [&](const OperatorCall& made) { call = made; });
  try {
    app.parse(line);
  } catch (const CLI::ParseError&) {
    return std::nullopt;
  }
  return call;
}

std::string words_of(const Method& method) {
  std::string line(method.name);
  std::replace(line.begin(), line.end(), '.', ' ');
  return line;
}

std::string argument_for(const protocol::Parameter& parameter) {
  if (parameter.spelling == protocol::Spelling::file)
    return stanok::testing::source_folder() + "/README.md";
  switch (parameter.type) {
    case protocol::ParameterType::integer:
    case protocol::ParameterType::number:
      return std::to_string(static_cast<int>(parameter.maximum));
    case protocol::ParameterType::text:
      return "part.nc";
    case protocol::ParameterType::choice:
    case protocol::ParameterType::text_list:
      return std::string(parameter.choices.back());
  }
  return "";
}

// The required parameters, as they are written on the command line.
std::string arguments_for(const Method& method) {
  std::string line;
  for (const auto& parameter : method.parameters) {
    if (parameter.presence != protocol::Presence::required) continue;
    if (parameter.spelling == protocol::Spelling::option)
      line += " --" + std::string(parameter.name);
    line += " " + argument_for(parameter);
  }
  return line;
}

class EveryMethod : public ::testing::TestWithParam<Method> {};

TEST_P(EveryMethod, HasASubcommand) {
  const Method& method = GetParam();
  const std::string line = words_of(method) + arguments_for(method);
  const auto call = call_for(line);
  ASSERT_TRUE(call) << line;
  EXPECT_EQ(call->method->name, method.name);
  EXPECT_EQ(call->form, OutputForm::people);
}

TEST_P(EveryMethod, TakesJsonSocketAndTimeout) {
  const std::string line = words_of(GetParam()) + arguments_for(GetParam());
  const auto call = call_for(line + " --json --socket /tmp/x.sock --timeout 1.5");
  ASSERT_TRUE(call);
  EXPECT_EQ(call->form, OutputForm::json);
  EXPECT_EQ(call->socket, "/tmp/x.sock");
  EXPECT_DOUBLE_EQ(call->timeout_s, 1.5);
}

INSTANTIATE_TEST_SUITE_P(Table, EveryMethod,
                         ::testing::ValuesIn(protocol::methods().begin(),
                                             protocol::methods().end()),
                         [](const auto& row) {
                           std::string name(row.param.name);
                           std::replace(name.begin(), name.end(), '.', '_');
                           return name;
                         });

struct Case {
  const char* line;
  const char* method;
  const char* parameters;
};

class CommandLine : public ::testing::TestWithParam<Case> {};

TEST_P(CommandLine, BecomesMethodAndParameters) {
  const auto call = call_for(GetParam().line);
  ASSERT_TRUE(call) << GetParam().line;
  EXPECT_EQ(call->method->name, GetParam().method);
  EXPECT_EQ(call->parameters, json::parse(GetParam().parameters));
}

INSTANTIATE_TEST_SUITE_P(
    Examples, CommandLine,
    ::testing::Values(
        Case{"program run part.nc", "program.run", R"({"program":"part.nc"})"},
        Case{"program run part.nc --channel 2 --wait", "program.run",
             R"({"program":"part.nc","channel":2,"wait":"done"})"},
        Case{"program hold", "program.hold", "{}"},
        Case{"override feed 80 --channel 1", "override.feed", R"({"percent":80,"channel":1})"},
        Case{"override feed 87.5", "override.feed", R"({"percent":87.5})"},
        Case{"kinematics select 2", "kinematics.select", R"({"scheme":2})"},
        Case{"subscribe channels events --rate-hz 5", "subscribe",
             R"({"topics":["channels","events"],"rate_hz":5})"},
        Case{"drive fault X stuck", "drive.fault", R"({"drive":"X","fault":"stuck"})"},
        Case{"mdi G0X1", "mdi", R"({"text":"G0X1","wait":"done"})"},
        Case{"mdi G0X1 --wait", "mdi", R"({"text":"G0X1","wait":"done"})"},
        Case{"mdi G0X1 --no-wait", "mdi", R"({"text":"G0X1"})"},
        Case{"program start --no-wait", "program.start", "{}"}));

TEST(CommandLine, IsRefusedWithoutADaemonWhenAValueDoesNotFit) {
  for (const char* line :
       {"override feed 201", "override feed -- -1", "override feed fast", "override feed nan",
        "override feed", "program run", "program run a.nc --channel 0",
        "program run a.nc --channel 1.5", "program hold now", "machine", "machine fly",
        "subscribe everything", "channel list --rate 1", "drive fault X", "drive fault X asleep",
        "drive fault X off Y"}) {
    EXPECT_FALSE(call_for(line)) << line;
  }
}

TEST(CommandLine, SendsTheTextOfAFileAndItsName) {
  const std::string file = ::testing::TempDir() + "tables.toml";
  std::ofstream(file) << "[offset.G54]\nX = 1\n";
  const auto call = call_for("tool load " + file);
  ASSERT_TRUE(call);
  EXPECT_EQ(call->parameters, json({{"tables", "[offset.G54]\nX = 1\n"}, {"file", file}}));
  EXPECT_EQ(call_for("tool load " + file + " --file mine")->parameters["file"], "mine");
  EXPECT_FALSE(call_for("tool load " + ::testing::TempDir() + "missing.toml"));
  EXPECT_FALSE(call_for("tool load " + ::testing::TempDir())) << "a folder";
}

TEST(CommandLine, WatchSubscribesToAllChannels) {
  const auto call = call_for("watch --timeout 2");
  ASSERT_TRUE(call);
  EXPECT_EQ(call->method->name, "subscribe");
  EXPECT_EQ(call->parameters, json::parse(R"({"topics":["channels","events"]})"));
  EXPECT_EQ(call->view, OperatorView::overview);
}

TEST(CommandLine, StatusShowsTheMachineAndAllChannels) {
  const auto call = call_for("status --json");
  ASSERT_TRUE(call);
  EXPECT_EQ(call->method->name, "machine.status");
  EXPECT_EQ(call->view, OperatorView::status);
}

TEST(CommandLine, StopsAndResetsAllChannels) {
  for (const char* line : {"program hold", "program stop", "program reset", "alarm ack"}) {
    EXPECT_EQ(call_for(line)->called_for, CalledFor::one_channel) << line;
    EXPECT_EQ(call_for(std::string(line) + " --all")->called_for, CalledFor::every_channel) << line;
    EXPECT_FALSE(call_for(std::string(line) + " --all --channel 1")) << line;
  }
  EXPECT_FALSE(call_for("program start --all"));
}

struct WrongCommand {
  std::vector<std::string> words;
  const char* told;  // "": the words name a command
};

TEST(CommandFault, NamesTheNearestCommandOrThoseThereAre) {
  CLI::App app;
  int exit_code = 0;
  add_operator_commands(app, [](const OperatorCall&) {});
  add_offline_commands(app, exit_code);
  constexpr const char* listed = "`stanok --help` lists the commands\n";
  for (const WrongCommand& given : {
           WrongCommand{{"chek", "part.nc"},
                        "there is no command `stanok chek`; did you mean `stanok check`?\n"
                        "`stanok --help` lists the commands\n"},
           WrongCommand{{"--socket", "/x", "Program", "rum"},
                        "there is no command `stanok Program`; did you mean `stanok program`?\n"
                        "`stanok --help` lists the commands\n"},
           WrongCommand{{"program", "rnu", "a.nc"},
                        "there is no command `stanok program rnu`; did you mean `stanok program "
                        "run`?\n`stanok program --help` lists the commands\n"},
           WrongCommand{{"cache"}, "`stanok cache` needs one of its commands: "},
           WrongCommand{{"zzzzzzzzz"}, "there is no command `stanok zzzzzzzzz`\n"},
       }) {
    EXPECT_THAT(command_fault(app, given.words), StartsWith(given.told));
  }
  EXPECT_THAT(command_fault(app, std::vector<std::string>{"zzzzzzzzz"}), HasSubstr(listed));
  EXPECT_EQ(command_fault(app, std::vector<std::string>{"program", "run"}), "");
  EXPECT_EQ(command_fault(app, std::vector<std::string>{"check", "chek"}), "");
  EXPECT_THAT(command_fault(app, {}), StartsWith("`stanok` needs one of its commands: "));
}

TEST(NounCommand, IsSharedByOperatorAndOffLineCommands) {
  CLI::App app;
  add_operator_commands(app, [](const OperatorCall&) {});
  bool checked = false;
  noun_command(app, "machine", "").add_subcommand("check")->callback([&] { checked = true; });
  app.parse("machine check");
  EXPECT_TRUE(checked);
}

}  // namespace
}  // namespace stanok::client
