// Publishes the message stream on the LCM bus, for viewers.
//
// Nothing is ever accepted from the bus. Without a multicast route the bus cannot be opened, and a
// route may be lost later: both are a status, not a failure; the machine runs on. A bus that is not
// open is opened again now and then. Publishing allocates and calls the kernel: for the publisher
// thread only.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "recording/stream/message_sink.h"

namespace lcm {
class LCM;
}

namespace stanok::recording {

inline constexpr const char* default_lcm_url = "udpm://239.255.76.67:7667?ttl=0";

struct PublisherStatus {
  std::string url;
  bool open = false;
  std::int64_t sent = 0;
  std::int64_t lost = 0;  // messages the bus did not take
};

class LcmPublisher : public MessageSink {
 public:
  // `url` as of LCM; empty: LCM_DEFAULT_URL, else default_lcm_url. "tcpq" is refused: LCM aborts
  // the process when its server is absent.
  explicit LcmPublisher(std::string url);
  ~LcmPublisher() override;
  LcmPublisher(const LcmPublisher&) = delete;
  LcmPublisher& operator=(const LcmPublisher&) = delete;

  void send(const std::string& channel, std::int64_t utime,
            std::span<const std::uint8_t> bytes) override;

  [[nodiscard]] bool good() const { return status_.open; }
  [[nodiscard]] const PublisherStatus& status() const { return status_; }
  // For subscribers in the same process (memq in tests); nullptr when not open.
  [[nodiscard]] lcm::LCM* bus() { return bus_.get(); }

  // Tries to open the bus; nothing when it is open, or is of a kind that is refused.
  void reopen();

 private:
  std::unique_ptr<lcm::LCM> bus_;
  PublisherStatus status_;
};

}  // namespace stanok::recording
