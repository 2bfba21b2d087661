// The cache of Gauss and Legendre rules: its memory, its files, and why a file is believed.

#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <span>
#include <string_view>
#include <system_error>

#include <gmp.h>

#include "base/sha256.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/quadrature/gauss_legendre.hpp"
#include "polhode/version.hpp"

namespace polhode {
namespace {

namespace fs = std::filesystem;
using bytes = std::vector<std::byte>;
using word = std::uint64_t;

constexpr std::string_view name_start = "gauss-legendre-";
constexpr std::string_view name_end = ".rule";
constexpr std::string_view name_of_unfinished = ".unfinished-";

std::string file_name(long n, precision bits) {
  return std::string(name_start) + std::to_string(n) + '-' + std::to_string(bits) +
         std::string(name_end);
}

// ---------------------------------------------------------------------------------------------
// The format: words of 64 bits in the machine's order; a file of another order is not believed.
//   header     8 words
//   payload    for each node > 0, then for each weight: exponent e, significand s of `bits` bits,
//              the lowest limb first; the value is s 2^(e - bits), and s has its highest bit set
//   digest     SHA-256 of all before
// The radii are not in the file: they follow from bits and e (see gauss_legendre_rule).

// To be raised when the format changes, or a change of make_gauss_legendre changes the bits of a
// rule.
constexpr word format_version = 1;
constexpr std::size_t digest_size = std::tuple_size_v<sha256_digest>;

using header = std::array<word, 8>;
header header_of(long n, precision bits) {
  constexpr word byte_order = 0x0102030405060708;
  header h{};
  std::memcpy(&h[0], "POLHODE", 8);
  h[1] = format_version;
  h[2] = byte_order;
  h[3] = GMP_NUMB_BITS;
  h[4] = static_cast<word>(n);
  h[5] = static_cast<word>(bits);
  constexpr std::string_view version = POLHODE_VERSION;
  std::memcpy(&h[6], version.data(), std::min(version.size(), 2 * sizeof(word)));
  return h;
}

std::size_t limbs_of(precision bits) { return static_cast<std::size_t>(bits / GMP_NUMB_BITS); }

std::size_t size_of_file(long n, precision bits) {
  const auto numbers = static_cast<std::size_t>(n / 2 + (n + 1) / 2);
  return sizeof(header) + numbers * (1 + limbs_of(bits)) * sizeof(word) + digest_size;
}

void append_words(bytes& out, std::span<const word> words) {
  const auto raw = std::as_bytes(words);
  out.insert(out.end(), raw.begin(), raw.end());
}

bytes encoded(const gauss_legendre_rule& rule) {
  bytes out;
  out.reserve(size_of_file(rule.n, rule.bits));
  append_words(out, header_of(rule.n, rule.bits));
  detail::mpfr_cell cell(rule.bits);
  integer significand;
  std::vector<word> words(1 + limbs_of(rule.bits));
  const auto append = [&](const ball& x) {
    x.midpoint(cell.get());
    words[0] = static_cast<word>(mpfr_get_exp(cell.get()));
    const mpz_ptr z = significand.backend().data();
    mpfr_get_z_2exp(z, cell.get());
    std::copy_n(mpz_limbs_read(z), words.size() - 1, words.begin() + 1);
    append_words(out, words);
  };
  for (std::size_t i = rule.n % 2 != 0 ? 1 : 0; i < rule.nodes.size(); ++i) append(rule.nodes[i]);
  for (const ball& w : rule.weights) append(w);
  const sha256_digest digest = sha256(out);
  const auto raw = std::as_bytes(std::span(digest));
  out.insert(out.end(), raw.begin(), raw.end());
  return out;
}

/// The number at `from`, or nothing where it is none of this format, or not in (0, 4).
std::optional<ball> decoded(const std::byte* from, precision bits, bool is_node) {
  std::vector<word> words(1 + limbs_of(bits));
  std::memcpy(words.data(), from, words.size() * sizeof(word));
  const auto exponent = static_cast<std::int64_t>(words[0]);
  constexpr std::int64_t least_exponent = -100;  // far below 1/n^2
  if (exponent < least_exponent || exponent > (is_node ? 0 : 2)) return std::nullopt;
  if ((words.back() >> 63) == 0) return std::nullopt;
  std::vector<mp_limb_t> limbs(words.begin() + 1, words.end());
  mpz_t z;
  detail::mpfr_cell cell(bits);
  mpfr_set_z_2exp(cell.get(), mpz_roinit_n(z, limbs.data(), static_cast<mp_size_t>(limbs.size())),
                  static_cast<mpfr_exp_t>(exponent) - bits, MPFR_RNDN);
  return ball::from_midpoint_radius(
      cell.get(), magnitude::power_of_two((is_node ? 0 : exponent) - std::int64_t{bits}));
}

/// twice the sum of w x^(2k) over the positive nodes, and once the node 0.
ball moment(const gauss_legendre_rule& rule, const std::vector<ball>& terms, bool of_one) {
  const std::size_t first = rule.n % 2 != 0 ? 1 : 0;
  ball sum(0, rule.bits);
  for (std::size_t i = first; i < terms.size(); ++i) sum += terms[i];
  sum = scale(sum, 1);
  if (first != 0 && of_one) sum += rule.weights[0];
  return sum;
}

/// What every Gauss and Legendre rule satisfies, in time proportional to n.
bool is_plausible(const gauss_legendre_rule& rule) {
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    if (!certainly_positive(rule.weights[i])) return false;
    if (i > 0 && !certainly_less(rule.nodes[i - 1], rule.nodes[i])) return false;
  }
  if (rule.n % 2 == 0 && !certainly_positive(rule.nodes.front())) return false;
  if (!certainly_less(rule.nodes.back(), 1)) return false;
  // The integrals of 1, x^2, x^4, and of the highest even power that the rule integrates exactly.
  std::vector<ball> terms = rule.weights;
  for (long k = 0; k <= std::min(rule.n - 1, 2L); ++k) {
    if (!contains(moment(rule, terms, k == 0), rational(2, 2 * k + 1))) return false;
    for (std::size_t i = 0; i < terms.size(); ++i) terms[i] *= square(rule.nodes[i]);
  }
  const long highest = 2 * (rule.n - 1);
  constexpr precision bits_of_highest = 128;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const ball x = rule.nodes[i].with_precision(bits_of_highest);
    terms[i] = rule.weights[i].with_precision(bits_of_highest) * pow(x, highest);
  }
  return contains(moment(rule, terms, highest == 0), rational(2, highest + 1));
}

