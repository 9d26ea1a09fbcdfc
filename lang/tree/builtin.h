// Built-in functions and constants of high-level text: one row each.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "lang/contract/command.h"
#include "lang/tree/tree.h"
#include "lang/tree/value.h"

namespace stanok::lang {

// Computes a function; false when an argument is outside its domain.
using Evaluation = bool (*)(std::span<const Value> arguments, Value& result);

// What a function without an Evaluation does.
enum class Effect : std::uint8_t {
  none,           // it only computes
  message,        // msg, warn, log
  request,        // asks the channel: `request`
  terminate,      // ends the program with an alarm
  call_file,      // runs another program file as a subprogram
  channel_error,  // why the last channel function returned false
  mark,           // mark_set, mark_clear, mark_wait_soft: `mark`
  mark_wait,
  table,          // settable_zs and its kin: `request`
  argument,       // arg ("X"): a word of the block that called the macro
  has_argument,   // has_arg ("X")
  save_state,     // save_gvector
  restore_state,  // restore_gvector
};

struct Builtin {
  std::string_view name;
  Type result = Type::number;
  std::string_view arguments;  // n number, b bool, s string, a axis, x an axis or its
                               // name, p string or number, * any number of numbers
  int optional_arguments = 0;  // that many may be left out at the end
  Evaluation evaluate = nullptr;
  Effect effect = Effect::none;
  Message::Kind message = Message::Kind::message;
  RequestKind request = RequestKind::sync;
  std::string_view request_text;  // of a machine value
  std::string_view failure_code;  // statement form that returned false
  bool takes_channel = false;     // the first argument is a channel id
  bool refuses_own_channel = false;
  MarkCommand::Kind mark = MarkCommand::Kind::set;
};

// Marks of programs are 0 to 99, those of the machine builder 100 to 199.
inline constexpr int mark_max = 199;

// The row of a function by its folded name, or nullptr.
[[nodiscard]] const Builtin* find_builtin(std::string_view folded_name);
[[nodiscard]] std::span<const Builtin> builtins();

// The number behind PI, CH_RUNNING, GV_ALL, ...
[[nodiscard]] std::optional<double> find_builtin_constant(std::string_view folded_name);

struct SystemVariable {
  std::string_view name;
  Type result = Type::number;
  Type index = Type::none;  // none: without [ ]
  bool of_machine = false;  // reading it waits for the axes to stand
};
[[nodiscard]] const SystemVariable* find_system_variable(std::string_view folded_name);
[[nodiscard]] std::span<const SystemVariable> system_variables();

}  // namespace stanok::lang
