#include <utility>

#include "document.hpp"
#include "polhode/checker/files.hpp"

namespace polhode::checker {
namespace {

/// The name of a file, which may be of any bytes, in the UTF-8 that JSON needs: with escapes where
/// it is not.
std::string as_unicode(const std::string& path) {
  try {
    (void)json(path).dump();
    return path;
  } catch (const json::type_error&) {
    return printable(path);
  }
}

}  // namespace

std::string json_text(const files_report& all, bool verbose) {
  json files = json::array();
  for (const file_report& file : all.files) {
    json entry{{"file", as_unicode(file.path)}};
    const report& r = file.result;
    if (!file.was_read) {
      entry["verdict"] = "not read";
      entry["reason"] = file.not_read;
    } else {
      entry["verdict"] = to_text(r.result);
      if (!r.claim.empty()) entry["claim"] = r.claim;
      if (r.is_verified()) {
        entry["subject"] = r.subject;
        if (!r.tier.empty()) entry["tier"] = r.tier;
        entry["statement"] = r.statement;
        entry["left_out"] = r.left_out;
        entry["rests_on"] = r.grounds;
        entry["facts"] = r.checks;
      } else {
        entry["place"] = r.place;
        entry["reason"] = r.message;
      }
      if (verbose) entry["cost"] = {{"operations", r.work}, {"bytes", r.memory}};
    }
    files.push_back(std::move(entry));
  }
  const json result{{"format", "polhode check"},
                    {"version", json_version},
                    {"files", std::move(files)},
                    {"verified", all.whole}};
  return result.dump(2) + '\n';
}

}  // namespace polhode::checker
