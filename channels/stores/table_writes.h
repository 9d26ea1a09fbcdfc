// TableWrites: the newest writes of the tables, numbered from 1, so that whoever keeps a copy can
// follow them one by one.
//
// One writer, the cycle; any number of readers in other threads. A reader that is too far behind is
// told so: what it wants has been overwritten.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>

#include "base/numbered.h"
#include "base/rt_safe.h"

namespace stanok::channels {

class TableWrites {
 public:
  static constexpr int kept = 4096;

  struct Write {
    int cell = 0;
    double value = 0.0;
  };

  // The cycle. Whoever copies all cells sees by begun() whether one of them has changed meanwhile:
  // `kept_in`, the cell itself, is written in between.
  void add(const Write& write, std::atomic<double>& kept_in) RT_SAFE {
    const std::uint64_t number = newest_.load(std::memory_order_relaxed) + 1;
    begun_.store(number, std::memory_order_relaxed);
    std::atomic_thread_fence(std::memory_order_release);
    Entry& entry = entries_[place(number)];
    entry.cell.store(write.cell, std::memory_order_relaxed);
    entry.value.store(write.value, std::memory_order_relaxed);
    kept_in.store(write.value, std::memory_order_relaxed);
    newest_.store(number, std::memory_order_release);
  }

  [[nodiscard]] std::uint64_t newest() const RT_SAFE {
    return newest_.load(std::memory_order_acquire);
  }
  // The write that is under way, or the newest one. What was read before is as it was written if
  // this is less than `kept` farther.
  [[nodiscard]] std::uint64_t begun() const {
    std::atomic_thread_fence(std::memory_order_acquire);
    return begun_.load(std::memory_order_relaxed);
  }
  // Of 1 to newest(); nothing: it is not kept any more.
  [[nodiscard]] std::optional<Write> at(std::uint64_t number) const {
    const Entry& entry = entries_[place(number)];
    const Write write{.cell = entry.cell.load(std::memory_order_relaxed),
                      .value = entry.value.load(std::memory_order_relaxed)};
    if (begun() >= number + kept) return std::nullopt;
    return write;
  }

 private:
  struct Entry {
    std::atomic<int> cell{0};
    std::atomic<double> value{0.0};
  };

  static int place(std::uint64_t number) RT_SAFE { return static_cast<int>(number % kept); }

  NumberedArray<Entry, kept> entries_{};
  std::atomic<std::uint64_t> begun_{0};
  std::atomic<std::uint64_t> newest_{0};
};

}  // namespace stanok::channels
