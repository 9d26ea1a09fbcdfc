// The program stanok-drives as a user runs it: options, output, exit codes, end by signal.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <modbus/modbus.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/plant/loopback.h"
#include "tests/support/project_folders.h"

namespace stanok::plant {
namespace {

const std::string program = stanok::testing::build_folder() + "/bin/stanok-drives";
const std::string machine = stanok::testing::source_folder() + "/config/machines/e7106mf4.toml";

// A running stanok-drives; its standard input and output are pipes, its standard error goes
// nowhere.
class Process {
 public:
  explicit Process(std::vector<std::string> arguments) {
    std::array<int, 2> pipe_ends{};
    std::array<int, 2> input_ends{};
    EXPECT_EQ(pipe2(pipe_ends.data(), O_CLOEXEC), 0);
    EXPECT_EQ(pipe2(input_ends.data(), O_CLOEXEC), 0);
    posix_spawn_file_actions_t actions{};
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, pipe_ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, input_ends[0], STDIN_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    arguments.insert(arguments.begin(), program);
    std::vector<char*> argv;
    for (std::string& argument : arguments) {
      argv.push_back(argument.data());
    }
    argv.push_back(nullptr);
    EXPECT_EQ(posix_spawn(&pid_, program.c_str(), &actions, nullptr, argv.data(), environ), 0);
    posix_spawn_file_actions_destroy(&actions);
    close(pipe_ends[1]);
    close(input_ends[0]);
    input_ = input_ends[1];
    output_ = fdopen(pipe_ends[0], "r");
  }
  ~Process() {
    if (pid_ > 0) {
      kill(pid_, SIGKILL);
      waitpid(pid_, nullptr, 0);
    }
    std::fclose(output_);
    if (input_ >= 0) close(input_);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  // The next line of output; empty at its end.
  std::string line() {
    std::array<char, 8192> text{};
    return std::fgets(text.data(), text.size(), output_) == nullptr ? "" : text.data();
  }

  void type(const std::string& text) const {
    EXPECT_EQ(write(input_, text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }
  void end_input() {
    close(input_);
    input_ = -1;
  }

  void signal(int number) const { kill(pid_, number); }

  int exit_code() {
    int status = 0;
    waitpid(pid_, &status, 0);
    pid_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  pid_t pid_ = 0;
  std::FILE* output_ = nullptr;
  int input_ = -1;
};

class StanokDrives : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(std::filesystem::exists(program)) << program << " is not built";
  }
};

TEST_F(StanokDrives, ServesTheMachineAndEndsOnASignal) {
  for (const int end : {SIGINT, SIGTERM}) {
    Process process({"--machine", machine, "--fault", "Y=trip"});
    int port = 0;
    ASSERT_EQ(std::sscanf(process.line().c_str(), "port %d on 127.0.0.1", &port), 1);
    EXPECT_EQ(process.line(), "unit 1  X\n");

    modbus_t* client = modbus_new_tcp("127.0.0.1", port);
    ASSERT_EQ(modbus_connect(client), 0);
    std::uint16_t fault_code = 0;
    modbus_set_slave(client, 2);
    EXPECT_EQ(modbus_read_registers(client, 110, 1, &fault_code), 1);
    EXPECT_EQ(fault_code, 0x2310);
    modbus_close(client);
    modbus_free(client);

    process.signal(end);
    EXPECT_EQ(process.exit_code(), 0);
  }
}

TEST_F(StanokDrives, TakesFaultsAndLoadsFromStandardInput) {
  Process process({"--machine", machine});
  int port = 0;
  ASSERT_EQ(std::sscanf(process.line().c_str(), "port %d on 127.0.0.1", &port), 1);
  modbus_t* client = modbus_new_tcp("127.0.0.1", port);
  ASSERT_EQ(modbus_connect(client), 0);
  const auto read_register = [&](int unit, int address) {
    std::uint16_t value = 0;
    modbus_set_slave(client, unit);
    EXPECT_EQ(modbus_read_registers(client, address, 1, &value), 1);
    return value;
  };
  process.type("nonsense\n\nfault Q off\nfault Y trip\nload S1 1500 12.5 85.5\n");
  EXPECT_TRUE(eventually([&] { return read_register(2, 110) == 0x2310; }));
  EXPECT_TRUE(eventually([&] { return read_register(201, 107) == 1500; }));
  EXPECT_EQ(read_register(201, 108), 125);
  EXPECT_EQ(read_register(201, 109), 855);
  process.end_input();
  EXPECT_EQ(read_register(1, 110), 0) << "it serves on";
  modbus_close(client);
  modbus_free(client);
  process.signal(SIGTERM);
  EXPECT_EQ(process.exit_code(), 0);
}

TEST_F(StanokDrives, DescribesItsUnitsAsJson) {
  Process process({"--machine", machine, "--json"});
  const std::string json = process.line();
  EXPECT_NE(json.find("\"port\":"), std::string::npos) << json;
  EXPECT_NE(json.find("{\"unit\":1,\"axis\":\"X\",\"kind\":\"axis\""), std::string::npos) << json;
  EXPECT_NE(json.find("{\"unit\":201,\"axis\":\"S1\",\"kind\":\"spindle\""), std::string::npos);
  process.signal(SIGTERM);
  EXPECT_EQ(process.exit_code(), 0);
}

struct EndCase {
  const char* name;
  std::vector<std::string> arguments;
  int exit_code;
};

class StanokDrivesEnds : public StanokDrives, public ::testing::WithParamInterface<EndCase> {};

TEST_P(StanokDrivesEnds, WithTheCodeOfTheCause) {
  Process process(GetParam().arguments);
  EXPECT_EQ(process.exit_code(), GetParam().exit_code);
}

INSTANTIATE_TEST_SUITE_P(
    AtOnce, StanokDrivesEnds,
    ::testing::Values(
        EndCase{"Help", {"--help"}, 0}, EndCase{"NoMachine", {}, 2},
        EndCase{"UnknownOption", {"--machine", machine, "--speed", "3"}, 2},
        EndCase{"UnknownAxis", {"--machine", machine, "--fault", "Q=off"}, 2},
        EndCase{"UnknownFault", {"--machine", machine, "--fault", "X=asleep"}, 2},
        EndCase{
            "BothPortAndLine", {"--machine", machine, "--port", "1502", "--rtu", "/dev/null"}, 2},
        EndCase{"NoSuchFile", {"--machine", "no-such-machine.toml"}, 1},
        EndCase{"NoSuchLine", {"--machine", machine, "--rtu", "/dev/no-such-line"}, 1}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace stanok::plant
