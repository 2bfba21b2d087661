#include "cost_report.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "json_document.hpp"
#include "layout.hpp"

namespace polhode::cli {
namespace {

using cost::measurement;
using cost_json = nlohmann::json;

std::string seconds_text(double seconds) {
  // To three digits 0.9996 s is 1 s.
  constexpr double rounds_up = 0.9995;
  if (seconds < rounds_up * 1e-6) return fmt::format("{:.3g} ns", seconds * 1e9);
  if (seconds < rounds_up * 1e-3) return fmt::format("{:.3g} us", seconds * 1e6);
  if (seconds < rounds_up) return fmt::format("{:.3g} ms", seconds * 1e3);
  return fmt::format("{:.3g} s", seconds);
}

/// A mark after the time where the digits are not reached.
std::string mark_of(const measurement& m) {
  if (m.has_digits()) return "";
  return m.claims_too_much() ? "!" : "*";
}

const measurement* at_digits(const measured_method& m, long digits) {
  const auto found = std::find_if(m.points.begin(), m.points.end(),
                                  [=](const measurement& x) { return x.digits == digits; });
  return found == m.points.end() ? nullptr : &*found;
}

constexpr std::size_t name_width = 21;
constexpr std::size_t cell_width = 10;
constexpr std::size_t columns_of_block = (terminal_columns - name_width) / cell_width;

/// The digits in blocks that fit the terminal.
std::vector<std::vector<long>> blocks_of(const std::vector<long>& digits) {
  std::vector<std::vector<long>> result;
  for (std::size_t i = 0; i < digits.size(); i += columns_of_block) {
    const auto first = digits.begin() + static_cast<std::ptrdiff_t>(i);
    const auto last =
        digits.begin() + static_cast<std::ptrdiff_t>(std::min(i + columns_of_block, digits.size()));
    result.emplace_back(first, last);
  }
  return result;
}

std::string padded(const std::string& text) { return fmt::format("{:>{}}", text, cell_width); }

/// The certified method and the same in mpfr_float, as their names say.
struct price_pair {
  const measured_method* certified;
  const measured_method* floating;
};
std::vector<price_pair> pairs_of(const measured_quantity& q) {
  std::vector<price_pair> result;
  for (const measured_method& m : q.methods) {
    for (const measured_method& other : q.methods) {
      if (other.what->name == m.what->name + ", floating") result.push_back({&m, &other});
    }
  }
  return result;
}

/// "Left out for want of time (--seconds): tanh-sinh from 3000 digits on; ..." in lines; none where
/// nothing was.
template <class Methods, class NameOf>
std::string left_out_text(const Methods& methods, const NameOf& name_of, const char* from) {
  std::string names;
  for (const auto& m : methods) {
    if (m.left_out.empty()) continue;
    names += (names.empty() ? "" : "; ") + name_of(m) +
             fmt::format(fmt::runtime(from), m.left_out.front());
  }
  std::string result;
  if (names.empty()) return result;
  for (const std::string& line :
       wrapped("Left out for want of time (--seconds): " + names, terminal_columns - 2)) {
    result += "  " + line + '\n';
  }
  return result;
}

std::string text_of(const measured_quantity& q, const std::vector<long>& digits) {
  std::string result;
  for (const std::string& line :
       wrapped(q.what->name + ": " + q.what->description, terminal_columns)) {
    result += line + '\n';
  }
  for (const std::vector<long>& block : blocks_of(digits)) {
    std::string heading = fmt::format("{:<{}}", "  METHOD \\ DIGITS", name_width);
    for (const long n : block) heading += padded(std::to_string(n));
    result += heading + '\n';
    for (const measured_method& m : q.methods) {
      std::string line = fmt::format("  {:<{}}", m.what->name, name_width - 2);
      for (const long n : block) {
        const measurement* point = at_digits(m, n);
        line += padded(point == nullptr ? "-" : seconds_text(point->seconds) + mark_of(*point));
      }
      result += line + '\n';
    }
    std::string cold = fmt::format("  {:<{}}", "in a new process", name_width - 2);
    bool has_cold = false;
    cold.resize(name_width, ' ');
    for (const long n : block) {
      const measurement* point = at_digits(q.methods.front(), n);
      const bool known = point != nullptr && point->cold_seconds;
      has_cold = has_cold || known;
      cold += padded(known ? seconds_text(*point->cold_seconds) : "-");
    }
    if (has_cold) result += cold + '\n';
    for (const auto& [certified, floating] : pairs_of(q)) {
      std::string line = fmt::format("  {:<{}}", "price of certainty", name_width - 2);
      for (const long n : block) {
        const measurement* one = at_digits(*certified, n);
        const measurement* other = at_digits(*floating, n);
        line += padded(one == nullptr || other == nullptr
                           ? "-"
                           : fmt::format("{:.2f}", one->seconds / other->seconds));
      }
      result += line + '\n';
    }
  }
  std::string growth;
  for (const measured_method& m : q.methods) {
    if (const auto e = cost::growth_exponent(m.points)) {
      growth += fmt::format("{}{} n^{:.2f}", growth.empty() ? "" : "; ", m.what->name, *e);
    }
  }
  if (!growth.empty()) {
    for (const std::string& line :
         wrapped("Growth with n digits: " + growth, terminal_columns - 2)) {
      result += "  " + line + '\n';
    }
  }
  result += left_out_text(
      q.methods, [](const measured_method& m) { return m.what->name; }, " from {} digits on");
  return result + '\n';
}

std::string text_of(const measured_family& f) {
  std::string result;
  for (const std::string& line :
       wrapped(fmt::format("hard {}: {}; {} digits", f.what->name, f.what->description, f.digits),
               terminal_columns)) {
    result += line + '\n';
  }
  for (const std::vector<long>& block : blocks_of(f.what->exponents)) {
    std::string heading = fmt::format("{:<{}}", "  METHOD \\ k", name_width);
    for (const long k : block) heading += padded(std::to_string(k));
    result += heading + '\n';
    for (const auto& m : f.methods) {
      std::string line = fmt::format("  {:<{}}", m.name, name_width - 2);
      for (const long k : block) {
        const auto found = std::find_if(m.points.begin(), m.points.end(),
                                        [=](const auto& point) { return point.first == k; });
        line += padded(found == m.points.end()
                           ? "-"
                           : seconds_text(found->second.seconds) + mark_of(found->second));
      }
      result += line + '\n';
    }
  }
  result += left_out_text(
      f.methods, [](const auto& m) { return m.name; }, " from k = {} on");
  return result + '\n';
}

cost_json number_or_null(const std::optional<double>& x) {
  return x ? cost_json(*x) : cost_json(nullptr);
}

cost_json json_of(const measurement& m) {
  return {{"digits", m.digits},
          {"seconds", m.seconds},
          {"cold_seconds", number_or_null(m.cold_seconds)},
          {"log10_error", number_or_null(m.log10_error)},
          {"log10_claimed", number_or_null(m.log10_claimed)},
          {"has_digits", m.has_digits()},
          {"evaluations", m.evaluations},
          {"bytes", m.bytes}};
}

std::string csv_of(const std::string& what, const std::string& method, bool certified,
                   const std::string& k, const measurement& m) {
  const auto cell = [](const std::optional<double>& x) {
    return x ? fmt::format("{:.6g}", *x) : "";
  };
  std::string remark;  // on what is empty
  const auto is_missing = [&](bool missing, const char* why) {
    if (missing) remark += (remark.empty() ? "" : "; ") + std::string(why);
  };
  is_missing(k.empty(), "no hard case, no k");
  is_missing(!m.cold_seconds, "no first call measured");
  is_missing(!m.log10_error, "the method gave no number");
  is_missing(!m.log10_claimed, "it claims no error of its own");
  return fmt::format("{},\"{}\",{},{},{},{:.6g},{},{},{},{},{},{:.0f},\"{}\"\n", what, method,
                     certified ? "yes" : "no", k, m.digits, m.seconds, cell(m.cold_seconds),
                     cell(m.log10_error), cell(m.log10_claimed), m.has_digits() ? "yes" : "no",
                     m.evaluations, m.bytes, remark);
}

/// A line without a measurement.
std::string csv_of_left_out(const std::string& what, const std::string& method, bool certified,
                            const std::string& k, long digits) {
  return fmt::format("{},\"{}\",{},{},{},,,,,,,,\"left out for want of time (--seconds)\"\n", what,
                     method, certified ? "yes" : "no", k, digits);
}

// ---------------------------------------------------------------------------------------------
// Pictures

/// A colour and a point for each method of a list.
std::string style(std::size_t i, bool certified) {
  static const std::vector<std::string> colours{"#20406a", "#b03020", "#2a8040", "#c08010",
                                                "#6a3a8a", "#208090", "#a02070", "#606060",
                                                "#80a020", "#d06090"};
  return fmt::format("with linespoints lw 2 dt {} pt {} lc rgb '{}'", certified ? 1 : 2,
                     certified ? 7 : 6, colours[i % colours.size()]);
}

/// Points of methods that have fewer digits than were asked for, and those among them whose own
/// error estimate says otherwise.
struct failures {
  std::vector<std::pair<double, double>> few_digits;
  std::vector<std::pair<double, double>> claimed;

