// DaemonBench: the daemon's parts around a real machine with simulated drives, on a virtual clock
// and without sockets: everything but threads, so that a run repeats to the bit.
#pragma once

#include <gtest/gtest.h>
#include <spdlog/spdlog.h>

#include <deque>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "daemon/desk/dispatch.h"
#include "daemon/start/assembled_machine.h"
#include "tests/support/project_folders.h"
#include "tests/support/temporary_directory.h"

namespace stanok::daemon {

// The five-axis mill of the project: channel 1 works, channel 2 is the master.
inline const config::MachineFile& mill_of_the_bench() {
  static const config::MachineFile file = config::read_machine_file(
      stanok::testing::source_folder() + "/config/machines/e7106mf4.toml");
  return file;
}

class DaemonBench {
 public:
  // One request: its answer comes now or later.
  using Slot = std::shared_ptr<std::optional<CommandResult>>;

  explicit DaemonBench(const config::MachineFile& file = mill_of_the_bench())
      : assembly_({.file = file,
                   .drives = runtime::DriveChoice::simulated,
                   .program_roots = {here_.path()},
                   .machine = {}}),
        recorder_(assembly_.file(), "test", {}),
        machine_(assembly_, recorder_, here_.path(), {here_.path()}),
        dispatch_(machine_, {"test", here_.path(), here_.path() / "socket"},
                  [this] { shutdown_asked_ = true; }) {
    spdlog::set_level(spdlog::level::err);  // thousands of commands are no news
    cycles(cycles_until_drives_answer);
  }

  void program(const std::string& name, const std::string& text) {
    std::ofstream(here_.path() / name) << text;
  }

  // Sessions count from 0 and are there when they are first asked for.
  Slot ask(int session, const std::string& method,
           nlohmann::json parameters = nlohmann::json::object()) {
    const auto slot = std::make_shared<std::optional<CommandResult>>();
    protocol::RpcRequest request;
    request.id = 1;
    request.method = method;
    request.parameters = std::move(parameters);
    SessionState& asker = sessions_[session];
    asker.id = session;
    asker.role = protocol::Role::integrator;
    dispatch_.handle(asker, request, [slot, method](const CommandResult& outcome) {
      EXPECT_FALSE(slot->has_value()) << method << " was answered twice";
      *slot = outcome;
    });
    return slot;
  }
  // The answer, if it comes within so many cycles.
  std::optional<CommandResult> answer(const std::string& method,
                                      nlohmann::json parameters = nlohmann::json::object(),
                                      int cycles_max = 120'000) {
    const Slot slot = ask(0, method, std::move(parameters));
    for (int n = 0; n < cycles_max && !slot->has_value(); ++n) cycle();
    return *slot;
  }
  // Must be accepted.
  void demand(const std::string& method, nlohmann::json parameters = nlohmann::json::object()) {
    const auto outcome = answer(method, std::move(parameters));
    ASSERT_TRUE(outcome.has_value()) << method << " was not answered";
    ASSERT_TRUE(outcome->has_value())
        << method << ": " << outcome->error().code << " " << outcome->error().message;
  }

  const channels::CycleOutput& cycle() {
    // Bounded: a program may be an endless loop without a block.
    constexpr int steps_max = 20;
    bool worked = true;
    for (int step = 0; worked && step < steps_max; ++step) {
      worked = false;
      for (std::size_t k = 0; k < assembly_.file().machine.channels.size(); ++k) {
        worked = assembly_.machine().prepare(static_cast<int>(k)) != channels::Progress::blocked ||
                 worked;
      }
    }
    machine_.cycle(0);
    channels::Machine& machine = assembly_.machine();
    drain({assembly_.outputs(), machine.events(), machine.input_records(), machine.input_changes()},
          {&machine_});
    channels::OperatorReply reply;
    while (machine.replies().pop(reply)) dispatch_.on_reply(reply);
    newest_ = machine_.newest_output();
    dispatch_.tick(SteadyTime{} + std::chrono::milliseconds(newest_.cycle));
    return newest_;
  }
  void cycles(int count) {
    for (int n = 0; n < count; ++n) cycle();
  }

  [[nodiscard]] const channels::CycleOutput& output() const { return newest_; }
  [[nodiscard]] const channels::ChannelOutput& channel(int id) const {
    return newest_.channels[static_cast<std::size_t>(id - 1)];
  }
  [[nodiscard]] const std::filesystem::path& folder() const { return here_.path(); }
  [[nodiscard]] bool is_idle() { return assembly_.machine().is_idle(); }
  // A fault of one simulated drive, or `none` when it works again.
  void fail(std::string_view drive, plant::FaultKind fault) {
    ASSERT_TRUE(assembly_.inject_fault(drive, fault));
  }
  [[nodiscard]] bool shutdown_asked() const { return shutdown_asked_; }

 private:
  static constexpr int cycles_until_drives_answer = 50;

  stanok::testing::TemporaryDirectory here_;
  runtime::Assembly assembly_;
  Recorder recorder_;
  AssembledMachine machine_;
  bool shutdown_asked_ = false;
  Dispatch dispatch_;
  std::map<int, SessionState> sessions_;
  channels::CycleOutput newest_;
};

}  // namespace stanok::daemon
