// The commands one block makes, between its execution and their delivery.
//
// Storage is reused: after the first blocks no more memory is taken.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "lang/contract/command.h"

namespace stanok::lang {

class CommandQueue {
 public:
  // Where the commands from here on come from.
  void set_origin(const Origin& origin, std::uint64_t block) {
    origin_ = origin;
    block_ = block;
  }

  void emit(Payload payload) {
    terms_changed_ = terms_changed_ || changes_terms(payload);
    if (const auto* const move = std::get_if<Move>(&payload))
      ends_in_machine_ = move->machine_coordinates;
    if (last_ == commands_.size()) commands_.emplace_back();
    Command& command = commands_[last_++];
    command.origin = origin_;
    command.block = block_;
    command.payload = std::move(payload);
  }

  [[nodiscard]] bool empty() const { return first_ == last_; }

  // A command since the last call changes the frame, the tool or its length.
  [[nodiscard]] bool takes_changed_terms() { return std::exchange(terms_changed_, false); }

  // The newest move went to machine coordinates (G53, G28).
  [[nodiscard]] bool ends_in_machine() const { return ends_in_machine_; }

  // The oldest command; the queue must not be empty.
  void take(Command& command) {
    std::swap(command, commands_[first_++]);
    if (first_ == last_) clear();
  }

  void clear() {
    first_ = 0;
    last_ = 0;
  }

 private:
  [[nodiscard]] static bool changes_terms(const Payload& payload) {
    return std::holds_alternative<FrameChange>(payload) ||
           std::holds_alternative<ToolLength>(payload) ||
           std::holds_alternative<TransformationChange>(payload) ||
           std::holds_alternative<ToolChange>(payload);
  }

  std::vector<Command> commands_;
  std::size_t first_ = 0;
  std::size_t last_ = 0;
  Origin origin_;
  std::uint64_t block_ = 0;
  bool terms_changed_ = false;
  bool ends_in_machine_ = false;
};

}  // namespace stanok::lang
