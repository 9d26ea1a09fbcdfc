// RangeMinimum: where the smallest of a run of values stands, in constant time.
//
// Sparse table: row k holds the place of the minimum of every window of 2^k values; a range is the
// union of two windows. Building takes n log n steps.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/numbered.h"
#include "base/place.h"

namespace stanok::motion {

class RangeMinimum {
 public:
  void build(const std::vector<double>& values) {
    values_ = &values;
    const std::size_t n = values.size();
    const std::size_t height = place_of(std::bit_width(n));
    rows_.resize(height);
    for (std::size_t k = 0; k < height; ++k) fill_row(k, n);
  }

  // The first place of the minimum of values[first..last], both included.
  [[nodiscard]] std::size_t place(std::size_t first, std::size_t last) const {
    const std::size_t span = std::bit_floor(last - first + 1);
    const auto& row = rows_[std::countr_zero(span)];
    return lower(row[first], row[last + 1 - span]);
  }
  [[nodiscard]] double value(std::size_t first, std::size_t last) const {
    return (*values_)[place(first, last)];
  }

 private:
  [[nodiscard]] std::uint32_t lower(std::uint32_t left, std::uint32_t right) const {
    return (*values_)[right] < (*values_)[left] ? right : left;
  }
  void fill_row(std::size_t k, std::size_t n) {
    constexpr std::size_t value = 1;
    const std::size_t width = value << k;
    rows_[k].resize(n + 1 - width);
    for (std::size_t i = 0; i + width <= n; ++i) {
      rows_[k][i] = k == 0 ? static_cast<std::uint32_t>(i)
                           : lower(rows_[k - 1][i], rows_[k - 1][i + width / 2]);
    }
  }

  const std::vector<double>* values_ = nullptr;
  NumberedList<std::vector<std::uint32_t>> rows_;
};

}  // namespace stanok::motion
