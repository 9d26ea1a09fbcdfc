// The values that instructions take and leave.
//
// Owner: Vm. Invariant: the compiler balances the stack, so that taking from an empty one is a
// fault of this program and no fault of the text.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "base/assert.h"
#include "lang/tree/value.h"

namespace stanok::lang {

class ValueStack {
 public:
  void push(const Value& value) { values_.push_back(value); }
  void push(Value&& value) { values_.push_back(std::move(value)); }
  Value pop() {
    STANOK_ASSERT(!values_.empty());
    Value value = std::move(values_.back());
    values_.pop_back();
    return value;
  }
  double pop_number() {
    STANOK_ASSERT(!values_.empty());
    const double number = values_.back().number;
    values_.pop_back();
    return number;
  }
  void drop() { values_.pop_back(); }

  // The top value; the stack must not be empty.
  [[nodiscard]] Value& top() { return values_.back(); }
  // The `count` values on top, in the order in which they were pushed.
  [[nodiscard]] std::span<const Value> top(std::size_t count) const {
    return {values_.data() + values_.size() - count, count};
  }
  [[nodiscard]] std::span<Value> top(std::size_t count) {
    return {values_.data() + values_.size() - count, count};
  }
  [[nodiscard]] std::size_t height() const { return values_.size(); }
  void cut_to(std::size_t height) { values_.resize(height); }
  void clear() { values_.clear(); }

 private:
  std::vector<Value> values_;
};

}  // namespace stanok::lang