/// The rule in the bytes of a file, or nothing where they are not believed.
std::optional<gauss_legendre_rule> believed(const bytes& content, long n, precision bits) {
  if (content.size() != size_of_file(n, bits)) return std::nullopt;
  const header expected = header_of(n, bits);
  if (std::memcmp(content.data(), expected.data(), sizeof(header)) != 0) return std::nullopt;
  const std::size_t payload_end = content.size() - digest_size;
  const sha256_digest digest = sha256(std::span(content).first(payload_end));
  if (std::memcmp(content.data() + payload_end, digest.data(), digest_size) != 0) {
    return std::nullopt;
  }
  gauss_legendre_rule rule{n, bits, {}, {}};
  const std::byte* at = content.data() + sizeof(header);
  const std::size_t step = (1 + limbs_of(bits)) * sizeof(word);
  if (n % 2 != 0) rule.nodes.emplace_back(0, bits);
  for (long i = 0; i < n / 2 + (n + 1) / 2; ++i, at += step) {
    const bool is_node = i < n / 2;
    std::optional<ball> x = decoded(at, bits, is_node);
    if (!x) return std::nullopt;
    (is_node ? rule.nodes : rule.weights).push_back(std::move(*x));
  }
  if (!is_plausible(rule)) return std::nullopt;
  return rule;
}

// ---------------------------------------------------------------------------------------------
// Files. Every failure is silent: the rule is made again.

/// Gives errno back as it was: a caller whose policy answers by errno sees nothing of the files.
class errno_kept {
 public:
  errno_kept() = default;
  ~errno_kept() { errno = before_; }
  errno_kept(const errno_kept&) = delete;
  errno_kept& operator=(const errno_kept&) = delete;
  errno_kept(errno_kept&&) = delete;
  errno_kept& operator=(errno_kept&&) = delete;

 private:
  int before_ = errno;
};

std::optional<bytes> content_of(const fs::path& path, std::size_t expected_size) {
  const errno_kept kept;
  std::error_code failure;
  if (!fs::is_regular_file(path, failure)) return std::nullopt;  // opening a pipe would wait
  std::ifstream in(path, std::ios::binary);
  if (!in) return std::nullopt;
  // A byte more than expected, to see where a file is longer.
  bytes content(expected_size + 1);
  in.read(reinterpret_cast<char*>(content.data()), static_cast<std::streamsize>(content.size()));
  content.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  return content;
}

/// Writes the whole of the bytes to the open file.
bool write_all(int file, const bytes& content) {
  for (std::size_t done = 0; done < content.size();) {
    const ssize_t now = ::write(file, content.data() + done, content.size() - done);
    if (now <= 0) return false;
    done += static_cast<std::size_t>(now);
  }
  return true;
}

/// Puts the file in its place, whole, or does nothing. Two that do so at once write the same bytes.
bool put(const fs::path& directory, const std::string& name, const bytes& content) {
  const errno_kept kept;
  std::error_code failure;
  fs::create_directories(directory, failure);
  if (failure) return false;
  std::string unfinished = (directory / name).string() + std::string(name_of_unfinished) + "XXXXXX";
  const int file = ::mkstemp(unfinished.data());
  if (file < 0) return false;
  bool done = write_all(file, content);
  done = ::close(file) == 0 && done;
  if (done) {
    fs::rename(unfinished, directory / name, failure);
    done = !failure;
  }
  if (!done) fs::remove(unfinished, failure);
  return done;
}

