// ChannelErrands: what is asked of one channel and takes time: load, start, stop, reset, homing,
// change of kinematics, spindles that become axes; and what becomes of runs whose owner fails.
//
// Each function takes one step of an errand. Thread: the real-time cycle. Owner: the coordinator.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "base/numbered.h"
#include "base/rt_safe.h"
#include "channels/contract/command_rules.h"
#include "channels/coordinator/axis_ownership.h"
#include "channels/coordinator/channel_table.h"
#include "channels/coordinator/control_desk.h"
#include "channels/coordinator/errand.h"
#include "channels/coordinator/verdict.h"

namespace stanok::channels {

// What the runs of a channel do when the one that started them ends abnormally, by channel.
using OwnerFailures = NumberedArray<OwnerFailure, channels_max>;

// What is asked of a channel and takes time.
template <class Kind>
concept ChannelRequest =
    IsOneOf<Kind, requests::ProgramLoad, requests::Search, requests::ProgramStart,
            requests::ProgramRun, requests::LineRun, requests::ProgramStop, requests::ProgramReset,
            requests::Home, requests::KinematicsSelect, requests::ProgramReturn>;

class ChannelErrands {
 public:
  // All outlive the errands.
  ChannelErrands(const ChannelTable& channels, AxisOwnership& ownership, const ControlDesk& control,
                 const OwnerFailures& on_owner_failure, double cycle_s);

  [[nodiscard]] Verdict step(Errand& errand, const requests::ProgramLoad& request) RT_SAFE;
  [[nodiscard]] Verdict step(Errand& errand, const requests::Search& request) RT_SAFE;
  [[nodiscard]] Verdict step(Errand& errand, const requests::ProgramStart& request) RT_SAFE;
  [[nodiscard]] Verdict step(Errand& errand, const requests::ProgramRun& request) RT_SAFE;
  [[nodiscard]] Verdict step(Errand& errand, const requests::LineRun& request) RT_SAFE;
  [[nodiscard]] Verdict step(Errand& errand, const requests::ProgramStop& request) RT_SAFE;
  [[nodiscard]] Verdict step(Errand& errand, const requests::ProgramReset& request) RT_SAFE;
  [[nodiscard]] Verdict step(Errand& errand, const requests::Home& request) RT_SAFE;
  [[nodiscard]] Verdict step(Errand& errand, const requests::KinematicsSelect& request) RT_SAFE;
  [[nodiscard]] Verdict step(Errand& errand, const requests::ProgramReturn& request) RT_SAFE;
  // M902 of the asker: the spindle stops, the drive takes the position over where it stands;
  // which has not found its index pulse turns to it.
  [[nodiscard]] Verdict spindle_to_axis(Errand& errand, int spindle) RT_SAFE;
  [[nodiscard]] Verdict tap_out(Errand& errand) RT_SAFE;

  // A program that ends abnormally takes the runs that it started along, as configured.
  void follow_owners() RT_SAFE;

 private:
  [[nodiscard]] Channel& target_of(const Errand& errand) const RT_SAFE {
    return channels_[errand.target];
  }
  [[nodiscard]] double waited_s(const Errand& errand) const RT_SAFE {
    return static_cast<double>(errand.cycles) * cycle_s_;
  }
  [[nodiscard]] std::optional<Verdict> obstacle(const Errand& errand, OperatorAction action) const
      RT_SAFE;
  [[nodiscard]] std::optional<Verdict> claim(int index, lang::AxisSet axes) RT_SAFE;
  [[nodiscard]] Verdict await_drives(const Errand& errand) const RT_SAFE;
  [[nodiscard]] Verdict load(Errand& errand, const ShortText& text, Job job) RT_SAFE;
  [[nodiscard]] Verdict await_load(const Errand& errand) const RT_SAFE;
  // Loads and starts.
  [[nodiscard]] Verdict run(Errand& errand, const ShortText& text, Job job) RT_SAFE;
  [[nodiscard]] Verdict start(const Errand& errand, OperatorAction action, Job job) RT_SAFE;
  [[nodiscard]] Verdict begin_homing(Errand& errand, std::string_view axis) RT_SAFE;
  [[nodiscard]] Verdict await_axis(Errand& errand, Channel& asker, int spindle) RT_SAFE;
  [[nodiscard]] Verdict await_index(Channel& asker, int spindle) const RT_SAFE;

  const ChannelTable& channels_;
  AxisOwnership& ownership_;
  const ControlDesk& control_;
  OwnerFailures on_owner_failure_;
  double cycle_s_;
  // Who started the run of a channel, and in which run of its own; operator_asker: an operator.
  struct Owner {
    int channel = operator_asker;
    std::uint32_t run = 0;
  };
  NumberedArray<Owner, channels_max> owners_{};
};

}  // namespace stanok::channels
