// StateBoard: the newest state of every topic, between the threads that read machines and the one
// that publishes. Nobody waits for anybody: what was not sent in time is replaced.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stanok::gateway {

class StateBoard {
 public:
  // `source` names this outbox in every payload.
  explicit StateBoard(std::string source) : source_(std::move(source)) {}

  // Does nothing when the topic says this already.
  void set(const std::string& topic, nlohmann::json content);

  using Payloads = std::vector<std::pair<std::string, std::string>>;
  // Topics and payloads that nobody has taken yet.
  [[nodiscard]] Payloads take_new();
  // The newest of all topics, unless `number` says that there is nothing new since the last call
  // with it; -1 at first.
  using Contents = std::map<std::string, nlohmann::json>;
  [[nodiscard]] std::optional<Contents> contents_since(std::int64_t& number);
  [[nodiscard]] const std::string& source() const { return source_; }
  // A broker that was away gets all of them.
  void renew_all();

  // The payload: source, seq and time, and the content.
  [[nodiscard]] std::string payload(std::int64_t number, double time_s,
                                    nlohmann::json content) const;

 private:
  struct State {
    nlohmann::json content;
    std::string payload;
    bool is_new = true;
  };

  std::mutex mutex_;
  std::string source_;
  std::int64_t number_ = 0;
  std::map<std::string, State> states_;
};

}  // namespace stanok::gateway
