#include "polhode/checker/files.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include "claim.hpp"

namespace polhode::checker {
namespace {

namespace fs = std::filesystem;

/// A file to check, or a path that leads to none, and then why.
struct certificate_file {
  std::string path;
  std::string unusable;
};

/// The .json files of a directory, by name; links and what else has such a name too, so that none
/// is passed over in silence.
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

[[noreturn]] void throw_not_read() { throw not_read(std::generic_category().message(errno)); }

class open_file {
 public:
  /// Opening a pipe or a device must not wait for its other side.
  explicit open_file(const std::string& path)
      : descriptor_(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY)) {
    if (descriptor_ < 0) throw_not_read();
  }
  ~open_file() { close(descriptor_); }
  open_file(const open_file&) = delete;
  open_file& operator=(const open_file&) = delete;
  open_file(open_file&&) = delete;
  open_file& operator=(open_file&&) = delete;

  void expect_regular() const {
    struct stat what {};
    if (fstat(descriptor_, &what) != 0) throw_not_read();
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
      if (errno != EINTR) throw_not_read();
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
  for (std::size_t length = 0; length <= most_certificate_bytes;) {
    text.resize(length + block);
    const std::size_t count = file.read_into(text.data() + length, block);
    length += count;
    text.resize(length);
    if (count == 0) break;
  }
  return text;
}

std::string quoted(const std::string& path) {
  constexpr const char* hex = "0123456789abcdef";
  std::string result = "\"";
  for (const char c : path) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      result += std::string("\\") + c;
    } else if (code >= 0x20 && code < 0x7f) {
      result += c;
    } else {
      result += std::string("\\x") + hex[code / 16U] + hex[code % 16U];
    }
  }
  return result + '"';
}

std::string joined(const std::vector<std::string>& words) {
  std::string result;
  for (const std::string& word : words) result += (result.empty() ? "" : ", ") + word;
  return result;
}

std::string problem_of(const report& r) {
  return "at " + (r.place.empty() ? "the top" : r.place) + ": " + r.message;
}

std::string text_of(const report& r, bool verbose) {
  std::string result;
  if (r.is_verified()) {
    result = r.tier == statements::with_words ? "steps verified, joined in words"
             : r.tier == statements::by_kernel
                 ? "verified, for all bodies by Coq's kernel (not run here)"
                 : "verified";
    if (!r.left_out.empty()) result += ", without " + joined(r.left_out);
    result += ": " + r.subject + ", " +
              (r.checks.size() == 1 ? "1 fact or number"
                                    : std::to_string(r.checks.size()) + " facts and numbers") +
              " shown again; it rests on: " + joined(r.grounds) + '\n';
    for (const std::string& sentence : r.statement) result += "  " + sentence + '\n';
  } else {
    result = to_text(r.result) + ": " + problem_of(r) + '\n';
  }
  if (verbose) {
    for (const std::string& check : r.checks) result += "  shown: " + check + '\n';
    result += "  cost: " + std::to_string(1 + r.work / 1'000'000) + " million operations, " +
              std::to_string(1 + r.memory / (1L << 20U)) + " MB of memory\n";
  }
  return result;
}

}  // namespace

std::string printable(const std::string& path) {
  constexpr std::string_view others = "._/+-,=@~%";
  const bool plain = !path.empty() && std::all_of(path.begin(), path.end(), [&](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           others.find(c) != std::string_view::npos;
  });
  return plain ? path : quoted(path);
}

files_report check_files(
    const files_request& request,
    const std::function<void(const std::string&, std::size_t, std::size_t)>& begins) {
  const std::vector<certificate_file> files = files_of(request.paths);
  files_report all;
  std::size_t verified = 0;
  std::size_t in_part = 0;
  // The work that is left is shared equally by the files that are left: a hostile file takes
  // nothing from the others.
  limits share = request.most;
  long left = request.most.work;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string path = printable(files[i].path);
    begins(path, i + 1, files.size());
    file_report file;
    file.path = files[i].path;
    try {
      share.work = left / static_cast<long>(files.size() - i);
      file.result = check(contents_of(files[i]), share);
      file.was_read = true;
      left -= std::min(left, file.result.work);
    } catch (const not_read& problem) {
      file.not_read = problem.what();
    }
    if (!file.was_read) {
      all.unusable.push_back(path + ": not read: " + file.not_read);
    } else if (file.is_unusable()) {
      all.unusable.push_back(path + ": malformed: " + problem_of(file.result));
    } else {
      all.text.append(path).append(": ").append(text_of(file.result, request.verbose));
    }
    if (file.was_read && file.result.result == outcome::verified) ++verified;
    if (file.was_read && file.result.result == outcome::verified_in_part) ++in_part;
    all.files.push_back(std::move(file));
  }
  all.text += std::to_string(files.size()) +
              (files.size() == 1 ? " certificate: " : " certificates: ") +
              std::to_string(verified) + " verified" +
              (in_part > 0 ? ", " + std::to_string(in_part) + " without a part" : "") + '\n';
  all.whole = verified == files.size();
  return all;
}

}  // namespace polhode::checker
