#include "channels/preparation/program_requests.h"

namespace stanok::channels {
namespace {

using lang::RequestKind;

// What is asked of a channel.
Request request_of_channel(const lang::ProgramRequest& request) {
  const std::int32_t channel = request.channel;
  switch (request.kind) {
    case RequestKind::kinematics:
      return requests::KinematicsSelect{channel, request.number};
    case RequestKind::channel_load:
      return requests::ProgramLoad{channel, ShortText(request.text)};
    case RequestKind::channel_start:
      return requests::ProgramStart{channel};
    case RequestKind::channel_run:
      return requests::ProgramRun{channel, ShortText(request.text)};
    case RequestKind::channel_wait:
      return requests::EndWait{channel, request.seconds};
    case RequestKind::channel_stop:
      return requests::ProgramStop{channel};
    case RequestKind::channel_reset:
      return requests::ProgramReset{channel};
    case RequestKind::channel_state:
      return requests::StateRead{channel};
    case RequestKind::mark_state:
      return requests::MarkRead{channel, request.number};
    default:
      return requests::Standstill{};
  }
}

Request request_of_shared(const lang::ProgramRequest& request, const SharedVariables::Cell& cell) {
  const ShortText text(request.value_text);
  switch (request.kind) {
    case RequestKind::shared_write:
      if (cell.is_text) return requests::SharedTextWrite{cell.number, text};
      return requests::SharedNumberWrite{cell.number, request.value};
    case RequestKind::shared_combine:
      if (cell.is_text) return requests::SharedTextAppend{cell.number, text};
      return requests::SharedNumberCombine{cell.number, request.combination, request.value};
    default:
      if (cell.is_text) return requests::SharedTextRead{cell.number};
      return requests::SharedNumberRead{cell.number};
  }
}

Request request_of_input(const lang::ProgramRequest& request) {
  if (request.analog) return requests::AnalogRead{request.number};
  return requests::InputWait{request.number, static_cast<requests::InputEvent>(request.index),
                             request.seconds};
}

}  // namespace

Request table_request_of(const lang::ProgramRequest& request) {
  const requests::ToolRead tool{request.number, request.index, request.channel};
  const requests::OffsetRead offset{request.channel, request.number, request.index};
  switch (request.kind) {
    case RequestKind::tool_table_read:
      return tool;
    case RequestKind::tool_table_write:
      return requests::ToolWrite{tool, request.value};
    case RequestKind::offset_table_read:
      return offset;
    case RequestKind::offset_table_write:
      return requests::OffsetWrite{offset, request.value};
    default:
      return requests::Standstill{};
  }
}

Request request_of(const lang::ProgramRequest& request, const SharedVariables& shared) {
  switch (request.kind) {
    case RequestKind::spindle_to_axis:
      return requests::SpindleToAxis{request.number};
    case RequestKind::tap_out:
      return requests::TapOut{};
    case RequestKind::axis_to_spindle:
      return requests::AxisToSpindle{request.number};
    case RequestKind::terminate:
      return requests::Terminate{};
    case RequestKind::program_restart:
      return requests::ProgramRestart{};
    case RequestKind::probe_result:
      return requests::ProbeResult{};
    case RequestKind::machine_value:
      return requests::MachineValueRead{ShortText(request.text), request.index};
    case RequestKind::input_wait:
      return request_of_input(request);
    case RequestKind::mark_wait:
      return requests::MarkWait{request.number, request.channels};
    case RequestKind::shared_read:
    case RequestKind::shared_write:
    case RequestKind::shared_combine:
      return request_of_shared(request, shared.cell(request.text, request.index));
    case RequestKind::tool_table_read:
    case RequestKind::tool_table_write:
    case RequestKind::offset_table_read:
    case RequestKind::offset_table_write:
      return table_request_of(request);
    default:
      return request_of_channel(request);
  }
}

}  // namespace stanok::channels
