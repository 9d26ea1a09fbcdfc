// FileDescriptor: an open file of the kernel that closes itself.
#pragma once

#include <unistd.h>

namespace stanok {

class FileDescriptor {
 public:
  // As open(2) gave it; negative: none. What close(2) has to say is forgotten: who must know that a
  // file is written asks fsync(2) before.
  explicit FileDescriptor(int number) : number_(number) {}
  ~FileDescriptor() {
    if (number_ >= 0) ::close(number_);
  }
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;

  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] bool is_open() const { return number_ >= 0; }

 private:
  int number_;
};

}  // namespace stanok
