// A thread with much to compute that nobody waits for (sched(7), SCHED_BATCH), and its end, which
// somebody waits for.
//
// Never SCHED_IDLE: beside a busy computer such a thread stands for seconds wherever it is, also
// where it holds what the kernel lets one thread of a process have at a time (its map of memory),
// and a thread of real-time priority that takes memory waits for it.
#pragma once

#include <stop_token>
#include <thread>

namespace stanok {

// The thread that calls it, from now on until its stop is requested; where the system does not let
// it, it stays what it is.
void run_as_batch(const std::stop_token& stop);

// The same for a piece of work. Its thread has the usual class before and behind it.
class BatchWork {
 public:
  explicit BatchWork(const std::stop_token& stop) { run_as_batch(stop); }
  ~BatchWork();
  BatchWork(const BatchWork&) = delete;
  BatchWork& operator=(const BatchWork&) = delete;
};

// Requests its stop and waits for its end, with the usual class meanwhile.
void end_batch_thread(std::jthread& thread);

}  // namespace stanok
