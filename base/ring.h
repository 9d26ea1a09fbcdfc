// A queue of fixed capacity for one producer thread and one consumer thread whose consumer may look
// ahead.
//
// boost::lockfree::spsc_queue hides all but its first element; the interpolator and the override
// planner must read the path that lies ahead, hence this class. Memory is taken once, in the
// constructor.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>

#include "base/assert.h"
#include "base/rt_safe.h"

namespace stanok {

template <class T>
class Ring {
  static_assert(std::is_trivially_copyable_v<T>, "what crosses into the cycle is plain data");

 public:
  explicit Ring(std::size_t capacity) : capacity_(capacity), slots_(new T[capacity]{}) {
    STANOK_ASSERT(capacity > 0);
  }

  [[nodiscard]] std::size_t capacity() const RT_SAFE { return capacity_; }
  // Producer. Returns false when the ring is full; nothing is lost then.
  [[nodiscard]] bool push(const T& value) RT_SAFE {
    const std::size_t tail = tail_.load(std::memory_order_relaxed);
    if (tail - head_.load(std::memory_order_acquire) == capacity_) return false;
    slots_[tail % capacity_] = value;
    tail_.store(tail + 1, std::memory_order_release);
    return true;
  }
  // Elements pushed since construction.
  [[nodiscard]] std::size_t pushed() const RT_SAFE { return tail_.load(std::memory_order_acquire); }
  // Elements given back since construction.
  [[nodiscard]] std::size_t popped() const RT_SAFE { return head_.load(std::memory_order_acquire); }
  [[nodiscard]] std::size_t space() const RT_SAFE {
    return capacity_ -
           (tail_.load(std::memory_order_relaxed) - head_.load(std::memory_order_acquire));
  }

  // Consumer. It sees the first `count` elements pushed since construction, or all of them when
  // there are fewer, until it is told anew; without being told, whatever there is. What it does
  // then depends on what it was shown, not on how far the producer has come meanwhile.
  void show(std::size_t count) RT_SAFE {
    is_limited_ = true;
    shown_ = count < pushed() ? count : pushed();
  }
  // Elements that the consumer has been shown since construction.
  [[nodiscard]] std::size_t shown() const RT_SAFE { return is_limited_ ? shown_ : pushed(); }
  [[nodiscard]] std::size_t size() const RT_SAFE {
    return shown() - head_.load(std::memory_order_relaxed);
  }
  [[nodiscard]] bool empty() const RT_SAFE { return size() == 0; }

  // Consumer. The element `index` places behind the front; index < size().
  [[nodiscard]] const T& operator[](std::size_t index) const RT_SAFE {
    return slots_[(head_.load(std::memory_order_relaxed) + index) % capacity_];
  }
  [[nodiscard]] const T& front() const RT_SAFE { return (*this)[0]; }

  // Consumer. Gives the first `count` places back to the producer; count <= size().
  void pop_front(std::size_t count = 1) RT_SAFE {
    head_.store(head_.load(std::memory_order_relaxed) + count, std::memory_order_release);
  }
  [[nodiscard]] bool pop(T& value) RT_SAFE {
    if (empty()) return false;
    value = front();
    pop_front();
    return true;
  }

 private:
  static constexpr std::size_t cache_line = 64;
  std::size_t capacity_;
  std::unique_ptr<T[]> slots_;
  bool is_limited_ = false;
  std::size_t shown_ = 0;
  alignas(cache_line) std::atomic<std::size_t> head_{0};
  alignas(cache_line) std::atomic<std::size_t> tail_{0};
};

}  // namespace stanok
