// libFuzzer target: any bytes as a text to scan. Tokens lie inside the text and the scanner always
// goes on.
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>

#include "lang/tree/scanner.h"

using namespace stanok::lang;

namespace {

void scan(const Source& source, LineEnds line_ends) {
  Reporter reporter(source);
  Scanner scanner(source, reporter);
  std::size_t last = scanner.offset();
  while (true) {
    scanner.skip_blanks(line_ends);
    const Token token = scanner.take(line_ends);
    if (token.span.offset + token.span.length > source.text().size()) std::abort();
    if (token.kind == TokenKind::end) {
      if (scanner.at_end()) break;
      scanner.skip_line_end();
    }
    if (scanner.offset() <= last && token.kind != TokenKind::end) std::abort();
    if (scanner.offset() == last) break;
    last = scanner.offset();
  }
  static_cast<void>(reporter.take());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(bytes), size);
  for (const Dialect dialect : {Dialect::stanok, Dialect::fanuc}) {
    const Source source(std::make_shared<const SourceText>(SourceText{"fuzz.nc", "fuzz.nc", text}),
                        {dialect, CodeSystem::b});
    scan(source, LineEnds::blank);
    scan(source, LineEnds::significant);
  }
  return 0;
}
