// polhode check: repeats the arguments of certificates with the independent checker.

#include "polhode/checker/check.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <stdexcept>
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

/// A file to check, or a path that leads to none, and then why.
struct certificate_file {
  std::string path;
  std::string unusable;
};

/// The .json files of a directory, by name; links and what else has such a name too, so that none is passed over in silence.
std::vector<certificate_file> files_in(const std::string& directory) {
  std::error_code error;
  std::vector<certificate_file> found;
  for (fs::directory_iterator entry(directory, error), end; !error && entry != end;
       entry.increment(error)) {
    if (entry->path().extension() == ".json") found.push_back({entry->path().string(), ""});
  }
  if (error) return {{directory, error.message()}};
  if (found.empty()) {
    return {{directory,
             "a directory with no .json file; it must hold certificates, as `polhode certify --out "
             "DIR` writes them"}};
  }
  std::sort(found.begin(), found.end(),
            [](const certificate_file& x, const certificate_file& y) { return x.path < y.path; });
  return found;
}

/// The files to check: those given, and those of a directory that is given.
std::vector<certificate_file> files_of(const std::vector<std::string>& paths) {
  std::vector<certificate_file> files;
  for (const std::string& path : paths) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) {
      std::vector<certificate_file> found = files_in(path);
      std::move(found.begin(), found.end(), std::back_inserter(files));
    } else {
      files.push_back({path, ""});
    }
  }
  return files;
}

/// Something in place of a file's contents; what() says why.
class not_read : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class open_file {
 public:
  /// Opening a pipe or a device must not wait for its other side.
  explicit open_file(const std::string& path)
      : descriptor_(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY)) {
    if (descriptor_ < 0) throw not_read(system_message(errno));
  }
  ~open_file() { close(descriptor_); }
  open_file(const open_file&) = delete;
  open_file& operator=(const open_file&) = delete;
  open_file(open_file&&) = delete;
  open_file& operator=(open_file&&) = delete;

  void expect_regular() const {
    struct stat what {};
    if (fstat(descriptor_, &what) != 0) throw not_read(system_message(errno));
    if (S_ISDIR(what.st_mode)) throw not_read("a directory; it must be a file");
    if (!S_ISREG(what.st_mode)) {
      throw not_read("a pipe, a socket or a device; it must be a regular file");
    }
  }

  /// The next bytes, none at the end.
  std::size_t read_into(char* bytes, std::size_t most) const {
    for (;;) {
      const ssize_t count = read(descriptor_, bytes, most);
      if (count >= 0) return static_cast<std::size_t>(count);
      if (errno != EINTR) throw not_read(system_message(errno));
    }
  }

 private:
  int descriptor_;
};

/// As much as tells the checker that it is too long, where it is. Throws not_read.
std::string contents_of(const certificate_file& given) {
  constexpr std::size_t block = 1 << 16;
  if (!given.unusable.empty()) throw not_read(given.unusable);
  const open_file file(given.path);
  file.expect_regular();
  std::string text;
  for (std::size_t length = 0; length <= checker::most_certificate_bytes;) {
    text.resize(length + block);
    const std::size_t count = file.read_into(text.data() + length, block);
    length += count;
    text.resize(length);
    if (count == 0) break;
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
  const std::vector<certificate_file> files = files_of(options.paths);
  std::optional<progress> line(std::in_place);
  std::string output;
  std::size_t verified = 0;
  std::string unusable;  // the first that is malformed or was not read
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string& path = files[i].path;
    line->show(fmt::format("checking {} ({}/{})", path, i + 1, files.size()));
    std::string why_unusable;
    try {
      const checker::report r = checker::check(contents_of(files[i]));
      if (r.result == checker::outcome::verified) ++verified;
      if (r.result == checker::outcome::malformed) {
        why_unusable = fmt::format("at {}: {}", r.place.empty() ? "the top" : r.place, r.message);
      }
      output += said_of(path, r, options.verbose);
    } catch (const not_read& problem) {
      why_unusable = problem.what();
      output += fmt::format("{}: not read: {}\n", printable(path), why_unusable);
    }
    if (unusable.empty() && !why_unusable.empty()) {
      unusable = fmt::format("{}: {}", in_quotes(path), why_unusable);
    }
  }
  line.reset();
  output += fmt::format("{} certificate{}: {} verified\n", files.size(),
                        files.size() == 1 ? "" : "s", verified);
  print(output);
  if (!unusable.empty()) throw usage_error(unusable);
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
