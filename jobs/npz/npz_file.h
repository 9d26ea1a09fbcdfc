// NpzFile: arrays of numbers in a file that numpy.load reads, a ZIP of .npy files without
// compression.
//
// Shapes are known before the first number, and with them the place of each array. What comes row
// by row can therefore be written while it comes: a piece of each array is held, 128 KiB, and each
// goes to its place when it is full. The file must be one that can be written at any place. One
// thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/expected.h"
#include "base/file_descriptor.h"
#include "jobs/npz/npy_header.h"
#include "jobs/npz/zip_records.h"

namespace stanok::jobs {

struct NpyArray {
  std::string name;
  std::string type;             // as npy_type
  std::int64_t item_bytes = 0;  // of one number
  std::vector<std::int64_t> shape;
};

template <class Number>
[[nodiscard]] NpyArray npy_array(std::string name, std::vector<std::int64_t> shape) {
  return {std::move(name), npy_type<Number>(), static_cast<std::int64_t>(sizeof(Number)),
          std::move(shape)};
}

// "cannot write run.npz: No space left on device"
struct NpzError {
  int system_error = 0;  // errno
  std::string text;
};

class NpzFile {
 public:
  // An existing file is replaced. Sizes above `plain_max` stand in fields of ZIP64.
  [[nodiscard]] static Expected<std::unique_ptr<NpzFile>, NpzError> create(
      const std::filesystem::path& file, const std::vector<NpyArray>& arrays,
      std::int64_t plain_max = zip_plain_max);
  // A regular file that was not finished is removed.
  ~NpzFile();
  NpzFile(const NpzFile&) = delete;
  NpzFile& operator=(const NpzFile&) = delete;

  // The next numbers of an array, of its type, in C order.
  template <class Number>
  void add(std::size_t array, const Number& number) {
    add_bytes(array, {reinterpret_cast<const char*>(&number), sizeof number});
  }
  void add_bytes(std::size_t array, std::span<const char> bytes);

  // When every array has all of its numbers. Why something could not be written; nothing: it was.
  [[nodiscard]] std::optional<NpzError> finish();

 private:
  struct Member {
    ZipMember zip;
    std::int64_t content = 0;  // where it begins in the file
    std::int64_t written = 0;  // of its bytes
    std::string held;
  };

  NpzFile(std::filesystem::path file, int descriptor, std::int64_t plain_max)
      : file_(std::move(file)), descriptor_(descriptor), plain_max_(plain_max) {}
  void place(const std::vector<NpyArray>& arrays);
  void write_held(Member& member);
  void write(std::string_view bytes, std::int64_t offset);

  std::filesystem::path file_;
  FileDescriptor descriptor_;
  std::int64_t plain_max_;
  std::vector<Member> members_;
  std::int64_t end_ = 0;  // of the last member
  std::optional<NpzError> error_;
  bool is_finished_ = false;
};

}  // namespace stanok::jobs
