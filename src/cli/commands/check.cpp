// polhode check: repeats the arguments of certificates with the independent checker.

#include <charconv>
#include <memory>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/options/options.hpp"
#include "cli/output/errors.hpp"
#include "cli/output/json_document.hpp"
#include "cli/output/progress.hpp"
#include "cli/output/streams.hpp"
#include "polhode/checker/files.hpp"

namespace polhode::cli {
namespace check_impl {
namespace {

constexpr long million = 1'000'000;
constexpr long megabyte = 1L << 20U;

struct check_options {
  checker::files_request request;
  std::string budget = std::to_string(checker::limits().work / million);
  format_option format{{"text", "json"}};
  std::string memory = std::to_string(checker::limits().memory / megabyte);
};

long whole(const char* option, const std::string& text) {
  constexpr long greatest = 999'999'999;
  long result = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, result);
  if (error != std::errc() || rest != end || result < 1 || result > greatest) {
    throw usage_error(fmt::format("{} {}: it must be a whole number from 1 to {}", option,
                                  in_quotes(text), greatest));
  }
  return result;
}

static_assert(checker::json_version == json_version);

exit_status run(const check_options& options) {
  checker::files_request request = options.request;
  (void)options.format.value();
  request.most = {whole("--budget", options.budget) * million,
                  whole("--memory", options.memory) * megabyte};
  std::optional<progress> line(std::in_place);
  const checker::files_report result = checker::check_files(
      request, [&](const std::string& path, std::size_t number, std::size_t of) {
        line->show(fmt::format("checking {} ({}/{})", path, number, of));
      });
  line.reset();
  print(options.format.value() == "json" ? checker::json_text(result, request.verbose)
                                         : result.text);
  if (!result.unusable.empty()) {
    for (auto fault = result.unusable.begin(); fault + 1 != result.unusable.end(); ++fault) {
      print_error("polhode: " + *fault + '\n');
    }
    throw usage_error(result.unusable.back());
  }
  return result.whole ? exit_status::all_certified : exit_status::not_certified;
}

std::function<exit_status()> declare(CLI::App& app) {
  const auto options = std::make_shared<check_options>();
  add_option(app, "PATH", options->request.paths,
             "Certificates, or directories of which every .json file is one")
      .type_name("")
      .required();
  add_flag(app, "--verbose", options->request.verbose,
           "Print every fact and number that was shown again,\nand what it cost");
  add_option(app, "--budget", options->budget,
             fmt::format("What all of them may cost together, in millions of operations;\nthe "
                         "rest is shared by the files that are left [{}]",
                         options->budget))
      .type_name("N");
  add_option(app, "--memory", options->memory,
             fmt::format("What it may hold in memory, in MB [{}]", options->memory))
      .type_name("N");
  options->format.declare(app);
  return [options] { return run(*options); };
}

}  // namespace
}  // namespace check_impl

command check_command() {
  return {"check", "Check certificates with an independent checker",
          "  polhode certify --out certificates && polhode check certificates\n"
          "  polhode check certificates/beta.json --verbose\n",
          check_impl::declare};
}

}  // namespace polhode::cli