  void add(double x, const measurement& m) {
    if (!m.has_digits()) few_digits.emplace_back(x, m.seconds);
    if (m.claims_too_much()) claimed.emplace_back(x, m.seconds);
  }
};

/// Data in blocks, and a plot of them.
class plot {
 public:
  void add(const std::vector<std::pair<double, double>>& points, const std::string& how,
           const std::string& title) {
    if (points.empty()) return;
    const std::string name = fmt::format("$data{}", count_++);
    data_ += name + " << EOD\n";
    for (const auto& [x, y] : points) data_ += fmt::format("{:.9g} {:.9g}\n", x, y);
    data_ += "EOD\n";
    plots_ += fmt::format("{}{} {} {}", plots_.empty() ? "plot " : ", ", name, how,
                          title.empty() ? "notitle" : "title \"" + title + '"');
  }
  void add(const failures& of) {
    add(of.few_digits, "with points pt 2 ps 1.8 lw 2 lc rgb '#d00000'",
        "fewer digits than asked for");
    add(of.claimed, "with points pt 6 ps 3 lw 2 lc rgb '#d00000'", "own error estimate too small");
  }
  [[nodiscard]] const std::string& data() const { return data_; }
  /// The command, and a start on the next one.
  [[nodiscard]] std::string take() {
    std::string result =
        plots_.empty() ? "set xrange [1:10]\nset yrange [1:10]\nplot 0.1 notitle\n" : plots_ + '\n';
    plots_.clear();
    return result;
  }

