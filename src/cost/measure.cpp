#include "measure.hpp"

#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <map>
#include <stdexcept>

#include <gmp.h>

#include "base/clock.hpp"
#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/mpfr_cell.hpp"
#include "polhode/arithmetic/text.hpp"

namespace polhode::cost {
namespace {

using detail::processor_seconds;

double seconds_of(const std::function<void()>& f) {
  const auto start = detail::clock::now();
  f();
  return detail::seconds_since(start);
}

double median(std::vector<double> x) {
  const auto middle = x.begin() + static_cast<std::ptrdiff_t>(x.size() / 2);
  std::nth_element(x.begin(), middle, x.end());
  return *middle;
}

// ---------------------------------------------------------------------------------------------
// Memory: GMP's functions, through which MPFR allocates too

struct memory_count {
  std::atomic<std::int64_t> live{0};
  std::atomic<std::int64_t> most{0};
  // Those of before, which know what to do where there is no more memory.
  void* (*allocate)(std::size_t) = nullptr;
  void* (*reallocate)(void*, std::size_t, std::size_t) = nullptr;
  void (*release)(void*, std::size_t) = nullptr;

  void change(std::int64_t bytes) {
    const std::int64_t now = live += bytes;
    std::int64_t before = most;
    while (now > before && !most.compare_exchange_weak(before, now)) {
    }
  }
};
memory_count& counted_memory() {
  static memory_count count;
  return count;
}
extern "C" {
void* counted_allocate(std::size_t n) {
  counted_memory().change(static_cast<std::int64_t>(n));
  return counted_memory().allocate(n);
}
void* counted_reallocate(void* p, std::size_t before, std::size_t n) {
  counted_memory().change(static_cast<std::int64_t>(n) - static_cast<std::int64_t>(before));
  return counted_memory().reallocate(p, before, n);
}
void counted_free(void* p, std::size_t n) {
  counted_memory().change(-static_cast<std::int64_t>(n));
  counted_memory().release(p, n);
}
}

/// Counts while it lives.
class memory_counting {
 public:
  memory_counting() {
    memory_count& count = counted_memory();
    mp_get_memory_functions(&count.allocate, &count.reallocate, &count.release);
    counted_memory().live = 0;
    counted_memory().most = 0;
    mp_set_memory_functions(counted_allocate, counted_reallocate, counted_free);
  }
  ~memory_counting() {
    const memory_count& count = counted_memory();
    mp_set_memory_functions(count.allocate, count.reallocate, count.release);
  }
  memory_counting(const memory_counting&) = delete;
  memory_counting& operator=(const memory_counting&) = delete;
  memory_counting(memory_counting&&) = delete;
  memory_counting& operator=(memory_counting&&) = delete;
  [[nodiscard]] static double most() { return static_cast<double>(counted_memory().most.load()); }
};

// ---------------------------------------------------------------------------------------------
// Accuracy

/// About log10 of a magnitude above 0.
double log10_of(const magnitude& x) {
  return log10(upper(ball(0, 64).enlarged(x))).convert_to<double>();
}

/// log10 of the greatest |x - y|/|y|.
std::optional<double> log10_of_distance(const ball& x, const ball& y) {
  if (!x.is_bounded() || !y.is_bounded() || contains_zero(y)) return std::nullopt;
  const magnitude distance = (x - y).magnitude_upper();
  if (distance.is_zero()) return -1e9;
  return log10_of(divide_up(distance, y.magnitude_lower()));
}

}  // namespace

bool measurement::has_digits() const {
  return log10_error && *log10_error <= -static_cast<double>(digits);
}
bool measurement::claims_too_much() const {
  return !has_digits() && log10_claimed && (!log10_error || *log10_claimed < *log10_error - 1);
}

measurement measure(const method& m, long digits, const std::optional<ball>& reference,
                    double least_seconds) {
  measurement result;
  result.digits = digits;
  {
    estimate first;
    {
      const memory_counting counting;
      first = m.compute(digits);
      result.bytes = memory_counting::most();
    }
    result.evaluations = first.evaluations;
    result.log10_claimed = first.log10_claimed;
    if (m.certified) {
      const ball& value = first.value;
      if (value.is_bounded() && !contains_zero(value)) {
        result.log10_error = value.radius().is_zero()
                                 ? -1e9
                                 : log10_of(divide_up(value.radius(), value.magnitude_lower()));
      }
    } else if (reference) {
      result.log10_error = log10_of_distance(first.value, *reference);
    }
  }
  constexpr std::size_t most_calls = 25;
  std::vector<double> times;
  double sum = 0;
  while (times.empty() || (sum < least_seconds && times.size() < most_calls)) {
    double taken = seconds_of([&] { (void)m.compute(digits); });
    // Short calls many at a time, so that the clock's grain does not show.
    constexpr double short_call = 1e-4;
    if (taken < short_call) {
      const auto calls = static_cast<int>(short_call / std::max(taken, 1e-7)) + 1;
      taken = seconds_of([&] {
                for (int i = 0; i < calls; ++i) (void)m.compute(digits);
              }) /
              calls;
      sum += taken * calls;
    } else {
      sum += taken;
    }
    times.push_back(taken);
  }
  result.seconds = median(times);
  return result;
}

// ---------------------------------------------------------------------------------------------
// The first call in a process

namespace {

struct cold_request {
  std::size_t quantity = 0;
  std::size_t method = 0;
  long digits = 0;
};

/// In a child: what it is asked for, each in a child of its own, until there is no more to read.
[[noreturn]] void serve(int parent) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) std::signal(signal, SIG_DFL);
  // Nothing is kept on disk, and nothing that was is read.
  setenv("XDG_CACHE_HOME", "/dev/null/none", 1);
  cold_request what;
  while (read(parent, &what, sizeof what) == ssize_t{sizeof what}) {
    const pid_t child = fork();
    if (child == 0) {
      double taken = -1;
      try {
        const method& m = quantities()[what.quantity].methods[what.method];
        taken = seconds_of([&] { (void)m.compute(what.digits); });
      } catch (...) {  // nothing was measured
      }
      const bool written = write(parent, &taken, sizeof taken) == ssize_t{sizeof taken};
      _exit(written ? 0 : 1);
    }
    int status = 1;
    if (child < 0 || waitpid(child, &status, 0) < 0 || status != 0) {
      const double none = -1;
      if (write(parent, &none, sizeof none) != ssize_t{sizeof none}) break;
    }
  }
  _exit(0);
}

}  // namespace

