// polhode-check: the checker of certificates as a program of its own.

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <string_view>

#include "polhode/checker/files.hpp"

namespace {

constexpr int bad_input = 2;
constexpr long million = 1'000'000;
constexpr long megabyte = 1L << 20U;

std::string usage() {
  const polhode::checker::limits most;
  return R"(Usage: polhode-check [--verbose] [--format F] [--budget N] [--memory N] PATH...

Checks certificates that Polhode wrote, with nothing of the programs that wrote them.

  PATH         A certificate, or a directory of which every .json file is one
  --verbose    Print every fact and number that was shown again, and what it cost
  --format F   text or json: the document of `polhode check --format json` [text]
  --budget N   What all of them may cost together, in millions of operations;
               the rest is shared by the files that are left [)" +
         std::to_string(most.work / million) + R"(]
  --memory N   What it may hold in memory, in MB [)" +
         std::to_string(most.memory / megabyte) + R"(]
  --help       Print this
  --version    Print the version

Exit status: 0 all are verified and leave nothing out; 1 one is verified without a part,
not checkable, or refuted; 2 one is malformed or was not read, or the command line is wrong.
)";
}

int refuse(const std::string& what) {
  std::cerr << "polhode-check: " << what << '\n';
  return bad_input;
}

/// A whole number from 1 to 10^9, or 0 for anything else.
long whole(std::string_view text) {
  constexpr std::size_t most_digits = 9;
  if (text.empty() || text.size() > most_digits ||
      text.find_first_not_of("0123456789") != std::string_view::npos) {
    return 0;
  }
  return std::strtol(std::string(text).c_str(), nullptr, 10);
}

int run(int argc, char** argv) {
  polhode::checker::files_request request;
  bool only_paths = false;
  bool as_json = false;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (only_paths || !word.starts_with('-')) {
      request.paths.emplace_back(word);
    } else if (word == "--") {
      only_paths = true;
    } else if (word == "--verbose") {
      request.verbose = true;
    } else if (word == "--format") {
      const std::string_view format = i + 1 < argc ? argv[++i] : "";
      if (format != "text" && format != "json") return refuse("--format must have text or json");
      as_json = format == "json";
    } else if (word == "--help") {
      std::cout << usage();
      return std::cout.flush() ? 0 : bad_input;
    } else if (word == "--version") {
      std::cout << POLHODE_VERSION << '\n';
      return std::cout.flush() ? 0 : bad_input;
    } else if (word == "--budget" || word == "--memory") {
      const long n = i + 1 < argc ? whole(argv[++i]) : 0;
      if (n == 0)
        return refuse(std::string(word) + " must have a whole number from 1 to 999999999");
      if (word == "--budget") request.most.work = n * million;
      if (word == "--memory") request.most.memory = n * megabyte;
    } else {
      return refuse(polhode::checker::printable(std::string(word)) +
                    " is no option; see polhode-check --help");
    }
  }
  if (request.paths.empty()) return refuse("PATH is missing; see polhode-check --help");
  const polhode::checker::files_report result =
      check_files(request, [](const std::string&, std::size_t, std::size_t) {});
  std::cout << (as_json ? json_text(result, request.verbose) : result.text);
  if (!std::cout.flush()) return refuse("standard output cannot be written");
  for (const std::string& fault : result.unusable) (void)refuse(fault);
  if (!result.unusable.empty()) return bad_input;
  return result.whole ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& problem) {  // of memory, beyond its budget
    std::fputs("polhode-check: ", stderr);
    std::fputs(problem.what(), stderr);
    std::fputs("\n", stderr);
    return bad_input;
  }
}
