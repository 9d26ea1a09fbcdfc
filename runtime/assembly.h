// Assembly: a Machine with its drives and its output ring, put together from a machine file.
//
// One cycle is read drives, machine cycle, write drives, hand the output on. No clock, no threads
// of its own but the bus', no sockets towards people: daemon and simulation call `cycle` at their
// own pace.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/ring.h"
#include "base/rt_safe.h"
#include "channels/machine/machine.h"
#include "config/files/machine_file.h"
#include "recording/format/encode_inputs.h"
#include "runtime/drive_side/drive_side.h"

namespace stanok::runtime {

struct AssemblyOptions {
  config::MachineFile file;
  DriveChoice drives = DriveChoice::ideal;
  std::vector<std::filesystem::path> program_roots;
  channels::MachineOptions machine;
  // Cycles kept for a slow reader of `outputs`; more are counted as lost. 0: there is no reader.
  std::size_t output_capacity = 1024;
  // Whether a machine at rest is spared the noise of its encoders (steady_feedback.h).
  bool steady_at_rest = false;
};

class Assembly {
 public:
  explicit Assembly(AssemblyOptions options);
  ~Assembly();
  Assembly(const Assembly&) = delete;
  Assembly& operator=(const Assembly&) = delete;

  [[nodiscard]] channels::Machine& machine();
  [[nodiscard]] const config::MachineFile& file() const;

  // Starts and stops the drive bus; nothing else.
  void start();
  void stop();

  // One real-time cycle. The output stays valid until the next call.
  // `sensors` of the spindles, where they do not come from the drives. `touched`: digital inputs
  // that are on because a simulated probe touches; nullptr: there is none.
  const channels::CycleOutput& cycle(std::span<const channels::OperatorEvent> events,
                                     std::span<const channels::SpindleSensors> sensors = {},
                                     const Signals* touched = nullptr) RT_SAFE;
  // One before which `lost` periods passed without a cycle: those in which the path may go on are
  // made up for (clock_gaps.h). The drives get the last output only, `outputs` has all of them.
  const channels::CycleOutput& late_cycle(std::int64_t lost,
                                          std::span<const channels::OperatorEvent> events) RT_SAFE;

  // Where an axis of the machine stands before the next cycle.
  [[nodiscard]] double position_of(int axis) const RT_SAFE;

  // The simulated cut, or nullptr.
  [[nodiscard]] const ProcessPlant* process_plant() const RT_SAFE;

  // What the last cycle was given of the drives; empty with ideal drives.
  [[nodiscard]] std::span<const channels::AxisFeedback> feedback() const RT_SAFE;

  // Program texts that were asked for since the last call; from one thread.
  [[nodiscard]] std::vector<recording::ProgramRead> program_reads();

  // Every cycle's output for the publisher; a full ring drops the newest, counted. Only with a
  // capacity.
  [[nodiscard]] Ring<channels::CycleOutput>& outputs();
  [[nodiscard]] std::uint64_t outputs_lost() const RT_SAFE;

  [[nodiscard]] DriveChoice drives() const;
  [[nodiscard]] drives::BusStatus drive_status() const;
  // Acknowledges the fault of one drive, as a reset of its channel would; from any thread. False:
  // there is no such drive.
  [[nodiscard]] bool reset_drive(std::string_view drive);
  // Makes an embedded drive fail, or work again; from one thread. False: no such drive.
  [[nodiscard]] bool inject_fault(std::string_view drive, plant::FaultKind fault);

 private:
  struct Parts;
  void carry_on() RT_SAFE;
  void compute(const channels::CycleInputs& inputs) RT_SAFE;
  std::unique_ptr<Parts> parts_;
};

}  // namespace stanok::runtime
