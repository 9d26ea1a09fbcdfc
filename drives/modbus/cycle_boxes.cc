#include "drives/modbus/cycle_boxes.h"

#include <algorithm>
#include <cmath>

namespace stanok::drives {

CycleBoxes::CycleBoxes(std::size_t drives, Duration timeout, Duration cycle)
    : boxes_(drives),
      cycle_(std::llround(cycle / second * 1e9)),
      timeout_cycles_(static_cast<std::uint32_t>(std::ceil(timeout / cycle))) {}

void CycleBoxes::write(std::span<const DriveTarget> targets, BusTime now) RT_SAFE {
  const std::size_t count = std::min(targets.size(), boxes_.size());
  for (std::size_t drive = 0; drive < count; ++drive) {
    boxes_[drive].target.write({targets[drive], now + cycle_});
  }
  writes_.fetch_add(1, std::memory_order_relaxed);
}

DriveTarget CycleBoxes::target(std::size_t drive, BusTime now) {
  const TimedTarget& newest = boxes_[drive].target.read();
  return carried_on(newest.target, static_cast<double>((now - newest.due).count()) * 1e-9);
}

void CycleBoxes::read(std::span<DriveFeedback> feedback) RT_SAFE {
  const std::size_t count = std::min(feedback.size(), boxes_.size());
  for (std::size_t drive = 0; drive < count; ++drive) {
    Boxes& boxes = boxes_[drive];
    feedback[drive] = boxes.feedback.read();
    const bool is_new = feedback[drive].sequence != boxes.sequence_seen;
    boxes.sequence_seen = feedback[drive].sequence;
    boxes.age_cycles = is_new ? 0 : boxes.age_cycles + 1;
    feedback[drive].age_cycles = boxes.age_cycles;
    feedback[drive].valid = feedback[drive].valid && boxes.age_cycles <= timeout_cycles_;
  }
}

}  // namespace stanok::drives