 private:
  int count_ = 0;
  std::string data_;
  std::string plots_;
};

const char* const settings =
    "set encoding utf8\nset grid lc rgb '#cccccc'\nset key noenhanced\nset format y "
    "'10^{%T}'\nset "
    "logscale xy\n";

std::string with_exponent(const measured_method& m) {
  const auto e = cost::growth_exponent(m.points);
  return m.what->name + (e ? fmt::format(": n^{:.2f}", *e) : "");
}

cost_picture picture_of(const measured_quantity& q) {
  plot p;
  failures failed;
  for (std::size_t i = 0; i < q.methods.size(); ++i) {
    const measured_method& m = q.methods[i];
    std::vector<std::pair<double, double>> points;
    for (const measurement& x : m.points) {
      points.emplace_back(x.digits, x.seconds);
      failed.add(static_cast<double>(x.digits), x);
    }
    p.add(points, style(i, m.what->certified), with_exponent(m));
  }
  p.add(failed);
  const std::string times = p.take();
  constexpr double most_digits_drawn = 1e6;
  for (std::size_t i = 0; i < q.methods.size(); ++i) {
    const measured_method& m = q.methods[i];
    std::vector<std::pair<double, double>> points;
    std::vector<std::pair<double, double>> claimed;
    for (const measurement& x : m.points) {
      const double reached = x.log10_error ? -*x.log10_error : 0;
      if (reached > 0.1 && reached < most_digits_drawn) points.emplace_back(x.seconds, reached);
      const double says = x.log10_claimed ? -*x.log10_claimed : 0;
      if (x.claims_too_much() && says < most_digits_drawn) claimed.emplace_back(x.seconds, says);
    }
    p.add(points, style(i, m.what->certified), "");
    p.add(claimed, "with points pt 2 ps 1.5 lw 2 lc rgb '#d00000'",
          m.what->name + " claims, but has not");
  }
  const std::string accuracy = p.take();
  std::string program = settings + p.data();
  // One key for both, below them.
  program += fmt::format(
      "set multiplot layout 1,2 margins 0.06,0.98,0.27,0.88 spacing 0.08,0 title \"{}\" "
      "noenhanced\n",
      q.what->description);
  program +=
      "set key at screen 0.06,0.15 left top vertical maxrows 4 reverse Left samplen 2\nset xlabel "
      "'digits asked for'\nset ylabel 'seconds'\n"
      "set title 'time, and by which power of n digits it grows; certified: full lines'\n" +
      times;
  program +=
      "set key inside top left reverse Left samplen 2\nset xlabel 'seconds'\nset ylabel 'correct "
      "digits'\nset format x '10^{%T}'\nset format y '%g'\n"
      "set title 'accuracy against time'\n" +
      accuracy + "unset multiplot\n";
  return {q.what->name, program};
}

cost_picture picture_of(const measured_family& f) {
  plot p;
  failures failed;
  for (std::size_t i = 0; i < f.methods.size(); ++i) {
    const auto& m = f.methods[i];
    std::vector<std::pair<double, double>> points;
    for (const auto& [k, x] : m.points) {
      const double at = std::max(static_cast<double>(k), 0.5);
      points.emplace_back(at, x.seconds);
      failed.add(at, x);
    }
    p.add(points, style(i, m.certified), m.name);
  }
  p.add(failed);
  const std::string plots = p.take();
  return {"hard_" + f.what->name,
          settings + p.data() +
              fmt::format("set title \"{}; {} digits; certified: full lines\" noenhanced\n",
                          f.what->description, f.digits) +
              "set key outside right top reverse Left samplen 2\nset xlabel 'k" +
              (f.what->exponents.front() == 0 ? " (0 is drawn at 0.5)" : "") +
              "'\nset ylabel 'seconds'\n" + plots};
}

cost_picture certainty(const cost_report& report) {
  plot p;
  std::size_t i = 0;
  for (const measured_quantity& q : report.quantities) {
    for (const auto& [certified, floating] : pairs_of(q)) {
      std::vector<std::pair<double, double>> points;
      for (const measurement& x : certified->points) {
        if (const measurement* y = at_digits(*floating, x.digits)) {
          points.emplace_back(x.digits, x.seconds / y->seconds);
        }
      }
      p.add(points, style(i++, true), q.what->name + ", " + certified->what->name);
    }
  }
  const std::string plots = p.take();
  return {"certainty",
          settings + p.data() +
              "set title 'The price of certainty: time certified over time uncertified'\n"
              "set rmargin 5\nset key top right reverse Left samplen 2\nset xlabel 'digits'\nset "
              "ylabel 'ratio'\n"
              "set format y '%g'\nunset logscale y\nset yrange [0:*]\n" +
              plots};
}

cost_picture cold(const cost_report& report) {
  plot p;
  std::size_t i = 0;
  for (const measured_quantity& q : report.quantities) {
    std::vector<std::pair<double, double>> points;
    for (const measurement& x : q.methods.front().points) {
      if (x.cold_seconds) points.emplace_back(x.digits, *x.cold_seconds / x.seconds);
    }
    p.add(points, style(i++, true), q.what->name);
  }
  const std::string plots = p.take();
  return {"cold", settings + p.data() +
                      "set title 'The first call in a new process over a later one'\n"
                      "set rmargin 5\nset key top right reverse Left samplen 2\nset xlabel "
                      "'digits'\nset ylabel 'ratio'\n"
                      "set format y '%g'\n" +
                      plots};
}

}  // namespace

std::string as_text(const cost_report& report) {
  std::string result;
  for (const measured_quantity& q : report.quantities) result += text_of(q, report.digits);
  for (const measured_family& f : report.families) result += text_of(f);
  result +=
      "Times are medians of later calls on this machine. -: beyond the method's digits, or left "
      "out "
      "(--seconds).\n"
      "*: fewer correct digits than asked for. !: fewer, though its own error estimate "
      "says "
      "otherwise.\n";
  return result;
}

std::string as_csv(const cost_report& report) {
  std::string result =
      "quantity,method,certified,k,digits,seconds,cold_seconds,log10_error,log10_claimed,has_"
      "digits,"
      "evaluations,bytes,remark\n";
  for (const measured_quantity& q : report.quantities) {
    for (const measured_method& m : q.methods) {
      for (const measurement& x : m.points) {
        result += csv_of(q.what->name, m.what->name, m.what->certified, "", x);
      }
      for (const long n : m.left_out) {
        result += csv_of_left_out(q.what->name, m.what->name, m.what->certified, "", n);
      }
    }
  }
  for (const measured_family& f : report.families) {
    for (const auto& m : f.methods) {
      for (const auto& [k, x] : m.points) {
        result += csv_of("hard " + f.what->name, m.name, m.certified, std::to_string(k), x);
      }
      for (const long k : m.left_out) {
        result += csv_of_left_out("hard " + f.what->name, m.name, m.certified, std::to_string(k),
                                  f.digits);
      }
    }
  }
  return result;
}

std::string as_json(const cost_report& report) {
  cost_json result{{"quantities", cost_json::array()}, {"hard", cost_json::array()}};
  for (const measured_quantity& q : report.quantities) {
    cost_json one{{"name", q.what->name},
                  {"description", q.what->description},
                  {"methods", cost_json::array()}};
    for (const measured_method& m : q.methods) {
      cost_json points = cost_json::array();
      for (const measurement& x : m.points) points.push_back(json_of(x));
      one["methods"].push_back(
          {{"name", m.what->name},
           {"description", m.what->description},
           {"certified", m.what->certified},
           {"growth_exponent", number_or_null(cost::growth_exponent(m.points))},
           {"points", std::move(points)},
           {"left_out", m.left_out}});
    }
    result["quantities"].push_back(std::move(one));
  }
  for (const measured_family& f : report.families) {
    cost_json one{{"name", f.what->name},
                  {"description", f.what->description},
                  {"methods", cost_json::array()}};
    for (const auto& m : f.methods) {
      cost_json points = cost_json::array();
      for (const auto& [k, x] : m.points) {
        cost_json point = json_of(x);
        point["k"] = k;
        points.push_back(std::move(point));
      }
      one["methods"].push_back({{"name", m.name},
                                {"certified", m.certified},
                                {"points", std::move(points)},
                                {"left_out", m.left_out}});
    }
    result["hard"].push_back(std::move(one));
  }
  return json_document_text("cost", result);
}

std::vector<cost_picture> pictures_of(const cost_report& report) {
  std::vector<cost_picture> result;
  result.reserve(report.quantities.size() + report.families.size() + 2);
  for (const measured_quantity& q : report.quantities) result.push_back(picture_of(q));
  for (const measured_family& f : report.families) result.push_back(picture_of(f));
  const bool has_pair = std::any_of(report.quantities.begin(), report.quantities.end(),
                                    [](const auto& q) { return !pairs_of(q).empty(); });
  if (has_pair) result.push_back(certainty(report));
  result.push_back(cold(report));
  return result;
}

std::vector<std::string> picture_names(const std::vector<const cost::quantity*>& quantities,
                                       const std::vector<const cost::hard_family*>& families) {
  std::vector<std::string> result;
  result.reserve(quantities.size() + families.size() + 2);
  for (const cost::quantity* q : quantities) result.push_back(q->name);
  for (const cost::hard_family* f : families) result.push_back("hard_" + f->name);
  const bool has_pair =
      std::any_of(quantities.begin(), quantities.end(), [](const cost::quantity* q) {
        return std::any_of(q->methods.begin(), q->methods.end(), [](const cost::method& m) {
          constexpr std::string_view floating = ", floating";
          return m.name.size() > floating.size() && m.name.ends_with(floating);
        });
      });
  if (has_pair) result.emplace_back("certainty");
  result.emplace_back("cold");
  return result;
}

}  // namespace polhode::cli
