// PageFiles: the files of the page or of its manual, read into memory, so that a request can name
// nothing else.
//
// Texts are compressed when they are read, once for all requests; where a file NAME.gz stands
// beside NAME it is taken instead. Read again when the front file is asked for and has changed, so
// that a page that was built anew is there on reload. One thread.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace stanok::web {

struct PageFile {
  std::string media_type;
  bool is_hashed = false;  // its name changes with its content: may be kept for ever
  std::shared_ptr<const std::string> content;
  std::shared_ptr<const std::string> compressed;  // gzip; none where that saves nothing
  std::string tag;                                // of the content, for If-None-Match
};

class PageFiles {
 public:
  static constexpr std::uintmax_t bytes_max = 64U << 20;  // of all files

  // `front`: the file with which everything else begins.
  PageFiles(std::filesystem::path folder, std::string_view front);

  // By the path of a request: "/", "/assets/index-1a2b3c4d.js"; nullptr: there is none.
  [[nodiscard]] const PageFile* find(std::string_view path);
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

 private:
  void read();
  void add(const std::filesystem::path& file);
  void finish(PageFile& file);

  std::filesystem::path folder_;
  std::string front_;                          // "/index.html"
  std::filesystem::file_time_type read_at_{};  // time of the front file then
  std::uintmax_t bytes_ = 0;
  std::map<std::string, PageFile, std::less<>> files_;
};

// Where the page is when nobody says: of the installation, else of the source tree of a build.
[[nodiscard]] std::filesystem::path usual_page_folder();
// The same of the documents.
[[nodiscard]] std::filesystem::path usual_manual_folder();

}  // namespace stanok::web