/// Deletes what a process left that ended while it wrote, and the oldest rules beyond the total.
void prune(const fs::path& directory, std::uintmax_t most_bytes) {
  const errno_kept kept;
  struct found {
    fs::path path;
    fs::file_time_type time;
    std::uintmax_t size;
  };
  std::vector<found> rules;
  std::uintmax_t total = 0;
  std::error_code failure;
  const auto hour_ago = fs::file_time_type::clock::now() - std::chrono::hours(1);
  for (fs::directory_iterator at(directory, failure), end; !failure && at != end;
       at.increment(failure)) {
    const std::string name = at->path().filename().string();
    if (!name.starts_with(name_start)) continue;
    std::error_code gone;
    const auto time = at->last_write_time(gone);
    if (gone) continue;
    const auto size = at->file_size(gone);
    if (gone) continue;
    if (name.ends_with(name_end)) {
      rules.push_back({at->path(), time, size});
      total += size;
    } else if (name.find(name_of_unfinished) != std::string::npos && time < hour_ago) {
      fs::remove(at->path(), gone);
    }
  }
  std::sort(rules.begin(), rules.end(),
            [](const found& x, const found& y) { return x.time < y.time; });
  for (const found& oldest : rules) {
    if (total <= most_bytes) break;
    std::error_code gone;
    fs::remove(oldest.path, gone);
    total -= oldest.size;
  }
}

/// The variable's text; nothing where it is not set.
std::optional<std::string> environment_variable(const char* name) {
  const char* text = std::getenv(name);
  if (text == nullptr) return std::nullopt;
  return text;
}

}  // namespace

node_cache::node_cache(std::string directory, std::uintmax_t most_bytes, double least_seconds)
    : directory_(std::move(directory)), most_bytes_(most_bytes), least_seconds_(least_seconds) {}

std::string node_cache::directory_of_user() {
  const auto is_absolute = [](const std::optional<std::string>& path) {
    return path && fs::path(*path).is_absolute();
  };
  if (const auto own = environment_variable("POLHODE_CACHE")) {
    return is_absolute(own) ? *own : std::string();
  }
  if (const auto base = environment_variable("XDG_CACHE_HOME"); is_absolute(base)) {
    return (fs::path(*base) / "polhode").string();
  }
  if (const auto home = environment_variable("HOME"); is_absolute(home)) {
    return (fs::path(*home) / ".cache" / "polhode").string();
  }
  return {};
}

node_cache& node_cache::of_process() {
  static node_cache cache(directory_of_user());
  return cache;
}

std::shared_ptr<const gauss_legendre_rule> node_cache::get(long n, precision bits) {
  std::shared_ptr<entry> wanted;
  {
    const std::lock_guard lock(mutex_);
    auto& place = entries_[{n, bits}];
    if (!place) place = std::make_shared<entry>();
    wanted = place;
  }
  // One thread makes a rule, and others that want the same one wait for it.
  const std::lock_guard making(wanted->making);
  if (wanted->rule) return wanted->rule;
  std::optional<gauss_legendre_rule> rule = read(n, bits);
  if (!rule) {
    const auto start = std::chrono::steady_clock::now();
    rule = make_gauss_legendre(n, bits);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    {
      const std::lock_guard lock(mutex_);
      ++counters_.made;
    }
    if (taken.count() >= least_seconds_) write(*rule);
  }
  wanted->rule = std::make_shared<const gauss_legendre_rule>(std::move(*rule));
  return wanted->rule;
}

std::optional<gauss_legendre_rule> node_cache::read(long n, precision bits) {
  if (directory_.empty() || n < 1 || n > greatest_gauss_legendre_degree || bits < 64 ||
      bits % 64 != 0) {
    return std::nullopt;  // make_gauss_legendre says what is wrong
  }
  const auto size = size_of_file(n, bits);
  if (size > most_bytes_) return std::nullopt;
  const auto content = content_of(fs::path(directory_) / file_name(n, bits), size);
  if (!content) return std::nullopt;
  auto rule = believed(*content, n, bits);
  const std::lock_guard lock(mutex_);
  ++(rule ? counters_.read : counters_.refused);
  return rule;
}

void node_cache::write(const gauss_legendre_rule& rule) {
  if (directory_.empty() || size_of_file(rule.n, rule.bits) > most_bytes_) return;
  if (!put(directory_, file_name(rule.n, rule.bits), encoded(rule))) return;
  prune(directory_, most_bytes_);
  const std::lock_guard lock(mutex_);
  ++counters_.written;
}

node_cache::counters node_cache::statistics() const {
  const std::lock_guard lock(mutex_);
  return counters_;
}

}  // namespace polhode
