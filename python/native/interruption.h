// Ctrl-C in a long call: the call lets the interpreter go on, asks it now and then whether a signal
// came, and ends early when its handler raised an exception.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <functional>

namespace stanok::python {

// One for each call, made with the GIL held. Handlers of signals run in the main thread only; calls
// in other threads are never interrupted, and do not ask: a thread that wants the GIL while the
// interpreter ends is ended in the middle of what it does.
class Interruption {
 public:
  Interruption() {
    const auto threading = pybind11::module_::import("threading");
    is_in_main_thread_ = threading.attr("current_thread")().is(threading.attr("main_thread")());
  }

  // Asked often, without the GIL. True: the call shall end.
  [[nodiscard]] std::function<bool()> asked() {
    return [this] { return has_come(); };
  }
  // With the GIL held, when the call has ended: throws what the handler raised.
  void rethrow() const {
    if (raised_) throw pybind11::error_already_set();
  }

 private:
  using Clock = std::chrono::steady_clock;
  // Between two looks: taking the GIL from a busy thread takes 5 ms.
  static constexpr std::chrono::milliseconds interval{100};

  [[nodiscard]] bool has_come() {
    if (raised_ || !is_in_main_thread_) return raised_;
    const auto now = Clock::now();
    if (now < next_) return false;
    next_ = now + interval;
    const pybind11::gil_scoped_acquire gil;
    raised_ = PyErr_CheckSignals() != 0;
    return raised_;
  }

  bool is_in_main_thread_ = false;
  bool raised_ = false;
  Clock::time_point next_ = Clock::now() + interval;
};

}  // namespace stanok::python
