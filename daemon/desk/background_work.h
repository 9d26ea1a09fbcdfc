// BackgroundWork: work for clients that takes longer than a moment, in a thread of its own: files
// of a disk that may sleep, programs to check.
//
// One piece of work at a time, in the order of asking; the thread that submits never waits. Answers
// are given in `tick`, which that thread calls often. Who asks for too much is refused (E9007). The
// thread itself needs no memory: where memory ends, the answer says so.
#pragma once

#include <condition_variable>
#include <functional>
#include <list>
#include <mutex>
#include <optional>
#include <thread>

#include "daemon/desk/command_desk.h"

namespace stanok::daemon {

class BackgroundWork {
 public:
  static constexpr std::size_t waiting_max = 64;
  static constexpr int of_session_max = 8;

  // Looks now and then whether it is to stop, when it takes long; what it answers then is not told.
  using Work = std::function<CommandResult(const std::stop_token& stop)>;
  // With much to compute that nobody waits for (base/batch_thread.h), or as usual.
  enum class Urgency { usual, batch };

  explicit BackgroundWork(Urgency urgency);
  ~BackgroundWork();
  BackgroundWork(const BackgroundWork&) = delete;
  BackgroundWork& operator=(const BackgroundWork&) = delete;

  // The thread that submits:
  void submit(int session, Work work, Answer answer);
  // What the session asked for is answered with E9017 soon.
  void cancel(int session);
  void tick();

 private:
  struct Task {
    int session = 0;
    Work work;
    Answer answer;
    std::stop_source stop{};
    std::optional<CommandResult> outcome{};
  };
  using Tasks = std::list<Task>;  // whose places are passed on without memory

  void serve(const std::stop_token& stop);
  void carry_out(Task& task, const std::stop_token& stop) const;
  [[nodiscard]] static CommandResult outcome_of(const Task& task);

  Urgency urgency_;
  std::mutex mutex_;
  std::condition_variable_any wakes_;
  Tasks waiting_;
  Tasks done_;
  int session_at_work_ = 0;  // 0: none
  std::stop_source at_work_;
  std::jthread thread_;
};

}  // namespace stanok::daemon
