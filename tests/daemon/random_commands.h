// RandomCommands: requests drawn from the command table itself, so that a new method is drawn, too:
// right ones, wrong ones, and values at the ends of their ranges.
#pragma once

#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "protocol/contract/method_table.h"
#include "tests/daemon/desk/accepted_parameters.h"

namespace stanok::daemon {

struct RandomCommand {
  std::string method;
  nlohmann::json parameters = nlohmann::json::object();
};

class RandomCommands {
 public:
  explicit RandomCommands(std::uint64_t seed) : random_(seed) {
    for (const protocol::Method& method : protocol::methods()) {
      // The end of the daemon is tested elsewhere; a role that is given up does not come back.
      if (method.name == "system.shutdown" || method.name == "session.role") continue;
      if (protocol::noun(method) == "machine") continue;  // comes by itself, more rarely
      // Programs that change in another thread would make runs that cannot be repeated.
      if (method.role == protocol::Role::programmer || method.name == "program.check" ||
          method.name == "program.estimate" || calculates(method) ||
          method.name == "workpiece.surface" || method.name.starts_with("history."))
        continue;
      methods_.push_back(&method);
    }
  }

  [[nodiscard]] int pick(int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random_);
  }

  RandomCommand next() {
    // What makes and keeps programs running comes more often than what ends them all.
    static const std::vector<std::string> often = {
        "machine.on",  "machine.on",    "program.run",    "program.run",
        "program.run", "program.start", "program.resume", "program.resume",
        "mdi",         "jog",           "program.hold",   "program.reset"};
    const int chance = pick(0, 99);
    if (chance == 0) return {.method = pick(0, 3) == 0 ? "machine.estop" : "machine.off"};
    const protocol::Method& method =
        chance < 45 ? *protocol::find_method(often[static_cast<std::size_t>(pick(0, last(often)))])
                    : *methods_[static_cast<std::size_t>(pick(0, last(methods_)))];
    RandomCommand command{std::string(method.name)};
    for (const protocol::Parameter& parameter : method.parameters) {
      const bool is_wanted = parameter.presence == protocol::Presence::required;
      if (is_wanted ? pick(0, 199) != 0 : pick(0, 1) == 0)
        command.parameters[std::string(parameter.name)] = value_of(parameter);
    }
    return command;
  }

 private:
  template <class List>
  [[nodiscard]] static int last(const List& list) {
    return static_cast<int>(list.size()) - 1;
  }
  template <class List>
  [[nodiscard]] auto one_of(const List& list) {
    return list[static_cast<std::size_t>(pick(0, last(list)))];
  }

  [[nodiscard]] nlohmann::json value_of(const protocol::Parameter& parameter) {
    switch (parameter.type) {
      case protocol::ParameterType::integer:
      case protocol::ParameterType::number:
        return number_of(parameter);
      case protocol::ParameterType::text:
        return text_of(parameter.name);
      case protocol::ParameterType::choice:
        return std::string(one_of(parameter.choices));
      case protocol::ParameterType::text_list:
        return nlohmann::json::array({std::string(one_of(parameter.choices))});
    }
    return nullptr;
  }

  [[nodiscard]] nlohmann::json number_of(const protocol::Parameter& parameter) {
    if (parameter.name == "channel") return pick(0, 19) == 0 ? pick(1, 9) : pick(1, 2);
    if (parameter.name == "scheme") return pick(0, 3);
    if (parameter.name == "velocity") return pick(-400, 400);
    if (parameter.name == "percent") return pick(0, 200);
    const double low = parameter.minimum;
    const double high = std::min(parameter.maximum, 100.0);
    switch (pick(0, 9)) {
      case 0:
        return low;
      case 1:
        return parameter.maximum;
      case 2:
        return -1e9;
      default:
        return parameter.type == protocol::ParameterType::integer
                   ? nlohmann::json(pick(static_cast<int>(low), static_cast<int>(high)))
                   : nlohmann::json(std::uniform_real_distribution<double>(std::max(low, -100.0),
                                                                           high)(random_));
    }
  }

  [[nodiscard]] std::string text_of(std::string_view name) {
    static const std::vector<std::string> programs = {"master.nc", "work.nc",    "work.nc",
                                                      "stops.nc",  "endless.nc", "fails.nc",
                                                      "broken.nc", "missing.nc"};
    static const std::vector<std::string> lines = {"G0 X10 Y5",
                                                   "G1 X-20 F3000",
                                                   "G4 P0.02",
                                                   "M3 S500",
                                                   "M0",
                                                   "M30",
                                                   "#kinematics (2, 1)",
                                                   "#kinematics (1, 1)",
                                                   "X1 )(",
                                                   "num aa = 1;",
                                                   "while (true) {}",
                                                   "terminate (1, \"\");",
                                                   "G91 G0 X900",
                                                   "channel_reset (2);"};
    static const std::vector<std::string> axes = {"X", "Y", "Z", "B", "C", "S1", "Q", ""};
    static const std::vector<std::string> offsets = {"G54", "G55", "G59.3", "G54.1 P1", "G12"};
    if (name == "program") return one_of(programs);
    if (name == "text") return one_of(lines);
    if (name == "offset") return one_of(offsets);
    return one_of(axes);
  }

  std::mt19937_64 random_;
  std::vector<const protocol::Method*> methods_;
};

// The programs that random commands name, besides one that is not there.
inline std::vector<std::pair<std::string, std::string>> programs_of_random_commands() {
  return {{"master.nc",
           "channel_run (1, \"work.nc\");\nchannel_wait (1);\n#kinematics (2, 1)\n"
           "channel_run (1, \"work.nc\");\nchannel_wait (1);\n#kinematics (1, 1)\nM30\n"},
          {"work.nc",
           "G90 G54 S1000 M3\nG0 X20 Y10\nG1 X60 F6000\nG2 X80 Y30 R20\nG1 Y-20\nM5\nG0 X0 Y0\n"
           "M30\n"},
          {"stops.nc", "G90\nG1 X5 F3000\nM0\nX10\nM1\nX0\nM30\n"},
          {"endless.nc", "G90 F12000\nwhile (true) {\nG1 X100\nG1 X-100\n}\nM30\n"},
          {"fails.nc", "G90\nG1 X30 F6000\nterminate (1234, \"as it shall\");\nM30\n"},
          {"broken.nc", "G90\nG1 X(\nM30\n"}};
}

}  // namespace stanok::daemon
