#include "runtime/force_controls.h"

namespace stanok::runtime {

ForceControls::ForceControls(const config::MachineFile& file) {
  for (const channels::ChannelConfig& channel : file.machine.channels) {
    controls_.push_back(channel.force_control
                            ? std::make_unique<process::ForceControl>(file.process.control)
                            : nullptr);
  }
}

channels::MachineOptions ForceControls::given_to(channels::MachineOptions options) const {
  options.feed_modifiers.clear();
  for (const auto& control : controls_) options.feed_modifiers.push_back(control.get());
  return options;
}

}  // namespace stanok::runtime
