#pragma once

// A function taken apart into oscillations, by its recording: step 1 of what oscillation.hpp
// describes.
//
//   f(x) |dx/dy| = sum over w of W_w(y) e^(i w y),   x = p + s y^theta,
//
// with W_w = u + i v, u and v recorded functions of y. The sum and the product of such sums is one;
// the sine or cosine of P = w y + R is one where P is known as a sum of powers of y, and R's are
// not positive.

#include <map>
#include <optional>
#include <vector>

#include "quadrature/formula/recorded.hpp"
#include "quadrature/formula/recorded_formula.hpp"

namespace polhode::detail::oscillations {

/// The sum of q_n times constants by the numbers of their nodes; 0, the argument's, stands for 1.
using frequency = std::map<std::size_t, rational>;

/// u + i v, 0 where there is none.
struct amplitude {
  std::optional<recorded> re;
  std::optional<recorded> im;
};

/// The values of an amplitude's two parts, or of one node, in any arithmetic.
class program_of_parts {
 public:
  program_of_parts(recorded y, const amplitude& a) : y_(std::move(y)) {
    for (const auto* part : {&a.re, &a.im}) {
      results_.push_back(*part ? std::optional((*part)->node()) : std::nullopt);
    }
    prepare();
  }
  program_of_parts(recorded y, std::size_t node) : y_(std::move(y)), results_{node} { prepare(); }

  /// Part k, if it is not 0, at a point.
  template <class T>
  [[nodiscard]] std::vector<std::optional<T>> operator()(const T& z) const {
    evaluation<T> values(y_.nodes(), z);
    for (const std::size_t i : steps_) values.step(i, std::nullopt);
    std::vector<std::optional<T>> parts;
    parts.reserve(results_.size());
    for (const auto& node : results_) {
      parts.push_back(node ? std::optional<T>(values[*node]) : std::nullopt);
    }
    return parts;
  }

 private:
  void prepare() {
    const recorded_nodes& nodes = y_.nodes();
    std::vector<bool> needed(nodes.size());
    for (const auto& node : results_) {
      if (node) needed[*node] = true;
    }
    for (std::size_t i = nodes.size(); i-- > 0;) {
      const recorded_node& node = nodes[i];
      if (!needed[i]) continue;
      steps_.push_back(i);
      if (node.what == recorded_node::kind::function) needed[node.left] = needed[node.right] = true;
      if (node.what == recorded_node::kind::power) needed[node.left] = true;
    }
    std::reverse(steps_.begin(), steps_.end());
  }

  recorded y_;
  std::vector<std::optional<std::size_t>> results_;
  std::vector<std::size_t> steps_;
};

/// f(x) |dx/dy| taken apart. The recording that is made does not depend on the precision, but for
/// the enclosures of its constants.
struct separated {
  /// y, in the recording of the amplitudes.
  recorded y;
  /// The amplitudes of e^(i w y), those of w and -w conjugate; nothing where f is not found to be
  /// such a sum.
  std::optional<std::map<frequency, amplitude>> terms;
  /// Where a phase grows like another power than y: that power.
  std::optional<rational> growth;
};

/// f between x = at + s and `at`, or an infinity, as a function of y with x = at + s y^theta, with
/// constants to p bits. The integral counts with this sign.
[[nodiscard]] separated separate(const formula& f, precision p, const end_point& at,
                                 const end_point& s, const rational& theta, int sign);

}  // namespace polhode::detail::oscillations
