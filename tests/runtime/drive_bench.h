// DriveBench: a machine with simulated drives on the virtual clock, and an operator who asks it.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "runtime/assembly.h"
#include "tests/config/temporary_files.h"

namespace stanok::runtime {

using channels::OperatorAction;

// Five axes with incremental encoders; all the same but for their switches.
struct AxisPlace {
  double home_from = 0.0;
  double home_to = 0.0;
  double velocity = 20.0;
  double start = 0.0;
  int order = 1;
};

inline std::string machine_text(const std::vector<AxisPlace>& axes) {
  constexpr const char* names[] = {"X", "Y", "Z", "U", "V"};
  std::string text = "[machine]\nname = \"m\"\n";
  std::string list;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const AxisPlace& axis = axes[k];
    const auto number = [](double value) { return std::to_string(value); };
    // A switch beyond the travel is never met.
    const double mark =
        std::clamp(axis.velocity > 0.0 ? axis.home_from : axis.home_to, -99.0, 99.0);
    text +=
        std::string("[[axis]]\nname = \"") + names[k] +
        "\"\nkind = \"linear\"\nmin = -100\nmax = 100\nvelocity_max = 200\n"
        "acceleration_max = 1000\njerk_max = 20000\nstart = " +
        number(axis.start) + "\n[axis.homing]\norder = " + std::to_string(axis.order) +
        "\nvelocity = " + number(axis.velocity) + "\nposition = " + number(mark) +
        "\n[axis.plant]\nencoder = \"incremental\"\nhome_switch_from = " + number(axis.home_from) +
        "\nhome_switch_to = " + number(axis.home_to) +
        "\nlimit_switch_negative = -105\nlimit_switch_positive = 105\n";
    list += std::string(list.empty() ? "" : ", ") + "\"" + names[k] + "\"";
  }
  return text + "[[channel]]\nid = 1\nname = \"c\"\naxes = [" + list +
         "]\n[drives]\nbus = \"modbus-tcp\"\n";
}

class DriveBench {
 public:
  explicit DriveBench(const std::vector<AxisPlace>& axes)
      : DriveBench([&](const std::filesystem::path& folder) {
          std::ofstream(folder / "m.toml") << machine_text(axes);
          return config::read_machine_file(folder / "m.toml");
        }) {}
  // `read` gets a folder to write into.
  explicit DriveBench(const std::function<config::MachineFile(const std::filesystem::path&)>& read)
      : assembly_({.file = read(files_.folder()),
                   .drives = DriveChoice::simulated,
                   .program_roots = {files_.folder()},
                   .machine = {},
                   .output_capacity = 0}) {
    files_.write("part.nc", "G1 X1 F6000\nM30\n");
    ask(OperatorAction::machine_on);
    run(1.0);
  }

  std::uint64_t ask(OperatorAction action, const std::string& text = "", double value = 0.0,
                    double value_2 = 0.0) {
    channels::OperatorEvent event;
    event.id = ++last_id_;
    event.channel = action == OperatorAction::machine_on ? 0 : 1;
    event.command =
        channels::command_of(
            {.action = action, .value = value, .value_2 = value_2, .text = std::string_view(text)})
            .value();
    events_.push_back(event);
    return event.id;
  }

  // A fault of one simulated drive, or `none` when it works again.
  void fail(std::string_view drive, plant::FaultKind fault) {
    ASSERT_TRUE(assembly_.inject_fault(drive, fault));
  }
  void program(const std::string& name, const std::string& text) { files_.write(name, text); }
  [[nodiscard]] channels::Machine& machine() { return assembly_.machine(); }
  [[nodiscard]] const config::MachineFile& machine_file() { return assembly_.file(); }

  // Until the reply to `id`; its code, or "ok".
  std::string reply_to(std::uint64_t id, double within_s = 120.0) {
    for (int k = 0; k < static_cast<int>(within_s * 1000.0); ++k) {
      cycle();
      channels::OperatorReply reply;
      while (assembly_.machine().replies().pop(reply)) {
        if (reply.id != id) continue;
        last_text_ = std::string(reply.text.view());
        return reply.ok ? "ok" : std::string(reply.code.view());
      }
    }
    return "no reply";
  }

  void run(double seconds) {
    for (int k = 0; k < static_cast<int>(seconds * 1000.0); ++k) cycle();
  }

  const channels::ChannelOutput& cycle() {
    for (int k = 0; k < output_count(); ++k) {
      while (assembly_.machine().prepare(k) != channels::Progress::blocked) {
      }
    }
    output_ = &assembly_.cycle(events_).channels[0];
    events_.clear();
    return *output_;
  }

  [[nodiscard]] int output_count() {
    return static_cast<int>(assembly_.file().machine.channels.size());
  }
  [[nodiscard]] const channels::ChannelOutput& output() const { return *output_; }
  [[nodiscard]] const std::string& text() const { return last_text_; }
  [[nodiscard]] bool is_homed(std::size_t k) const { return output_->feedback[k].referenced; }
  // Of the plant, whatever the encoder counts.
  [[nodiscard]] double setpoint(std::size_t k) const { return output_->axes[k].position; }

 private:
  config::TemporaryFiles files_;
  Assembly assembly_;
  std::vector<channels::OperatorEvent> events_;
  std::uint64_t last_id_ = 0;
  const channels::ChannelOutput* output_ = nullptr;
  std::string last_text_;
};

}  // namespace stanok::runtime
