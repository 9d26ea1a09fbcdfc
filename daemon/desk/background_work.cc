#include "daemon/desk/background_work.h"

#include <algorithm>
#include <new>

#include "base/batch_thread.h"

namespace stanok::daemon {
namespace {

using protocol::Failure;
using protocol::FailureKind;

CommandResult cancelled() {
  return Unexpected<Failure>(
      Failure{FailureKind::refused, "E9017", "the request was cancelled", 0, {}});
}

// Short enough to need none.
CommandResult no_memory() {
  return Unexpected<Failure>(Failure{FailureKind::internal, "", "out of memory", 0, {}});
}

}  // namespace

BackgroundWork::BackgroundWork(Urgency urgency)
    : urgency_(urgency), thread_([this](const std::stop_token& stop) { serve(stop); }) {}

BackgroundWork::~BackgroundWork() {
  {
    const std::lock_guard lock(mutex_);
    at_work_.request_stop();
  }
  end_batch_thread(thread_);
}

void BackgroundWork::submit(int session, Work work, Answer answer) {
  {
    const std::lock_guard lock(mutex_);
    const auto of_session = std::count_if(waiting_.begin(), waiting_.end(), [&](const Task& task) {
      return task.session == session;
    });
    if (waiting_.size() < waiting_max && of_session < of_session_max) {
      waiting_.push_back(
          {.session = session, .work = std::move(work), .answer = std::move(answer)});
      wakes_.notify_one();
      return;
    }
  }
  answer(Unexpected<Failure>(
      Failure{FailureKind::refused, "E9007", "too many requests are waiting already", 0, {}}));
}

void BackgroundWork::cancel(int session) {
  const std::lock_guard lock(mutex_);
  for (Task& task : waiting_) {
    if (task.session == session) task.stop.request_stop();
  }
  if (session_at_work_ == session) at_work_.request_stop();
}

void BackgroundWork::tick() {
  Tasks done;
  {
    const std::lock_guard lock(mutex_);
    done.swap(done_);
  }
  for (const Task& task : done) task.answer(*task.outcome);
}

// A fault of the work costs its answer only.
CommandResult BackgroundWork::outcome_of(const Task& task) {
  try {
    try {
      if (task.stop.stop_requested()) return cancelled();
      CommandResult outcome = task.work(task.stop.get_token());
      return task.stop.stop_requested() ? cancelled() : std::move(outcome);
    } catch (const std::bad_alloc&) {
      return no_memory();
    } catch (const std::exception& error) {
      return Unexpected<Failure>(Failure{FailureKind::internal, "", error.what(), 0, {}});
    }
  } catch (...) {
    return no_memory();
  }
}

void BackgroundWork::carry_out(Task& task, const std::stop_token& stop) const {
  std::optional<BatchWork> batch;
  if (urgency_ == Urgency::batch) batch.emplace(stop);
  task.outcome = outcome_of(task);
  task.work = nullptr;
}

void BackgroundWork::serve(const std::stop_token& stop) {
  while (true) {
    Tasks one;
    {
      std::unique_lock lock(mutex_);
      if (!wakes_.wait(lock, stop, [this] { return !waiting_.empty(); })) return;
      one.splice(one.begin(), waiting_, waiting_.begin());
      session_at_work_ = one.front().session;
      at_work_ = one.front().stop;
    }
    carry_out(one.front(), stop);
    const std::lock_guard lock(mutex_);
    session_at_work_ = 0;
    done_.splice(done_.end(), one);
  }
}

}  // namespace stanok::daemon
