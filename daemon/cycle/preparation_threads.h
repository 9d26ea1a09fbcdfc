// PreparationThreads: one thread per channel that works ahead of its motion.
//
// Each calls `prepare(channel)` again and again and sleeps a millisecond when the channel is
// blocked: commit horizon full, sync point, nothing to do. An exception is a fault of ours; it ends
// that thread and is told to `on_fault`.
//
// While the axes may come to rest for want of path, the thread has a real-time priority below the
// buses, where that is granted, for a part of the time: all of them together half of the computer,
// so that no program starves the rest. What goes beyond is done without it.
#pragma once

#include <functional>
#include <string_view>
#include <thread>
#include <vector>

#include "channels/machine/machine.h"

namespace stanok::daemon {

class PreparationThreads {
 public:
  using Prepare = std::function<channels::Progress(int index)>;
  using IsUrgent = std::function<bool(int index)>;
  using OnFault = std::function<void(int index, std::string_view reason)>;

  // Channels count from 0. The functions are called from several threads, each with the index of
  // its channel.
  PreparationThreads(int channels, Prepare prepare, IsUrgent is_urgent, OnFault on_fault);
  // Stops the threads and waits for them.
  ~PreparationThreads() = default;
  PreparationThreads(const PreparationThreads&) = delete;
  PreparationThreads& operator=(const PreparationThreads&) = delete;

 private:
  void run(const std::stop_token& stop, int index) const;

  int channels_;
  Prepare prepare_;
  IsUrgent is_urgent_;
  OnFault on_fault_;
  std::vector<std::jthread> threads_;  // last: the threads use the members above
};

}  // namespace stanok::daemon
