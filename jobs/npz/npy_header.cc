#include "jobs/npz/npy_header.h"

#include <fmt/format.h>

#include <cstddef>

#include "base/assert.h"

namespace stanok::jobs {
namespace {

constexpr std::string_view npy_magic("\x93NUMPY\x01\x00", 8);  // with the version
constexpr std::size_t npy_alignment = 64;                      // bytes

}  // namespace

std::string npy_header(std::string_view type, std::span<const std::int64_t> shape) {
  std::string sizes;
  for (const std::int64_t size : shape)
    sizes += fmt::format("{}{}", sizes.empty() ? "" : ", ", size);
  if (shape.size() == 1) sizes += ',';  // a tuple of Python
  std::string text =
      fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}), }}", type, sizes);
  const std::size_t before_text = npy_magic.size() + 2;  // with the length of the text
  const std::size_t end = before_text + text.size() + 1;
  text.append((npy_alignment - end % npy_alignment) % npy_alignment, ' ').append("\n");
  STANOK_ASSERT(text.size() <= 0xFFFF);
  std::string header(npy_magic);
  header += static_cast<char>(text.size() & 0xFFU);
  header += static_cast<char>(text.size() >> 8U);
  return header + text;
}

}  // namespace stanok::jobs
