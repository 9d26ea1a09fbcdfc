// JSON-RPC 2.0: requests, answers, and a corpus of lines that are no requests.
#include "protocol/contract/json_rpc.h"

#include <gtest/gtest.h>

#include <random>

#include "base/catalogue.h"

namespace stanok::protocol {
namespace {

using nlohmann::json;

TEST(ParseRequest, ReadsARequestWithNamedParameters) {
  const auto request =
      parse_request(R"({"jsonrpc":"2.0","id":7,"method":"override.feed","params":{"percent":80}})");
  ASSERT_TRUE(request);
  EXPECT_EQ(request->id, 7);
  EXPECT_TRUE(request->wants_answer);
  EXPECT_EQ(request->method, "override.feed");
  EXPECT_EQ(request->parameters["percent"], 80);
}

TEST(ParseRequest, KnowsANotificationByItsMissingId) {
  const auto request = parse_request(R"({"jsonrpc":"2.0","method":"machine.status"})");
  ASSERT_TRUE(request);
  EXPECT_FALSE(request->wants_answer);
  EXPECT_TRUE(request->parameters.is_object());
}

struct Malformed {
  const char* name;
  std::string line;
  int code;
};

class MalformedLine : public ::testing::TestWithParam<Malformed> {};

TEST_P(MalformedLine, GetsAnAnswerWithTheCodeOfTheSpecification) {
  const auto request = parse_request(GetParam().line);
  ASSERT_FALSE(request);
  EXPECT_EQ(rpc_code(request.error().failure.kind), GetParam().code);
  const json answer = json::parse(failure_line(request.error().id, request.error().failure));
  EXPECT_EQ(answer["jsonrpc"], "2.0");
  EXPECT_EQ(answer["error"]["code"], GetParam().code);
  for (const char* member : {"code", "channel", "file", "line", "column", "reaction", "remedy"}) {
    EXPECT_TRUE(answer["error"]["data"].contains(member)) << member;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Corpus, MalformedLine,
    ::testing::Values(
        Malformed{"word", "hello", -32700}, Malformed{"open_object", "{", -32700},
        Malformed{"open_string", R"({"jsonrpc":"2.0)", -32700},
        Malformed{"trailing", R"({"jsonrpc":"2.0","id":1,"method":"x"} y)", -32700},
        Malformed{"comma", R"({"jsonrpc":"2.0","id":1,})", -32700},
        Malformed{"not_utf8", "{\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\"\xff\xfe\"}", -32700},
        Malformed{"nul", std::string("{\"id\"\0:1}", 10), -32700},
        Malformed{"huge_number", R"({"jsonrpc":"2.0","id":1e999,"method":"x"})", -32700},
        Malformed{"deep_array", std::string(100000, '['), -32700},
        Malformed{"deep_object",
                  [] {
                    std::string text;
                    for (int i = 0; i < 50000; ++i) text += "{\"a\":";
                    return text;
                  }(),
                  -32700},
        Malformed{"http", "GET / HTTP/1.1", -32700},
        Malformed{"http_post", "POST /rpc HTTP/1.1\r", -32700}, Malformed{"number", "42", -32600},
        Malformed{"null", "null", -32600},
        Malformed{"batch", R"([{"jsonrpc":"2.0","id":1,"method":"machine.off"}])", -32600},
        Malformed{"empty_batch", "[]", -32600}, Malformed{"empty_object", "{}", -32600},
        Malformed{"version_1", R"({"jsonrpc":"1.0","id":1,"method":"x"})", -32600},
        Malformed{"version_number", R"({"jsonrpc":2.0,"id":1,"method":"x"})", -32600},
        Malformed{"no_method", R"({"jsonrpc":"2.0","id":1})", -32600},
        Malformed{"method_number", R"({"jsonrpc":"2.0","id":1,"method":1})", -32600},
        Malformed{"parameters_text", R"({"jsonrpc":"2.0","id":1,"method":"x","params":"y"})",
                  -32600},
        Malformed{"id_object", R"({"jsonrpc":"2.0","id":{},"method":"x"})", -32600}),
    [](const auto& malformed) { return std::string(malformed.param.name); });

// Property: bytes changed at random never throw, crash or hang, and every refusal can be sent.
TEST(ParseRequest, SurvivesRandomDamage) {
  const std::string sound =
      R"({"jsonrpc":"2.0","id":"a\u00e9","method":"program.load","params":{"program":"a.nc","channel":1}})";
  for (unsigned seed = 1; seed <= 3000; ++seed) {
    std::mt19937 random(seed);
    std::string line = sound;
    for (auto changes = 1 + random() % 6; changes > 0; --changes) {
      line[random() % line.size()] = static_cast<char>(random() & 0xff);
    }
    const auto request = parse_request(line);
    if (request) {
      const auto answer = answer_line(request->id, request->method);
      EXPECT_TRUE(json::accept(answer)) << "seed " << seed;
    } else {
      const auto answer = failure_line(request.error().id, request.error().failure);
      EXPECT_TRUE(json::accept(answer)) << "seed " << seed;
    }
  }
}

TEST(Lines, EndWithOneLineEndAndContainNone) {
  for (const std::string& line :
       {answer_line(1, {{"text", "two\nlines"}}), notification_line("event", {{"text", "\n\n"}}),
        request_line(1, "x", json::object())}) {
    EXPECT_EQ(line.find('\n'), line.size() - 1);
  }
}

TEST(Lines, RepairTextThatIsNotUtf8) {
  EXPECT_TRUE(json::accept(answer_line(1, "bad \xff text")));
}

TEST(Failures, CarryReactionAndRemedyOfTheCatalogue) {
  const Failure failure{
      FailureKind::program_error, "E7001", "no such file", 2, {"part.nc", 3, 7, 3, 9}};
  const json error = to_json(failure);
  EXPECT_EQ(error["code"], -32004);
  EXPECT_EQ(error["data"]["code"], "E7001");
  EXPECT_EQ(error["data"]["channel"], 2);
  EXPECT_EQ(error["data"]["file"], "part.nc");
  EXPECT_EQ(error["data"]["line"], 3);
  EXPECT_EQ(error["data"]["column"], 7);
  EXPECT_EQ(error["data"]["reaction"], static_cast<int>(find_in_catalogue("E7001")->reaction));
  EXPECT_EQ(error["data"]["remedy"], find_in_catalogue("E7001")->remedy);
  const Failure back = failure_from_json(error);
  EXPECT_EQ(back.kind, failure.kind);
  EXPECT_EQ(back.code, failure.code);
  EXPECT_EQ(back.place.column, 7);
}

TEST(Failures, OfStrangersAreReadWithoutTrust) {
  for (const char* text : {"null", "[]", "1", R"({"code":"x"})", R"({"code":1,"data":[]})",
                           R"({"message":5,"data":{"line":"x"}})"}) {
    EXPECT_EQ(failure_from_json(json::parse(text)).kind, FailureKind::internal) << text;
  }
}

// The exit codes of docs/reference/command-line.md, in words there.
TEST(Failures, HaveTheExitCodesOfTheManual) {
  EXPECT_EQ(exit_code(FailureKind::refused), 1);
  EXPECT_EQ(exit_code(FailureKind::invalid_parameters), 2);
  EXPECT_EQ(exit_code(FailureKind::timed_out), 4);
  EXPECT_EQ(exit_code(FailureKind::not_permitted), 5);
  EXPECT_EQ(exit_code(kind_of_alarm("E5101")), 6);
  EXPECT_EQ(exit_code(kind_of_alarm("U1006")), 6);
  EXPECT_EQ(exit_code(kind_of_alarm("A3001")), 7);
}

}  // namespace
}  // namespace stanok::protocol
