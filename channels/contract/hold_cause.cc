#include "channels/contract/output.h"

namespace stanok::channels {

std::string_view text_of(HoldCause cause) {
  switch (cause) {
    case HoldCause::operator_hold:
      return "feed hold by an operator";
    case HoldCause::program_stop:
      return "program stop";
    case HoldCause::channel_stop:
      return "channel_stop by another channel";
    case HoldCause::owner_failed:
      return "the program that started this one failed";
    case HoldCause::single_block:
      return "single block";
    case HoldCause::sensor_fault:
      return "a fault of the power sensor of force control";
    case HoldCause::clock_gap:
      return "an interruption of the control";
    case HoldCause::changed_length:
      return "a length of the tool that was changed in a hold: return to the path";
    case HoldCause::none:
      break;
  }
  return "";
}

std::string_view name_of(WaitCause cause) {
  switch (cause) {
    case WaitCause::dwell:
      return "dwell";
    case WaitCause::spindle:
      return "spindle";
    case WaitCause::brakes:
      return "brakes";
    case WaitCause::end:
      return "end";
    case WaitCause::mark:
      return "mark";
    case WaitCause::input:
      return "input";
    case WaitCause::channel:
      return "channel";
    case WaitCause::machine:
      return "machine";
    case WaitCause::nothing:
      break;
  }
  return "";
}

}  // namespace stanok::channels
