// Raster: the places of rows of cells in an array, row by row; PerAxis: a value for each of X, Y
// and Z, read by the number that vectors and grids count axes with.
#pragma once

#include <array>
#include <cstddef>

namespace stanok::simulation {

struct Raster {
  int columns = 0;
  int rows = 0;

  [[nodiscard]] bool has(int column, int row) const {
    return column >= 0 && row >= 0 && column < columns && row < rows;
  }
  [[nodiscard]] std::size_t cells() const { return place(0, rows); }
  [[nodiscard]] std::size_t place(int column, int row) const {
    const std::ptrdiff_t across = columns;
    return static_cast<std::size_t>(row * across + column);
  }
};

// An aggregate. 3 is X again, as cyclic orders want it.
template <class Value>
struct PerAxis : std::array<Value, 3> {
  [[nodiscard]] constexpr Value& operator[](int axis) {
    return std::array<Value, 3>::operator[](place(axis));
  }
  [[nodiscard]] constexpr const Value& operator[](int axis) const {
    return std::array<Value, 3>::operator[](place(axis));
  }

 private:
  [[nodiscard]] static constexpr std::size_t place(int axis) {
    return static_cast<std::size_t>(axis % 3);
  }
};

}  // namespace stanok::simulation
