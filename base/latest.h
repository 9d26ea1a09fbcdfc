// Latest<T>: a box that always holds the newest value; writer and reader never wait for each other.
//
// One writer, one reader. Three slots: the writer fills a free one and swaps it with the middle,
// the reader swaps the middle with its own when it is newer (a triple buffer).
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <type_traits>

#include "base/rt_safe.h"

namespace stanok {

template <class T>
class Latest {
  static_assert(std::is_trivially_copyable_v<T>, "what crosses into the cycle is plain data");

 public:
  void write(const T& value) RT_SAFE {
    slots_[back_] = value;
    back_ = middle_.exchange(back_ | fresh, std::memory_order_acq_rel) & index_mask;
  }

  // The newest value written; a default T before the first write.
  [[nodiscard]] const T& read() RT_SAFE {
    if ((middle_.load(std::memory_order_acquire) & fresh) != 0) {
      front_ = middle_.exchange(front_, std::memory_order_acq_rel) & index_mask;
    }
    return slots_[front_];
  }

 private:
  static constexpr std::uint32_t fresh = 4;
  static constexpr std::uint32_t index_mask = 3;
  std::array<T, 3> slots_{};
  std::uint32_t back_ = 0;
  std::atomic<std::uint32_t> middle_{1};
  std::uint32_t front_ = 2;
};

}  // namespace stanok
