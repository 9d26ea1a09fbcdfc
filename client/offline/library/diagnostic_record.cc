#include "client/offline/library/diagnostic_record.h"

#include <string>
#include <vector>

namespace stanok::client {
namespace {

using nlohmann::json;

json place_record(const Place& place) {
  return {place.file, place.line, place.column, place.end_line, place.end_column};
}

Place place_of(const json& record) {
  return {.file = record.at(0),
          .line = record.at(1),
          .column = record.at(2),
          .end_line = record.at(3),
          .end_column = record.at(4)};
}

json record_of_diagnostic(const Diagnostic& diagnostic) {
  json notes = json::array();
  for (const Note& note : diagnostic.notes)
    notes.push_back(json::array({note.text, place_record(note.place)}));
  return {{"code", diagnostic.code},
          {"severity", static_cast<int>(diagnostic.severity)},
          {"place", place_record(diagnostic.place)},
          {"message", diagnostic.message},
          {"label", diagnostic.label},
          {"notes", std::move(notes)},
          {"help", diagnostic.help},
          {"stack", diagnostic.stack},
          {"source_line", diagnostic.source_line}};
}

Diagnostic diagnostic_of(const json& record) {
  Diagnostic diagnostic;
  diagnostic.code = record.at("code");
  diagnostic.severity = static_cast<Severity>(record.at("severity").get<int>());
  diagnostic.place = place_of(record.at("place"));
  diagnostic.message = record.at("message");
  diagnostic.label = record.at("label");
  for (const json& note : record.at("notes"))
    diagnostic.notes.push_back({note.at(0), place_of(note.at(1))});
  diagnostic.help = record.at("help").get<std::vector<std::string>>();
  diagnostic.stack = record.at("stack").get<std::vector<std::string>>();
  diagnostic.source_line = record.at("source_line");
  return diagnostic;
}

}  // namespace

json diagnostics_record(const Diagnostics& diagnostics) {
  json records = json::array();
  for (const Diagnostic& diagnostic : diagnostics)
    records.push_back(record_of_diagnostic(diagnostic));
  return records;
}

Diagnostics diagnostics_of(const json& record) {
  Diagnostics diagnostics;
  for (const json& one : record) diagnostics.push_back(diagnostic_of(one));
  return diagnostics;
}

}  // namespace stanok::client
