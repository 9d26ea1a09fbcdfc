#include "channels/contract/output.h"

namespace stanok::channels {

std::string_view text_of(HoldCause cause) {
  switch (cause) {
    case HoldCause::operator_hold:
      return "feed hold by an operator";
    case HoldCause::program_stop:
      return "program stop";
    case HoldCause::channel_stop:
      return "channel_stop of another channel";
    case HoldCause::owner_failed:
      return "the program that started it has failed";
    case HoldCause::single_block:
      return "single block";
    case HoldCause::sensor_fault:
      return "the power sensor of force control";
    case HoldCause::none:
      break;
  }
  return "";
}

}  // namespace stanok::channels
