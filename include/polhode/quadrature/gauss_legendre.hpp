#pragma once

// The Gauss and Legendre rule: the integral of f over [-1, 1] is about sum of w_i f(x_i) over the n
// zeros x_i of the Legendre polynomial P_n, exactly so for polynomials of degree up to 2n - 1. The
// bound of its error is gauss_legendre_error (error_bounds.hpp); this header has the nodes and
// weights, as balls that are proved to hold them, and a cache, since they cost far more than the
// sum that they are for.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/quadrature/rule_sum.hpp"

namespace polhode {

/// The n-point rule on [-1, 1].
///
/// Every ball has `bits` bits; the radius of a node is at most 2^-bits, that of a weight at most
/// 2^(1-bits) times its midpoint. The sets of the nodes are disjoint.
using gauss_legendre_rule = symmetric_nodes;

/// Beyond it the polynomial's coefficients take hundreds of megabytes, and a rule minutes to hours.
inline constexpr long greatest_gauss_legendre_degree = 32'768;

/// Computes the rule, whose bits are a multiple of 64 and at least 64: the same bits each time.
/// Throws std::invalid_argument for other bits or for n outside 1 ...
/// greatest_gauss_legendre_degree, std::runtime_error where the proof fails at all working
/// precisions tried (this has never been seen).
[[nodiscard]] gauss_legendre_rule make_gauss_legendre(long n, precision bits);

namespace detail {
/// Let P_n(x) = x^e q(x^2), e = n mod 2. Bounds of what the Taylor polynomial of q at a y_0 in [0,
/// 1], with the terms of order below j >= 1, leaves out of q and of q' where |y - y_0| <= h, h > 0.
struct taylor_remainder {
  magnitude of_value;
  magnitude of_slope;
};
[[nodiscard]] taylor_remainder legendre_taylor_remainder(long n, long j, const magnitude& h);

/// The same from other estimates of the squares of the positive nodes, increasing, in units of
/// 2^-64. No estimate makes a wrong rule: from bad ones the rule takes longer, or is not proved.
[[nodiscard]] gauss_legendre_rule make_gauss_legendre_from(
    long n, precision bits, const std::function<std::vector<std::uint64_t>(long n)>& estimates);
}  // namespace detail

/// The precision at which a rule for p bits is made: a multiple of 64 that is at least p + 2, and
/// of a step of about p/16, so that neighbouring precisions share a rule.
[[nodiscard]] precision gauss_legendre_precision_at_least(precision p);

/// The least degree >= n of a ladder that has all degrees up to 16 and then six to an octave
/// (16, 18, 20, 23, 26, 29 times powers of two), so that few rules serve everything.
/// Throws std::invalid_argument where n < 1 or the answer exceeds greatest_gauss_legendre_degree.
[[nodiscard]] long gauss_legendre_degree_at_least(long n);

/// Rules that were made before, in memory and, where it was given a directory, in files. What it
/// answers is what make_gauss_legendre answers, bit for bit, whatever is or is not in it: only time
/// depends on it. Any number of threads may use one cache, and any number of processes one
/// directory.
///
/// A file holds one rule: a header (format, library version, byte order, n, bits), the significands
/// and exponents, and a SHA-256 digest of all that. What is read is believed only if the header is
/// the expected one, the digest is right, the nodes increase from 0 to 1, the weights are positive,
/// and the rule integrates some powers of x correctly, in balls. That guards against accidents (a
/// full disk, another version, a damaged sector), not against somebody who forges files in the
/// user's own directory. A file that is not believed is ignored, and written anew. Files are
/// written beside their place and renamed, so that no half of one is ever read; where that fails,
/// nothing is kept and nothing is said.
class node_cache {
 public:
  /// In memory only.
  node_cache() = default;
  /// In memory and in that directory, which is made when it is first written to. An empty name
  /// means none.
  explicit node_cache(std::string directory, std::uintmax_t most_bytes = default_most_bytes,
                      double least_seconds = default_least_seconds);

  /// The directory for this user: $POLHODE_CACHE where that is an absolute path, none where it is
  /// set to anything else ("off"), otherwise $XDG_CACHE_HOME/polhode, otherwise
  /// $HOME/.cache/polhode; none where neither of these is an absolute path.
  [[nodiscard]] static std::string directory_of_user();
  /// The cache of this process, in directory_of_user() as it was at the first call. A memo: no
  /// result depends on it.
  [[nodiscard]] static node_cache& of_process();

  /// make_gauss_legendre(n, bits).
  [[nodiscard]] std::shared_ptr<const gauss_legendre_rule> get(long n, precision bits);

  struct counters {
    long made = 0;     // computed
    long read = 0;     // taken from a file
    long refused = 0;  // found in a file that was not believed
    long written = 0;  // to a file
  };
  [[nodiscard]] counters statistics() const;

  /// Files beyond this total are deleted, the oldest first, when one is written.
  static constexpr std::uintmax_t default_most_bytes = std::uintmax_t{64} << 20;
  /// Rules that took less time than this to make are not written to files.
  static constexpr double default_least_seconds = 0.005;

 private:
  struct entry {
    std::mutex making;
    std::shared_ptr<const gauss_legendre_rule> rule;
  };

  [[nodiscard]] std::optional<gauss_legendre_rule> read(long n, precision bits);
  void write(const gauss_legendre_rule& rule);

  std::string directory_;
  std::uintmax_t most_bytes_ = default_most_bytes;
  double least_seconds_ = default_least_seconds;
  mutable std::mutex mutex_;  // of the two below
  std::map<std::pair<long, precision>, std::shared_ptr<entry>> entries_;
  counters counters_;
};

/// The n-point rule with radii below 2^-p (absolute for nodes, relative for weights): made at
/// gauss_legendre_precision_at_least(p), which does not depend on what the cache holds.
/// Throws as make_gauss_legendre does.
[[nodiscard]] std::shared_ptr<const gauss_legendre_rule> gauss_legendre(
    long n, precision p, node_cache& cache = node_cache::of_process());

}  // namespace polhode
