// A side of drives alone, without an assembly: a machine of two linear axes, and outputs as its
// channel would make them.
#pragma once

#include <fstream>
#include <memory>
#include <vector>

#include "runtime/drive_side/drive_side.h"
#include "tests/config/temporary_files.h"

namespace stanok::runtime {

inline constexpr std::size_t bench_axis_x = 0;
inline constexpr std::size_t bench_axis_y = 1;
inline constexpr double bench_start_y_mm = 12.5;

class DriveSideBench {
 public:
  explicit DriveSideBench(DriveChoice choice,
                          const std::string& drives_section = "[drives]\nbus = \"modbus-tcp\"\n")
      : file_(read(files_.folder(), drives_section)) {
    options_.on_at_start = true;
    side_ = make_drive_side(choice, {file_, options_});
    output_.channel_count = 1;
    output_.channels[0].id = 1;
    output_.channels[0].axis_count = 2;
    output_.channels[0].axes[bench_axis_y].position = bench_start_y_mm;
  }

  DriveSide& side() { return *side_; }
  config::MachineFile& file() { return file_; }
  channels::CycleOutput& output() { return output_; }

  // The drives of both axes on, or off.
  void power(channels::Switch to) {
    for (std::size_t k = 0; k < 2; ++k) {
      output_.channels[0].drives[k].enabled = to == channels::Switch::on;
      output_.channels[0].drives[k].brake_closed = to == channels::Switch::off;
    }
  }
  void cycle(const std::vector<channels::OperatorEvent>& events = {}) {
    side_->read(events);
    side_->write(output_);
  }
  // False: it did not come to that.
  template <class Condition>
  [[nodiscard]] bool cycle_until(Condition&& holds, int cycles_max = 2000) {
    for (int n = 0; n < cycles_max && !holds(); ++n) cycle();
    return holds();
  }
  [[nodiscard]] const channels::AxisFeedback& x() const { return side_->feedback()[bench_axis_x]; }
  [[nodiscard]] bool is_on() const {
    const auto feedback = side_->feedback();
    return feedback[bench_axis_x].enabled && feedback[bench_axis_y].enabled;
  }

 private:
  static config::MachineFile read(const std::filesystem::path& folder,
                                  const std::string& drives_section) {
    std::ofstream file(folder / "m.toml");
    file << "[machine]\nname = \"m\"\n";
    for (const char* const axis : {"name = \"X\"\nstart = 0", "name = \"Y\"\nstart = 12.5"}) {
      file << "[[axis]]\nkind = \"linear\"\nmin = -100\nmax = 100\nvelocity_max = 200\n"
              "acceleration_max = 1000\njerk_max = 20000\n"
           << axis << "\n";
    }
    file << "[[channel]]\nid = 1\nname = \"c\"\naxes = [\"X\", \"Y\"]\n" << drives_section;
    file.close();
    return config::read_machine_file(folder / "m.toml");
  }

  config::TemporaryFiles files_;
  config::MachineFile file_;
  channels::MachineOptions options_;
  std::unique_ptr<DriveSide> side_;
  channels::CycleOutput output_;
};

inline channels::OperatorEvent asked(const channels::OperatorCommand& command, int channel) {
  channels::OperatorEvent event;
  event.command = command;
  event.channel = channel;
  return event;
}

}  // namespace stanok::runtime
