// polhode check: repeats the arguments of certificates with the independent checker.

#include "polhode/checker/check.hpp"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "commands.hpp"
#include "progress.hpp"
#include "streams.hpp"

namespace polhode::cli {
namespace {

namespace fs = std::filesystem;

struct check_options {
  std::vector<std::string> paths;
  bool verbose = false;
};

/// The files to check: those given, and the .json files of a directory that is given, by name.
std::vector<std::string> files_of(const std::vector<std::string>& paths) {
  std::vector<std::string> files;
  for (const std::string& path : paths) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) {
      throw usage_error(
          fmt::format("{}: {}", in_quotes(path), system_message(error ? error.value() : ENOENT)));
    }
    if (!fs::is_directory(status)) {
      files.push_back(path);
      continue;
    }
    std::vector<std::string> found;
    for (fs::directory_iterator entry(path, error), end; !error && entry != end;
         entry.increment(error)) {
      std::error_code ignored;
      const bool is_file = entry->is_regular_file(ignored);
      if (is_file && entry->path().extension() == ".json") found.push_back(entry->path().string());
    }
    if (error) throw usage_error(fmt::format("{}: {}", in_quotes(path), error.message()));
    if (found.empty()) {
      throw usage_error(
          fmt::format("{}: a directory with no .json file; it must hold certificates, as `polhode "
                      "certify --out DIR` writes them",
                      in_quotes(path)));
    }
    std::sort(found.begin(), found.end());
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

std::string contents_of(const std::string& path) {
  constexpr std::size_t block = 1 << 16;
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) {
    throw usage_error(fmt::format("{}: a directory; it must be a file", in_quotes(path)));
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::string text;
  while (file && text.size() <= checker::most_certificate_bytes) {
    const std::size_t read = text.size();
    text.resize(read + block);
    file.read(text.data() + read, block);
    text.resize(read + static_cast<std::size_t>(file.gcount()));
  }
  if (file.bad() || (!file && !file.eof())) {
    throw usage_error(fmt::format("{}: {}", in_quotes(path),
                                  errno == 0 ? "it cannot be read" : system_message(errno)));
  }
  return text;
}

/// A path as it may stand on a terminal: as it is, or, with control characters, in quotes.
std::string printable(const std::string& path) {
  const bool plain = std::none_of(path.begin(), path.end(), [](char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
  });
  return plain ? path : in_quotes(path);
}

std::string said_of(const std::string& path, const checker::report& r, bool verbose) {
  std::string result = printable(path) + ": " + to_text(r.result);
  if (r.result == checker::outcome::verified) {
    result += fmt::format(": {}, {} facts and numbers shown again", r.claim, r.checks.size());
    for (std::size_t i = 0; i < r.left_out.size(); ++i) {
      result += (i == 0 ? ", without " : ", ") + r.left_out[i];
    }
  } else {
    result += fmt::format(": at {}: {}", r.place.empty() ? "the top" : r.place, r.message);
  }
  result += '\n';
  if (verbose) {
    for (const std::string& check : r.checks) result += "  " + check + '\n';
  }
  return result;
}

exit_status run(const check_options& options) {
  const std::vector<std::string> files = files_of(options.paths);
  const progress line;
  std::string output;
  std::size_t verified = 0;
  std::string malformed;
  for (std::size_t i = 0; i < files.size(); ++i) {
    line.show(fmt::format("checking {} ({}/{})", files[i], i + 1, files.size()));
    const checker::report r = checker::check(contents_of(files[i]));
    if (r.result == checker::outcome::verified) ++verified;
    if (r.result == checker::outcome::malformed && malformed.empty()) {
      malformed = fmt::format("{}: at {}: {}", in_quotes(files[i]),
                              r.place.empty() ? "the top" : r.place, r.message);
    }
    output += said_of(files[i], r, options.verbose);
  }
  output += fmt::format("{} certificate{}: {} verified\n", files.size(),
                        files.size() == 1 ? "" : "s", verified);
  print(output);
  if (!malformed.empty()) throw usage_error(malformed);
  return verified == files.size() ? exit_status::all_certified : exit_status::not_certified;
}

std::function<exit_status()> declare(CLI::App& app) {
  const auto options = std::make_shared<check_options>();
  app.add_option("PATH", options->paths,
                 "Certificates, or directories of which every .json file is one")
      ->type_name("")
      ->required();
  app.add_flag("--verbose", options->verbose, "Print every fact and number that was shown again");
  return [options] { return run(*options); };
}

}  // namespace

command check_command() {
  return {"check", "Check certificates with an independent checker",
          "  polhode certify --out certificates && polhode check certificates\n"
          "  polhode check certificates/beta.json --verbose\n",
          declare};
}

}  // namespace polhode::cli