cold_processes::cold_processes() {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0) return;
  process_ = fork();
  if (process_ == 0) {
    close(ends[0]);
    serve(ends[1]);
  }
  close(ends[1]);
  child_ = ends[0];
}

cold_processes::~cold_processes() {
  if (child_ >= 0) close(child_);
  if (process_ > 0) waitpid(process_, nullptr, 0);
}

std::optional<double> cold_processes::seconds(std::size_t q, std::size_t m, long digits) const {
  if (process_ <= 0) return std::nullopt;
  const cold_request what{q, m, digits};
  double taken = -1;
  // No signal where the child has been killed.
  if (send(child_, &what, sizeof what, MSG_NOSIGNAL) != ssize_t{sizeof what} ||
      read(child_, &taken, sizeof taken) != ssize_t{sizeof taken} || taken < 0) {
    return std::nullopt;
  }
  return taken;
}

// ---------------------------------------------------------------------------------------------
// Time at other digits

std::optional<double> extrapolated_seconds(const std::vector<measurement>& known, long digits) {
  if (known.empty()) return std::nullopt;
  const measurement& last = known.back();
  constexpr double usual = 2;
  constexpr double most = 4;
  double exponent = usual;
  if (known.size() > 1) {
    const measurement& before = known[known.size() - 2];
    const double measured =
        std::log(last.seconds / before.seconds) /
        std::log(static_cast<double>(last.digits) / static_cast<double>(before.digits));
    exponent = std::clamp(measured, 1.0, most);
  }
  return last.seconds *
         std::pow(static_cast<double>(digits) / static_cast<double>(last.digits), exponent);
}

