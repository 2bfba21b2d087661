// Reading a formula. The grammar, in which every operator's actions put the node they make on a
// stack (nothing is tried twice, so no action is ever taken back):
//
//   sum      = product { (+|-) product }
//   product  = signed { (*|/) signed | juxtaposed }
//   signed   = { +|- } power
//   power    = postfix { (^|**) { +|- } postfix }     from the right
//   postfix  = operand { ! | !! }
//   operand  = number | name | name ( sum { , sum } ) | ( sum )
//
// A juxtaposed factor is a power that begins with a name or a parenthesis and stands right behind a
// number: 2x is 2*x. Behind a divisor or an exponent it is refused, where people read it in two
// ways: 1/2x, 2^3x.
//
// Only parentheses recurse, and their depth is limited before the grammar sees the text.

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdlib>

#include <boost/spirit/home/x3.hpp>

#include "base/nearest_name.hpp"
#include "calls.hpp"
#include "foreign_names.hpp"
#include "graph.hpp"
#include "plain_characters.hpp"

namespace polhode::detail {
namespace {

namespace x3 = boost::spirit::x3;

using iterator = std::string_view::const_iterator;
using range = boost::iterator_range<iterator>;
using name_table = std::map<std::string, node_id, std::less<>>;

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

std::string quoted(std::string_view text) {
  constexpr std::size_t most = 40;
  if (text.size() <= most) return '"' + std::string(text) + '"';
  return '"' + std::string(text.substr(0, most)) + "...\"";
}

bool is_hexadecimal(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

constexpr const char* operand_wanted = "a number, a name or a parenthesis";

// ---------------------------------------------------------------------------------------------
// What the actions do

class reader {
 public:
  reader(graph& g, std::string_view text, const name_table& names)
      : graph_(g), text_(text), names_(names) {}

  [[nodiscard]] node_id result() const { return values_.back(); }
  [[nodiscard]] std::size_t column(iterator where) const {
    return static_cast<std::size_t>(where - text_.begin()) + 1;
  }

  void number(const range& where) {
    const std::string_view text = view(where);
    end_of_number_ = where.end();
    start_of_number_ = where.begin();
    refuse_other_notations(where);
    const auto mark = text.find_first_of("eE");
    const std::string_view mantissa = text.substr(0, mark);
    try {
      if (mark == std::string_view::npos) return push(graph_.number(parse_rational(text)));
      const long exponent = exponent_of_ten(text.substr(mark + 1), where.begin());
      if (std::labs(exponent) <= longest_exact_exponent) {
        return push(graph_.number(parse_rational(text)));
      }
      const node_id digits = graph_.number(parse_rational(mantissa));
      const rational* q = graph_.value(digits);
      if (*q == 0) return push(digits);
      push(multiply(graph_, digits, power(graph_, graph_.number(10), graph_.number(exponent))));
    } catch (const expression_error&) {
      throw;
    } catch (const input_error& error) {
      throw expression_error(column(where.begin()), error.what());
    }
  }

  void name(const range& where) { called_.push_back({where, 0}); }
  void plain_name() {
    const std::string_view given = view(called_.back().name);
    const std::size_t where = column(called_.back().name.begin());
    called_.pop_back();
    if (const auto known = names_.find(given); known != names_.end()) return push(known->second);
    if (const constant_row* constant = find_constant(given)) return push(constant->build(graph_));
    if (const function_row* function = find_function(given)) {
      throw expression_error(where, function->what.name + " is a function: write " +
                                        function->what.name + "(" + function->what.arguments + ")");
    }
    if (has_further(further(), given)) {
      throw expression_error(where, further_usage(given, " is a function: write "));
    }
    if (is_infinity(given)) {
      throw expression_error(where, quoted(given) + " is no number: infinity is for limits alone");
    }
    throw expression_error(where, "there is no " + quoted(given) +
                                      suggestion("; the nearest name is ", given, all_names()));
  }
  void begin_call() {
    called_.back().first_argument = values_.size();
    const std::string_view given = view(called_.back().name);
    if (find_function(given) != nullptr || has_further(further(), given)) return;
    const std::size_t where = column(called_.back().name.begin());
    if (names_.find(given) != names_.end() || find_constant(given) != nullptr) {
      throw expression_error(where, quoted(given) +
                                        " is no function; a product is written with *, as in " +
                                        std::string(given) + "*(...)");
    }
    const auto here = written_here(given);
    throw expression_error(where,
                           "there is no function " + quoted(given) +
                               (here ? "; it is written " + std::string(*here)
                                     : suggestion("; the nearest is ", given, function_names())));
  }
  /// Whether f(x, y, z) is f(f(x, y), z).
  static bool is_of_any_number(const function_row& function) {
    constexpr std::array<std::string_view, 3> all{"min", "max", "hypot"};
    return std::ranges::find(all, function.what.name) != all.end();
  }
  void end_call() {
    const call last = called_.back();
    called_.pop_back();
    const std::vector<node_id> arguments(
        values_.begin() + static_cast<std::ptrdiff_t>(last.first_argument), values_.end());
    values_.resize(last.first_argument);
    if (find_function(view(last.name)) == nullptr) return end_call_of_further(last.name, arguments);
    const function_row& function = *find_function(view(last.name));
    if (arguments.size() > 2 && is_of_any_number(function)) {
      return push(made(last.name.begin(), [&] {
        node_id result = arguments.front();
        for (std::size_t i = 1; i < arguments.size(); ++i) {
          result = function.build(graph_, {result, arguments[i]});
        }
        return result;
      }));
    }
    if (static_cast<int>(arguments.size()) != function.arity) {
      throw expression_error(column(last.name.begin()),
                             function.what.name + " takes " + std::to_string(function.arity) +
                                 (function.arity == 1 ? " argument" : " arguments") + ", not " +
                                 std::to_string(arguments.size()) + ": write " +
                                 function.what.name + "(" + function.what.arguments + ")" +
                                 (function.what.name == "log" && arguments.size() == 2
                                      ? ", or log(x)/log(b) to the base b"
                                      : ""));
    }
    push(made(last.name.begin(), [&] { return function.build(graph_, arguments); }));
  }

  void sign(const range& where) { signs_.push_back(is_minus(where)); }
  void apply_sign() {
    const bool minus = signs_.back();
    signs_.pop_back();
    if (minus) values_.back() = negate(graph_, values_.back());
  }

  void binary(const range& where) { operators_.push_back({where.begin(), *where.begin()}); }
  /// Whether what stands at `where` is a second factor that a number just before it has without an
  /// operator. Throws expression_error where such a product could be read in two ways.
  [[nodiscard]] bool is_juxtaposed(iterator where) const {
    if (where == text_.end() || (!is_letter(*where) && *where != '(')) return false;
    if (!end_of_number_ || !std::all_of(*end_of_number_, where, is_space)) return false;
    iterator before = start_of_number_;
    while (before != text_.begin() &&
           (is_space(before[-1]) || before[-1] == '+' || before[-1] == '-')) {
      --before;
    }
    if (before == text_.begin()) return true;
    const bool divides = before[-1] == '/';
    const bool is_exponent =
        before[-1] == '^' ||
        (before[-1] == '*' && before - 1 != text_.begin() && before[-2] == '*');
    if (!divides && !is_exponent) return true;
    const std::string number(start_of_number_, *end_of_number_);
    const std::string next = is_letter(*where) ? std::string(name_at(where)) : "(...)";
    const std::string sign = divides ? "/" : "^";
    throw expression_error(column(where), "a product behind " + sign + number +
                                              " needs its *: write " + sign + number + "*" + next +
                                              " or " + sign + "(" + number + "*" + next + ")");
  }
  void juxtaposed(const range& where) { operators_.push_back({where.begin(), '*'}); }
  void apply_binary() {
    const auto [where, sign] = operators_.back();
    operators_.pop_back();
    const node_id right = pop();
    const node_id left = pop();
    push(made(where, [&, sign = sign] {
      switch (sign) {
        case '+':
          return add(graph_, left, right);
        case '-':
          return subtract(graph_, left, right);
        case '*':
          return multiply(graph_, left, right);
        default:
          return divide(graph_, left, right);
      }
    }));
  }

  void factorial(const range& where) {
    if (where.size() > 2) {
      throw expression_error(column(where.begin()),
                             "n! and n!! are read, the factorial and the double factorial; write "
                             "((n!)!)! for a factorial of factorials");
    }
    const node_id operand = pop();
    push(made(where.begin(), [&] {
      return where.size() == 1 ? polhode::detail::factorial(graph_, operand)
                               : polhode::detail::double_factorial(graph_, operand);
    }));
  }

  void begin_power() { towers_.emplace_back(); }
  void raise(const range& where) { towers_.back().push_back({where.begin(), false}); }
  void sign_of_exponent(const range& where) { towers_.back().back().minus = is_minus(where); }
  void end_power() {
    std::vector<floor_of_tower> floors = std::move(towers_.back());
    towers_.pop_back();
    for (; !floors.empty(); floors.pop_back()) {
      const floor_of_tower& floor = floors.back();
      const node_id top = pop();
      const node_id exponent = floor.minus ? negate(graph_, top) : top;
      const node_id base = pop();
      push(made(floor.where, [&] { return power(graph_, base, exponent); }));
    }
  }

  /// Says what stands at `where`, where something else was wanted.
  [[noreturn]] void unexpected(iterator where, const std::string& wanted) const {
    while (where != text_.end() && is_space(*where)) ++where;
    if (where == text_.end()) {
      throw expression_error(column(where), "the formula ends here; expected " + wanted);
    }
    const bool operand = is_letter(*where) || is_digit(*where) || *where == '(' || *where == '.';
    if (operand && wanted != operand_wanted) throw_operator_wanted(where);
    if (*where == ',' && where != text_.begin() && is_digit(where[-1]) &&
        where + 1 != text_.end() && is_digit(where[1])) {
      throw expression_error(column(where),
                             "a decimal point is a point, and digits are written without commas");
    }
    if (*where == '|') throw expression_error(column(where), "an absolute value is written abs(x)");
    throw expression_error(column(where), quoted(std::string_view(&*where, 1)) +
                                              " was not expected; expected " + wanted);
  }

 private:
  struct call {
    range name;
    std::size_t first_argument;  // its place in values_
  };
  struct floor_of_tower {
    iterator where;
    bool minus;
  };
  struct written_operator {
    iterator where;
    char sign;
  };
  static constexpr long longest_exact_exponent = 10'000;

  /// The name that begins there.
  std::string_view name_at(iterator where) const {
    const iterator end =
        std::find_if(where, text_.end(), [](char c) { return !is_letter(c) && !is_digit(c); });
    return text_.substr(static_cast<std::size_t>(where - text_.begin()),
                        static_cast<std::size_t>(end - where));
  }

  /// A number is decimal, in one piece, and its exponent has digits.
  void refuse_other_notations(const range& where) const {
    if (where.end() == text_.end() || !is_letter(*where.end())) return;
    const std::string_view after = name_at(where.end());
    const std::string given = std::string(view(where)) + std::string(after);
    const auto refuse = [&](const std::string& why) {
      throw expression_error(column(where.begin()),
                             quoted(std::string_view(given)) + " is no number: " + why);
    };
    if (after == "e" || after == "E") {
      refuse("an exponent of ten has digits, as in " + std::string(view(where)) +
             "e5; times the number e is " + std::string(view(where)) + "*e");
    }
    if (after.front() == '_') refuse("its digits are written without _");
    if (view(where) != "0" || after.size() < 2 || names_.find(after) != names_.end()) return;
    const std::string_view digits_after = after.substr(1);
    const bool hexadecimal = (after.front() == 'x' || after.front() == 'X') &&
                             std::all_of(digits_after.begin(), digits_after.end(), is_hexadecimal);
    const bool binary = (after.front() == 'b' || after.front() == 'B') &&
                        digits_after.find_first_not_of("01") == std::string_view::npos;
    if (hexadecimal || binary) refuse("numbers are written in decimal");
  }

  /// Two operands without an operator between them: the product that may be meant is shown.
  [[noreturn]] void throw_operator_wanted(iterator where) const {
    constexpr std::size_t most_before = 20;
    iterator end = where;
    while (end != text_.begin() && is_space(end[-1])) --end;
    const auto length = static_cast<std::size_t>(end - text_.begin());
    std::string before(text_.substr(length > most_before ? length - most_before : 0,
                                    std::min(length, most_before)));
    if (length > most_before) before = "..." + before;
    std::string after = *where == '(' ? "(...)" : std::string(name_at(where));
    if (after.empty()) after = *where;
    if (after.size() > most_before) after = after.substr(0, most_before) + "...";
    throw expression_error(
        column(where),
        "expected an operator here; a product is written with *: " + before + "*" + after);
  }

  /// What stands before the nearest name, and that name; empty where no name is near.
  static std::string suggestion(const char* before, std::string_view given,
                                const std::vector<std::string>& known) {
    const std::optional<std::string> near = near_name(given, known);
    return near ? before + *near : "";
  }

  static std::string_view view(const range& r) {
    return r.empty() ? std::string_view() : std::string_view(&*r.begin(), r.size());
  }
  static bool is_minus(const range& signs) {
    return std::count(signs.begin(), signs.end(), '-') % 2 != 0;
  }

  long exponent_of_ten(std::string_view text, iterator where) const {
    if (text.front() == '+') text.remove_prefix(1);
    long result = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result);
    if (error != std::errc() || std::labs(result) > greatest_exponent_of_ten) {
      throw expression_error(column(where), "the exponent of ten is beyond +-" +
                                                std::to_string(greatest_exponent_of_ten));
    }
    return result;
  }

  void push(node_id x) { values_.push_back(x); }
  node_id pop() {
    const node_id x = values_.back();
    values_.pop_back();
    return x;
  }
  /// What f makes, its refusals said of the column.
  template <class F>
  node_id made(iterator where, F&& f) const {
    try {
      return f();
    } catch (const undefined_operation& error) {
      throw expression_error(column(where), error.what());
    }
  }

  [[nodiscard]] const further_functions* further() const { return graph_.further().get(); }
  /// "ellipticE is a function: write ellipticE(m) or ellipticE(phi, m)".
  [[nodiscard]] std::string further_usage(std::string_view name, const std::string& what) const {
    std::string usage;
    for (const further_function& f : *further()) {
      if (f.what.name != name) continue;
      usage += (usage.empty() ? "" : " or ") + f.what.name + "(" + f.what.arguments + ")";
    }
    return std::string(name) + what + usage;
  }
  void end_call_of_further(const range& name, const std::vector<node_id>& arguments) {
    const further_function* function = find_further(further(), view(name), arguments.size());
    if (function == nullptr) {
      throw expression_error(
          column(name.begin()),
          further_usage(view(name), " does not take " + std::to_string(arguments.size()) +
                                        " arguments: write "));
    }
    push(made(name.begin(), [&] { return call_further(graph_, *function, arguments); }));
  }

  [[nodiscard]] std::vector<std::string> function_names() const {
    std::vector<std::string> names;
    for (const function_row& f : function_rows()) names.push_back(f.what.name);
    for (const expression_alias& a : expression_aliases()) {
      if (find_constant(a.name) == nullptr) names.push_back(a.name);
    }
    if (further() != nullptr) {
      for (const further_function& f : *further()) names.push_back(f.what.name);
    }
    return names;
  }
  [[nodiscard]] std::vector<std::string> all_names() const {
    std::vector<std::string> names;
    for (const auto& [name, id] : names_) names.push_back(name);
    for (const constant_row& c : constant_rows()) names.push_back(c.what.name);
    for (const std::string& name : function_names()) names.push_back(name);
    return names;
  }

  graph& graph_;
  std::string_view text_;
  const name_table& names_;
  std::vector<node_id> values_;
  std::vector<call> called_;
  std::vector<bool> signs_;
  std::vector<written_operator> operators_;
  std::optional<iterator> end_of_number_;  // of the number read last
  iterator start_of_number_{};
  std::vector<std::vector<floor_of_tower>> towers_;
};

// ---------------------------------------------------------------------------------------------
// The grammar

struct reader_tag;

/// Actions: a member function of the reader, with the text that was matched or without.
template <auto member>
constexpr auto at =
    [](auto& context) { (x3::get<reader_tag>(context).get().*member)(x3::_attr(context)); };
template <auto member>
constexpr auto then = [](auto& context) { (x3::get<reader_tag>(context).get().*member)(); };

const x3::rule<class sum_rule> sum{"an operator"};
const x3::rule<class signed_rule> signed_power{operand_wanted};
const x3::rule<class postfix_rule> postfix{operand_wanted};

const auto digits = +x3::ascii::digit;
const auto number = x3::lexeme[((digits >> -('.' >> *x3::ascii::digit)) | ('.' >> digits)) >>
                               -(x3::char_("eE") >> -x3::char_("+-") >> digits)];
const auto name = x3::lexeme[(x3::ascii::alpha | '_') >> *(x3::ascii::alnum | '_')];
const auto signs = x3::raw[*x3::char_("+-")];

const auto call = x3::lit('(')[then<&reader::begin_call>] > sum >
                  *(',' > sum) > x3::lit(')') > x3::eps[then<&reader::end_call>];
const auto operand =
    x3::raw[number][at<&reader::number>] |
    (x3::raw[name][at<&reader::name>] >> (call | x3::eps[then<&reader::plain_name>])) |
    ('(' > sum > ')');
const auto postfix_def = operand >> *x3::raw[x3::lexeme[+x3::char_('!')]][at<&reader::factorial>];
const auto power = x3::eps[then<&reader::begin_power>] > postfix >
                   *(x3::raw[x3::lit('^') | "**"][at<&reader::raise>] >
                     signs[at<&reader::sign_of_exponent>] >
                     postfix) > x3::eps[then<&reader::end_power>];
const auto signed_power_def = signs[at<&reader::sign>] > power > x3::eps[then<&reader::apply_sign>];
const auto times = x3::raw[x3::lexeme['*' >> !x3::lit('*')] | '/'];
/// Nothing, before a factor that is juxtaposed.
const auto before_juxtaposed = x3::eps[([](auto& context) {
  const auto& where = x3::_where(context);
  reader& r = x3::get<reader_tag>(context).get();
  x3::_pass(context) = r.is_juxtaposed(where.begin());
  if (x3::_pass(context)) r.juxtaposed({where.begin(), where.begin()});
})];
const auto product = signed_power >> *((times[at<&reader::binary>] | before_juxtaposed) >
                                       signed_power > x3::eps[then<&reader::apply_binary>]);
const auto sum_def = product >> *(x3::raw[x3::char_("+-")][at<&reader::binary>] > product >
                                  x3::eps[then<&reader::apply_binary>]);

BOOST_SPIRIT_DEFINE(sum, signed_power, postfix)

// ---------------------------------------------------------------------------------------------

/// What must not reach the grammar: texts that are too long, too deep, or with control characters.
void check_text(std::string_view text) {
  if (text.size() > longest_expression) {
    throw expression_error(longest_expression + 1,
                           "a formula of " + std::to_string(text.size()) + " characters: at most " +
                               std::to_string(longest_expression) + " are read");
  }
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '(' && ++depth > deepest_expression) {
      throw expression_error(i + 1, "more than " + std::to_string(deepest_expression) +
                                        " parentheses inside each other");
    }
    if (c == ')') --depth;
    if ((c < ' ' || c > '~') && !is_space(c)) throw expression_error(i + 1, foreign_character);
  }
}

