// LiveDaemon: the daemon whole, with all its threads, its clock and its socket, inside the test.
//
// Two channels, ideal drives: 1 works with X and Y, which need no homing, 2 is the master.
#pragma once

#include <gtest/gtest.h>
#include <spdlog/spdlog.h>

#include <exception>
#include <fstream>
#include <string>
#include <thread>

#include "daemon/start/daemon.h"
#include "tests/daemon/raw_client.h"
#include "tests/support/temporary_directory.h"

namespace stanok::daemon {

class LiveDaemon {
 public:
  LiveDaemon() {
    spdlog::set_level(spdlog::level::err);
    std::ofstream(here_.path() / "m.toml") << machine_text();
    thread_ = std::thread([this] {
      DaemonOptions options;
      options.machine_file = here_.path() / "m.toml";
      options.state_directory = here_.path() / "state";
      options.socket = socket();
      options.lcm = "off";
      options.program_root = here_.path();
      options.drives = runtime::DriveChoice::ideal;
      exit_code_ = run_daemon(options);
    });
    while (!RawClient::is_answered(socket())) std::this_thread::yield();
  }
  ~LiveDaemon() {
    try {
      end();
    } catch (const std::exception& error) {
      ADD_FAILURE() << "the daemon does not end: " << error.what();
    }
  }
  LiveDaemon(const LiveDaemon&) = delete;
  LiveDaemon& operator=(const LiveDaemon&) = delete;

  [[nodiscard]] std::filesystem::path socket() const { return here_.path() / "op.sock"; }
  void program(const std::string& name, const std::string& text) const {
    std::ofstream(here_.path() / name) << text;
  }

  // The orderly end, once; the exit code of stanokd.
  int end() {
    if (!thread_.joinable()) return exit_code_;
    {
      RawClient client(socket());
      client.request(1, "system.shutdown");
      client.receive("id", 1);
    }
    thread_.join();
    return exit_code_;
  }

 private:
  static std::string machine_text() {
    std::string text = "[machine]\nname = \"live\"\nrequest_age_max = 30\n";
    for (const char* axis : {"X", "Y"}) {
      text += std::string("[[axis]]\nname = \"") + axis +
              "\"\nkind = \"linear\"\nmin = -500\nmax = 500\nvelocity_max = 250\n"
              "acceleration_max = 2500\njerk_max = 50000\n";
    }
    return text +
           "[[spindle]]\nid = 1\nspeed_max = 9000\n"
           "[[channel]]\nid = 1\nname = \"work\"\nkind = \"mill\"\naxes = [\"X\", \"Y\"]\n"
           "spindles = [1]\nscheme = 1\n"
           "[[channel.scheme]]\nid = 1\ntype = \"cartesian\"\naxes = [\"X\", \"Y\"]\n"
           "[[channel]]\nid = 2\nname = \"master\"\nkind = \"master\"\n";
  }

  stanok::testing::TemporaryDirectory here_;
  int exit_code_ = -1;
  std::thread thread_;
};

}  // namespace stanok::daemon
