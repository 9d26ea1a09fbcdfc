#include "client/terminal/result_files.h"

#include <fstream>
#include <stdexcept>

namespace stanok::client {

void write_text_file(const std::filesystem::path& file, std::string_view text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream)
    throw std::runtime_error("cannot write " + file.string() + "; check folder and permissions");
}

std::string picture_name_fault(const std::string& name) {
  const std::string extension = std::filesystem::path(name).extension().string();
  return extension == ".svg" || extension == ".png"
             ? ""
             : "the name of a picture must end in .svg or .png";
}

}  // namespace stanok::client
