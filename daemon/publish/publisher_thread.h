// PublisherThread: brings what the cycle left in its rings to everybody who is interested.
//
// The only consumer of the rings. Every output, event and input record goes to every listener, in
// the order of the cycle. Listeners are called from this thread only. Where priorities are granted
// it has one below all that moves axes, with at most three quarters of a processor: other work on
// the computer costs no setpoint of a recording.
#pragma once

#include <functional>
#include <string_view>
#include <thread>
#include <vector>

#include "base/ring.h"
#include "channels/contract/input_change.h"
#include "channels/contract/operator_event.h"
#include "channels/contract/output.h"
#include "recording/format/encode_inputs.h"

namespace stanok::daemon {

class CycleListener {
 public:
  CycleListener() = default;
  virtual ~CycleListener() = default;
  CycleListener(const CycleListener&) = delete;
  CycleListener& operator=(const CycleListener&) = delete;

  virtual void on_output(const channels::CycleOutput& output) { static_cast<void>(output); }
  virtual void on_program_read(const recording::ProgramRead& read) { static_cast<void>(read); }
  virtual void on_event(const channels::Event& event) { static_cast<void>(event); }
  virtual void on_input(const channels::InputRecord& input) { static_cast<void>(input); }
  virtual void on_change(const channels::InputChange& change) { static_cast<void>(change); }
};

struct CycleRings {
  Ring<channels::CycleOutput>& outputs;
  Ring<channels::Event>& events;
  Ring<channels::InputRecord>& inputs;
  Ring<channels::InputChange>& changes;
  std::function<std::vector<recording::ProgramRead>()> program_reads{};
};

// Hands over what is in the rings now: texts and inputs before the outputs they led to, so that a
// log that ends anywhere lacks no input of a setpoint it has. Returns how many records there were.
std::size_t drain(const CycleRings& rings, const std::vector<CycleListener*>& listeners);

class PublisherThread {
 public:
  using OnFault = std::function<void(std::string_view reason)>;

  // Rings and listeners outlive the thread.
  PublisherThread(const CycleRings& rings, std::vector<CycleListener*> listeners, OnFault on_fault);
  // Drains the rings a last time and waits for the thread.
  ~PublisherThread() = default;
  PublisherThread(const PublisherThread&) = delete;
  PublisherThread& operator=(const PublisherThread&) = delete;

 private:
  void run(const std::stop_token& stop) const;

  CycleRings rings_;
  std::vector<CycleListener*> listeners_;
  OnFault on_fault_;
  std::jthread thread_;  // last: it uses the members above
};

}  // namespace stanok::daemon
