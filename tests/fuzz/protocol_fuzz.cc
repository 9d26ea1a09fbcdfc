// libFuzzer target: any bytes as what a client sends. Frames are the same however the bytes come
// in, and within their bound; each is a request with checked parameters, or is answered by one line
// of JSON.
#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "protocol/contract/frame_reader.h"
#include "protocol/contract/json_rpc.h"
#include "protocol/contract/machine_request.h"

using namespace stanok::protocol;

namespace {

constexpr std::size_t bytes_max = 512;

std::vector<Frame> frames_of(std::string_view bytes, std::size_t piece) {
  FrameReader reader(bytes_max);
  std::vector<Frame> frames;
  while (!bytes.empty()) {
    const std::string_view now(bytes.data(), std::min(piece, bytes.size()));
    reader.append(now);
    bytes.remove_prefix(now.size());
    while (auto frame = reader.next()) frames.push_back(std::move(*frame));
  }
  return frames;
}

void expect_one_line_of_json(const std::string& line) {
  if (line.empty() || line.find('\n') != line.size() - 1) std::abort();
  if (nlohmann::json::parse(line, nullptr, false).is_discarded()) std::abort();
}

void answer(const std::string& text) {
  const auto request = parse_request(text);
  if (!request)
    return expect_one_line_of_json(failure_line(request.error().id, request.error().failure));
  const Method* method = find_method(request->method);
  if (method == nullptr) return;
  const auto parameters = checked_parameters(*method, request->parameters);
  if (!parameters) return expect_one_line_of_json(failure_line(request->id, parameters.error()));
  expect_one_line_of_json(answer_line(request->id, *parameters));
  if (!method->action.empty()) static_cast<void>(machine_request(*method, *parameters));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  const std::vector<Frame> frames = frames_of(text, bytes_max);
  const std::vector<Frame> same = frames_of(text, 7);
  if (frames.size() != same.size()) std::abort();
  for (std::size_t k = 0; k < frames.size(); ++k) {
    if (frames[k].kind != same[k].kind || frames[k].text != same[k].text) std::abort();
    if (frames[k].text.size() > bytes_max) std::abort();
    answer(frames[k].text);
  }
  return 0;
}
