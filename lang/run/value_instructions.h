// Instructions that read and set values the run knows itself: parameters and programmed state, no
// wait for the axes.
//
// Owner: ProgramExecution, on the thread of the preparation. Owns nothing: it moves values between
// the stack and their stores.
#pragma once

#include <optional>
#include <vector>

#include "lang/program/code.h"
#include "lang/run/block_state.h"
#include "lang/run/parameter_store.h"
#include "lang/run/vm.h"

namespace stanok::lang {

class ValueInstructions {
 public:
  // All must outlive this.
  ValueInstructions(Vm& vm, const BlockState& state, ParameterStore& parameters)
      : vm_(vm), state_(state), parameters_(parameters) {}

  // Executes one of these; false for other instructions.
  bool execute(const Instruction& instruction);

 private:
  void load_parameter(const Instruction& instruction);
  void take_settings(const std::vector<SettingTarget>& targets);
  void push_system_value(const Instruction& instruction);

  Vm& vm_;
  const BlockState& state_;
  ParameterStore& parameters_;
};

// The value of a system variable in programmed units; nothing, and why, when it has none.
[[nodiscard]] std::optional<double> system_value(const BlockState& state, std::string_view name,
                                                 double index, ValueFault& fault);

}  // namespace stanok::lang
