// Variables of the Fanuc dialect for which the machine is asked, and those that act when they are
// set: #3001, #5021, #2001 and their like.
//
// Owner: ProgramExecution, on the thread of the preparation. Owns the zero of the timer #3001. Each
// reading is a sync point; a setting is alone in its block.
#pragma once

#include "lang/run/channel_requests.h"
#include "lang/run/macro_variable.h"
#include "lang/run/parameter_store.h"

namespace stanok::lang {

class MacroRequests {
 public:
  // All must outlive this.
  MacroRequests(Vm& vm, BlockState& state, ParameterStore& parameters, PendingAnswer& pending,
                ChannelRequests& requests)
      : vm_(vm), state_(state), parameters_(parameters), pending_(pending), requests_(requests) {}

  // Executes a reading or setting of such a variable; false for all else.
  bool execute(const Instruction& instruction);
  // The answer to a reading of #5041 has come, or to a setting of #3001.
  void finish_position();
  void finish_timer(const Answer& answer);
  // M2 and M30 count a part (#3901).
  void count_part();

 private:
  bool read();
  bool set(const std::vector<SettingTarget>& targets);
  void read_machine(const MachineVariable& variable);
  void read_tool_value(const MachineVariable& variable);
  void set_machine(const MachineVariable& variable, double value);
  void write_table(const MachineVariable& variable, double value);
  [[nodiscard]] double override_switches(int number) const;
  void set_override_switches(int number, double value);
  [[nodiscard]] double unit_of_tool_value(int value) const;

  Vm& vm_;
  BlockState& state_;
  ParameterStore& parameters_;
  PendingAnswer& pending_;
  ChannelRequests& requests_;
  double single_block_ = 0.0;  // #3003, which changes nothing
  double timer_zero_s_ = 0.0;  // clock at which #3001 was 0
  double timer_set_ms_ = 0.0;  // what #3001 is set to, until the clock answers
  AxisIndex position_axis_;    // of the reading of #5041 that waits
};

}  // namespace stanok::lang
