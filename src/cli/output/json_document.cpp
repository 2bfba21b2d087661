#include "json_document.hpp"

namespace polhode::cli {

json json_document(std::string_view name, const json& content) {
  json result{{"format", "polhode " + std::string(name)}, {"version", json_version}};
  result.update(content);
  return result;
}

std::string json_text(const json& value) {
  return value.dump(2, ' ', false, json::error_handler_t::replace);
}

std::string json_document_text(std::string_view name, const json& content) {
  return json_document(name, content).dump(2) + '\n';
}

}  // namespace polhode::cli