std::optional<double> growth_exponent(const std::vector<measurement>& known) {
  const auto has_many = [](const measurement& m) { return m.digits >= 300; };
  constexpr std::size_t enough = 3;
  if (known.size() < enough) return std::nullopt;
  const auto first =
      std::min(std::find_if(known.begin(), known.end(), has_many), known.end() - enough);
  double n = 0;
  double x = 0;
  double y = 0;
  double xx = 0;
  double xy = 0;
  for (auto m = first; m != known.end(); ++m) {
    if (!(m->seconds > 0)) return std::nullopt;
    const double u = std::log(static_cast<double>(m->digits));
    const double v = std::log(m->seconds);
    n += 1;
    x += u;
    y += v;
    xx += u * u;
    xy += u * v;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

double undisturbed_seconds(const std::function<void()>& f) {
  constexpr double long_call = 0.005;
  constexpr double enough = 0.01;
  constexpr int least_calls = 3;
  const double start = processor_seconds();
  double shortest = seconds_of(f);
  if (shortest > long_call) return std::min(shortest, processor_seconds() - start);
  double sum = shortest;
  for (int calls = 1; calls < least_calls || sum < enough; ++calls) {
    const double taken = seconds_of(f);
    shortest = std::min(shortest, taken);
    sum += taken;
  }
  return shortest;
}

double multiplication_seconds(long digits) {
  // Beyond, it grows as n log n.
  constexpr long most_measured = 1'000'000;
  if (digits > most_measured) {
    const auto n = static_cast<double>(digits);
    const auto known = static_cast<double>(most_measured);
    return multiplication_seconds(most_measured) * (n / known) * (std::log(n) / std::log(known));
  }
  const precision bits = bits_for_digits(digits);
  detail::mpfr_cell x(bits);
  detail::mpfr_cell y(bits);
  detail::mpfr_cell product(bits);
  mpfr_sqrt_ui(x.get(), 2, MPFR_RNDN);
  mpfr_sqrt_ui(y.get(), 3, MPFR_RNDN);
  const auto seconds_of_calls = [&](int calls) {
    return seconds_of([&] {
      for (int i = 0; i < calls; ++i) mpfr_mul(product.get(), x.get(), y.get(), MPFR_RNDN);
    });
  };
  constexpr double short_time = 1e-4;
  int calls = 1;
  double taken = seconds_of_calls(calls);
  while (taken < short_time && calls < (1 << 24)) {
    calls *= 4;
    taken = seconds_of_calls(calls);
  }
  constexpr int rounds = 6;
  for (int i = 0; i < rounds; ++i) taken = std::min(taken, seconds_of_calls(calls));
  return taken / calls;
}

cost_model::cost_model(std::vector<std::pair<long, double>> known,
                       std::function<double(long digits)> multiplication)
    : known_(std::move(known)), multiplication_(std::move(multiplication)) {
  if (known_.empty()) throw std::invalid_argument("cost_model: it needs a time at least");
  const auto last = known_.rbegin();
  // The exponent between the last time and an earlier one.
  const auto exponent_from = [&](const std::pair<long, double>& earlier) {
    const auto& [n, t] = *last;
    const auto& [n_before, t_before] = earlier;
    return std::log(t / t_before / (multiplication_(n) / multiplication_(n_before))) /
           std::log(static_cast<double>(n) / static_cast<double>(n_before));
  };
  if (known_.size() < 2) return;
  exponent_ = exponent_from(last[1]);
  if (known_.size() > 2) exponent_ = std::max(exponent_, exponent_from(last[2]));
  constexpr double least = -0.5;
  constexpr double most = 2;
  exponent_ = std::clamp(exponent_, least, most);
}

double cost_model::seconds(long digits) const {
  const auto& [last, last_seconds] = known_.back();
  if (digits <= known_.front().first) return known_.front().second;
  if (digits > last) {
    constexpr double near = 4;
    constexpr double least_far = 0.1;
    const double leap = static_cast<double>(digits) / static_cast<double>(last);
    const double near_leap = std::min(leap, near);
    return last_seconds * multiplication_(digits) / multiplication_(last) *
           std::pow(near_leap, exponent_) *
           std::pow(leap / near_leap, std::max(exponent_, least_far));
  }
  const auto above = std::find_if(known_.begin() + 1, known_.end(),
                                  [=](const auto& k) { return digits <= k.first; });
  const auto& [n0, t0] = *std::prev(above);
  const auto& [n1, t1] = *above;
  const double share = std::log(static_cast<double>(digits) / static_cast<double>(n0)) /
                       std::log(static_cast<double>(n1) / static_cast<double>(n0));
  return t0 * std::pow(t1 / t0, share);
}

std::optional<double> estimated_seconds(const std::function<double(long digits)>& timed,
                                        long digits, long most_timed, double longest_call,
                                        const std::function<double(long digits)>& multiplication) {
  // Each is measured once.
  std::map<long, double> multiplications;
  const auto of_multiplication = [&](long n) {
    const auto found = multiplications.find(n);
    if (found != multiplications.end()) return found->second;
    return multiplications[n] = multiplication(n);
  };
  constexpr long first_digits = 30;
  constexpr long step = 2;
  constexpr double always_allowed = 0.03;
  constexpr double share = 0.1;
  std::vector<std::pair<long, double>> known;
  std::optional<double> estimate;
  for (long n = first_digits; n <= most_timed; n *= step) {
    if (!known.empty()) {
      const double allowed = std::min(std::max(always_allowed, share * *estimate), longest_call);
      if (cost_model(known, of_multiplication).seconds(n) > allowed) break;
    }
    // Of a time of 0, which a coarse clock may say, there is no logarithm.
    constexpr double grain = 1e-9;
    known.emplace_back(n, std::max(timed(n), grain));
    estimate = cost_model(known, of_multiplication).seconds(digits);
  }
  return estimate;
}

double estimate_cost(const std::string& name, long digits) {
  for (const quantity& q : quantities()) {
    if (q.name != name) continue;
    const method& m = q.methods.front();
    const auto timed = [&](long n) {
      (void)m.compute(n);  // what is made once and kept
      return undisturbed_seconds([&] { (void)m.compute(n); });
    };
    return estimated_seconds(timed, digits, std::max(30L, std::min(m.most_digits, digits)), 1)
        .value();
  }
  throw std::invalid_argument("estimate_cost: there is no quantity " + name);
}

bool is_short_work(const std::function<void(long digits)>& work, long digits, double seconds) {
  constexpr long first_digits = 30;
  constexpr long step = 8;
  constexpr double little = 0.03;
  try {
    double taken = 0;
    for (long n = first_digits; n < digits && taken <= little; n *= step) {
      taken = seconds_of([&] { work(n); });
      if (taken * std::pow(static_cast<double>(digits) / static_cast<double>(n), 3) <= seconds) {
        return true;
      }
    }
  } catch (const std::exception&) {  // said when it is done with all digits
  }
  return false;
}

std::optional<double> estimated_seconds_of_work(const std::function<void(long digits)>& work,
                                                long digits) {
  constexpr double longest_call = 1;
  const auto timed = [&](long n) { return undisturbed_seconds([&] { work(n); }); };
  try {
    return estimated_seconds(timed, digits, digits / 2, longest_call);
  } catch (
      const std::exception&) {  // what is to be said of it is said when it is done with all digits
    return std::nullopt;
  }
}

}  // namespace polhode::cost