node_id read_plain(graph& g, std::string_view text, const name_table& names) {
  check_text(text);
  reader r(g, text, names);
  iterator first = text.begin();
  const iterator last = text.end();
  try {
    const auto grammar = x3::with<reader_tag>(std::ref(r))[sum];
    if (!x3::phrase_parse(first, last, grammar, x3::ascii::space)) {
      r.unexpected(first, operand_wanted);
    }
  } catch (const x3::expectation_failure<iterator>& failure) {
    const std::string wanted = failure.which();
    r.unexpected(failure.where(), wanted == "')'" ? "an operator or \")\"" : operand_wanted);
  }
  if (first != last) r.unexpected(first, "an operator or the end");
  return r.result();
}

}  // namespace

node_id read_expression(graph& g, std::string_view text, const name_table& names) {
  const auto is_ascii = [](char c) { return static_cast<unsigned char>(c) < 0x80; };
  if (text.size() > longest_expression || std::all_of(text.begin(), text.end(), is_ascii)) {
    return read_plain(g, text, names);
  }
  const plain_formula plain = in_plain_characters(text);
  try {
    return read_plain(g, plain.text, names);
  } catch (const expression_error& error) {
    const std::size_t column = plain.columns[std::min(error.column() - 1, plain.text.size())];
    const std::string_view whole = error.what();
    throw expression_error(column, std::string(whole.substr(whole.find(": ") + 2)));
  }
}

}  // namespace polhode::detail
